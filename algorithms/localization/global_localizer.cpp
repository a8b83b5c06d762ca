#include "algorithms/localization/global_localizer.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// Of the log-likelihood of a point, where it is half a cell off in both directions and sigma is a
// cell: (0.5^2 + 0.5^2) / 2.
constexpr double kLatticeLoss = 0.25;

std::vector<Eigen::Vector2d> spread_evenly(const std::vector<Eigen::Vector2d>& points,
                                           std::size_t at_most) {
  if (points.size() <= at_most) return points;
  std::vector<Eigen::Vector2d> result;
  for (std::size_t i = 0; i < at_most; ++i) result.push_back(points[i * points.size() / at_most]);
  return result;
}

LikelihoodField field_of(const std::vector<SurfacePoint>& map,
                         const LikelihoodFieldOptions& options) {
  SurfaceMeans means(options.resolution);
  means.add(map);
  LikelihoodField field(options);
  field.add(means.means());
  return field;
}

}  // namespace

GlobalLocalizer::GlobalLocalizer(const std::vector<SurfacePoint>& map,
                                 const std::vector<Pose2>& path,
                                 const RelocalizationOptions& options)
    : options_(options),
      rival_margin_(std::log(options.min_odds) / options.beam_weight),
      field_(field_of(map, options.field)) {
  CHECK(!path.empty() && options.beam_weight > 0.0);
  Eigen::Vector2d low = path.front().position(), high = low;
  for (const Pose2& pose : path) {
    low = low.cwiseMin(pose.position());
    high = high.cwiseMax(pose.position());
  }
  const Eigen::Vector2d centre = 0.5 * (low + high);
  centre_ = {centre.x(), centre.y(), 0.0};
  window_ = 0.5 * (high - low).maxCoeff() + options.beyond_path;
  pyramid_ = make_bound_pyramid(field_, window_);
}

bool GlobalLocalizer::is_same_place(const Pose2& a, const Pose2& b) const {
  return distance(a, b) <= options_.rival_distance &&
         std::abs(angle_difference(a.theta, b.theta)) <= options_.rival_turn;
}

std::optional<Pose2> GlobalLocalizer::matched_at(const Pose2& place,
                                                 const std::vector<Eigen::Vector2d>& points) const {
  const ScanMatch match =
      match_scan_from(place, to_field_points(points, field_.resolution()), field_, {.mean = place});
  if (match.inlier_ratio < options_.min_inlier_ratio) return {};
  return match.map_from_robot;
}

FieldPoints GlobalLocalizer::in_cells(const std::vector<Eigen::Vector2d>& points) const {
  return to_field_points(spread_evenly(points, static_cast<std::size_t>(options_.max_points)),
                         field_.resolution());
}

GlobalLocalizer::Answer GlobalLocalizer::look_here(const std::vector<Eigen::Vector2d>& points,
                                                   const Pose2& here) const {
  if (points.empty()) return {};
  const ScanMatch stayed = match_scan(in_cells(points), field_, {.mean = here});
  return {.confirmed = stayed.inlier_ratio >= options_.min_inlier_ratio,
          .relocated_to = {},
          .plausible = stayed.trustworthy};
}

GlobalLocalizer::Answer GlobalLocalizer::find(const std::vector<Eigen::Vector2d>& points,
                                              const Pose2& here) const {
  if (points.empty()) return {};
  const FieldPoints in_cells = this->in_cells(points);
  const auto count = static_cast<double>(in_cells.size());
  const PosePrior anywhere{.mean = centre_};
  const CorrelativeMatcherOptions lattice{.window = window_, .turn_window = kPi};
  // The lattice misses an optimum by half a cell and half a turn step, which moves a point by up
  // to half a cell each way.
  const double lattice_loss = kLatticeLoss * count;
  const auto max_blocks = static_cast<std::size_t>(options_.max_blocks);

  const ScanMatch stayed = match_scan(in_cells, field_, {.mean = here});
  Answer answer{.confirmed = stayed.inlier_ratio >= options_.min_inlier_ratio,
                .relocated_to = {},
                .plausible = stayed.trustworthy};
  // What explains too little, or is not clearly better than to stay, is not looked at.
  const double least = (1.0 - options_.min_inlier_ratio) * double{field_.outlier_log()} * count;
  const double worth = answer.confirmed ? stayed.log_likelihood + rival_margin_ : least;
  const LimitedSearch found =
      best_match_within(in_cells, field_, pyramid_, anywhere, lattice,
                        {.above = worth - lattice_loss, .max_blocks = max_blocks});
  answer.complete = found.complete;
  if (!found.match || !found.complete) return answer;
  const ScanMatch best = match_scan_from(found.match->map_from_robot, in_cells, field_, anywhere);
  if (best.log_likelihood < worth) return answer;
  answer.confirmed = is_same_place(best.map_from_robot, here);
  if (answer.confirmed) return answer;

  const double near_best = best.log_likelihood - rival_margin_;
  const LimitedSearch rival = best_match_within(in_cells, field_, pyramid_, anywhere, lattice,
                                                {.above = near_best - lattice_loss,
                                                 .enough = near_best,
                                                 .away_from = best.map_from_robot,
                                                 .distance = options_.rival_distance,
                                                 .turn = options_.rival_turn,
                                                 .max_blocks = max_blocks});
  answer.complete = rival.complete;
  const bool rivalled =
      !rival.complete ||
      (rival.match &&
       match_scan_from(rival.match->map_from_robot, in_cells, field_, anywhere).log_likelihood >=
           near_best);
  if (!rivalled) answer.relocated_to = best.map_from_robot;
  return answer;
}

}  // namespace mapbed
