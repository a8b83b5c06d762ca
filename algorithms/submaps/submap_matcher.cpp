#include "algorithms/submaps/submap_matcher.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "algorithms/field/likelihood_slope.h"
#include "algorithms/scan_matching/correlative_matcher.h"

namespace mapbed {
namespace {

// Of the log-likelihood of a point that the lattice leaves half a cell off in both directions.
constexpr double kLatticeLoss = 0.25;
constexpr double kOnSurface = 0.5;  // of the way from a surface's log-likelihood to an outlier's
constexpr double kPointsTogether = 10.0;  // that err alike

std::vector<Eigen::Vector2d> spread_evenly(const std::vector<SurfacePoint>& points, int at_most) {
  const auto count = std::min(points.size(), static_cast<std::size_t>(at_most));
  std::vector<Eigen::Vector2d> result;
  result.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(points[i * points.size() / count].position);
  }
  return result;
}

// Points of one local map in the other.
void compare(const Submap& seer, const LikelihoodField& field, const Submap& seen,
             const Pose2& seer_from_seen, int at_most, Agreement& agreement) {
  const std::vector<PointMotion> robots_from_seer = robots_from(seer);
  const PointMotion motion(seer_from_seen);
  for (const Eigen::Vector2d& point_in_seen : spread_evenly(seen.surface, at_most)) {
    const Eigen::Vector2d point = motion * point_in_seen;
    if (field.log_at(point) > kOnSurface * double{field.outlier_log()}) {
      agreement.matched += 1.0;
    } else if (seen_in(seer, robots_from_seer, point) != Seen::nothing) {
      agreement.contradicted += 1.0;
    } else {
      agreement.unseen += 1.0;
    }
  }
}

// Those that lie on the line of a surface: where none is known, a point says less than it seems.
FieldPoints on_lines(const FieldPoints& points, const LikelihoodField& field, const Pose2& pose) {
  FieldPoints result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d point(double{points.x[i]}, double{points.y[i]});
    const auto surface = field.surface_at(pose * (point * field.resolution()));
    if (!surface || surface->along.isZero()) continue;
    result.x.push_back(points.x[i]);
    result.y.push_back(points.y[i]);
  }
  return result;
}

// Of a match, by how the likelihood curves about it; neighbouring points err alike, and nothing is
// known worse than by the window that was searched.
Eigen::Matrix3d covariance_of(const Pose2& optimum, const FieldPoints& points,
                              const LikelihoodField& field, double window, double turn_window,
                              const SubmapMatcherOptions& options) {
  Eigen::Matrix3d information =
      likelihood_slope(points, 0, points.size(), field, optimum).curvature / kPointsTogether;
  information.diagonal() += Eigen::Vector3d(1.0 / (window * window), 1.0 / (window * window),
                                            1.0 / (turn_window * turn_window));
  Eigen::Matrix3d covariance = information.inverse();
  covariance.diagonal() += Eigen::Vector3d(options.least_sigma * options.least_sigma,
                                           options.least_sigma * options.least_sigma,
                                           options.least_turn_sigma * options.least_turn_sigma);
  return covariance;
}

}  // namespace

Agreement agreement(const Submap& target, const LikelihoodField& target_field, const Submap& query,
                    const LikelihoodField& query_field, const Pose2& target_from_query,
                    const SubmapMatcherOptions& options) {
  Agreement both;
  compare(target, target_field, query, target_from_query, options.compared_points, both);
  compare(query, query_field, target, inverse(target_from_query), options.compared_points, both);
  return both;
}

std::optional<SubmapMatch> match_submaps(const Submap& target, const SubmapField& target_field,
                                         const Submap& query, const SubmapField& query_field,
                                         const Pose2& predicted, double window, double turn_window,
                                         const SubmapMatcherOptions& options, Rivals rivals) {
  const LikelihoodField& field = target_field.field;
  const FieldPoints points =
      to_field_points(spread_evenly(query.surface, options.search_points), field.resolution());
  if (points.size() == 0) return {};
  const auto count = static_cast<double>(points.size());
  const PosePrior anywhere{.mean = predicted};
  const CorrelativeMatcherOptions lattice{.window = window, .turn_window = turn_window};
  const double lattice_loss = kLatticeLoss * count;
  const double outlier = double{field.outlier_log()};
  const bool is_far = window > options.far_window;
  const double min_agreement = is_far ? options.min_agreement_far : options.min_agreement;
  const double min_overlap = is_far ? options.min_overlap_far : options.min_overlap;
  // Less than this cannot agree enough with the least overlap.
  const double least = (1.0 - min_overlap * min_agreement) * outlier * count;
  const auto max_blocks = static_cast<std::size_t>(options.max_blocks);
  const LimitedSearch found =
      best_match_within(points, field, target_field.pyramid, anywhere, lattice,
                        {.above = least - lattice_loss, .max_blocks = max_blocks});
  if (!found.match) return {};
  const ScanMatch best = match_scan_from(found.match->map_from_robot, points, field, anywhere);
  SubmapMatch match{
      .target_from_query = best.map_from_robot,
      .agreement = agreement(target, field, query, query_field.field, best.map_from_robot, options),
      .log_likelihood = best.log_likelihood,
      .complete = found.complete};
  if (match.agreement.ratio() < min_agreement || match.agreement.overlap() < min_overlap) {
    return {};
  }
  match.covariance =
      covariance_of(best.map_from_robot, on_lines(points, field, best.map_from_robot), field,
                    window, turn_window, options);
  match.is_unique = match.complete;
  if (rivals == Rivals::ignored || !match.complete) return match;
  const double near_best = best.log_likelihood - std::log(options.min_odds) / options.beam_weight;
  const LimitedSearch rival =
      best_match_within(points, field, target_field.pyramid, anywhere, lattice,
                        {.above = near_best - lattice_loss,
                         .enough = near_best,
                         .away_from = best.map_from_robot,
                         .distance = options.rival_distance,
                         .turn = options.rival_turn,
                         .max_blocks = max_blocks});
  match.complete = rival.complete;
  match.is_unique =
      match.complete &&
      !(rival.match &&
        match_scan_from(rival.match->map_from_robot, points, field, anywhere).log_likelihood >=
            near_best);
  return match;
}

}  // namespace mapbed
