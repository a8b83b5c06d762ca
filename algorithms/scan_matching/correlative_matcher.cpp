#include "algorithms/scan_matching/correlative_matcher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "core/check.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

constexpr double kMostTurns = 10'000;  // to either side

// The lattice that is searched: turns about the prediction, then shifts by whole cells.
struct Lattice {
  int shifts = 0;  // -shifts … shifts [cells]
  int turns = 0;   // -turns … turns
  double turn_step = 0.0;
};

Lattice lattice_of(const FieldPoints& points, double resolution,
                   const CorrelativeMatcherOptions& options) {
  Lattice lattice;
  lattice.shifts = static_cast<int>(std::ceil(options.window / resolution - 1e-9));
  lattice.turn_step = options.turn_step;
  if (lattice.turn_step <= 0.0) {
    std::vector<float> distances(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      distances[i] = std::hypot(points.x[i], points.y[i]);
    }
    lattice.turn_step = 1.0 / std::max(1.0, double{quantile_of(std::move(distances), 0.9)});
  }
  const double turns = std::ceil(options.turn_window / lattice.turn_step - 1e-9);
  if (!(turns <= kMostTurns)) {
    throw InputError(
        fmt::format("a search over {:g} rad in turns of {:g} rad tries too many of them; "
                    "choose a larger turn_step or a smaller turn_window",
                    options.turn_window, lattice.turn_step));
  }
  lattice.turns = static_cast<int>(turns);
  return lattice;
}

Pose2 pose_on(const Lattice& lattice, const Pose2& center, double resolution, int turn, int x,
              int y) {
  return {center.x + x * resolution, center.y + y * resolution,
          normalized_angle(center.theta + turn * lattice.turn_step)};
}

// The prior's upper bound over all poses with a heading and a position in a rectangle: the headings
// alone, the best position given, plus the distance from it to the rectangle in the flattest
// direction.
class PriorBound {
 public:
  PriorBound(const Pose2& mean, const Eigen::Matrix3d& information) : mean_(mean) {
    const Eigen::Matrix2d position = information.topLeftCorner<2, 2>();
    const Eigen::Vector2d mixed = information.topRightCorner<2, 1>();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(position);
    flattest_ = std::max(0.0, solver.eigenvalues()[0]);
    if (flattest_ <= 0.0) return;
    offset_per_radian_ = -position.inverse() * mixed;
    heading_ = std::max(0.0, information(2, 2) + mixed.dot(offset_per_radian_));
  }

  double over(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double theta) const {
    if (flattest_ <= 0.0) return 0.0;
    const double error = angle_difference(mean_.theta, theta);
    const Eigen::Vector2d best = mean_ * (offset_per_radian_ * error).eval();
    const Eigen::Vector2d outside =
        (low - best).cwiseMax(best - high).cwiseMax(Eigen::Vector2d::Zero());
    return -0.5 * (heading_ * error * error + flattest_ * outside.squaredNorm());
  }

 private:
  Pose2 mean_;
  double flattest_ = 0.0;
  double heading_ = 0.0;
  Eigen::Vector2d offset_per_radian_ = Eigen::Vector2d::Zero();
};

// A square of 2^level x 2^level shifts at one turn.
struct Block {
  double bound;
  int turn, x, y;
};

class CorrelativeSearch {
 public:
  CorrelativeSearch(const FieldPoints& points, const LikelihoodField& map,
                    const BoundPyramid& pyramid, const PosePrior& prediction,
                    const Lattice& lattice, const SearchLimits& limits)
      : points_(points),
        map_(map),
        pyramid_(pyramid),
        prediction_(prediction),
        prior_bound_(prediction.mean, prediction.information),
        tail_bound_(prediction.mean, prediction.tail),
        tail_log_(prediction.tail_log),
        lattice_(lattice),
        limits_(limits),
        floor_(double{map.outlier_log()} * points.total_weight()),
        best_(limits.above) {
    for (int turn = -lattice.turns; turn <= lattice.turns; ++turn) rotate(turn);
  }

  // The best pose of the lattice within the limits.
  std::optional<Pose2> search() {
    std::vector<Block> blocks = coarsest_blocks();
    std::sort(blocks.begin(), blocks.end(),
              [](const Block& a, const Block& b) { return a.bound > b.bound; });
    const int level = static_cast<int>(pyramid_.levels.size()) - 1;
    for (const Block& block : blocks) {
      if (block.bound <= best_ || over()) break;
      branch(block, level);
    }
    return best_pose_;
  }

  bool gave_up() const { return limits_.max_blocks > 0 && looked_at_ >= limits_.max_blocks; }

 private:
  bool over() const { return best_ >= limits_.enough || gave_up(); }

  // Where the points fall, turned and unshifted: the cells whose centres lie left of and below
  // them, as indices into the pyramid's levels. Points that no shift brings into the map are left
  // out.
  void rotate(int turn) {
    const Pose2 pose = pose_on(lattice_, prediction_.mean, map_.resolution(), turn, 0, 0);
    const double c = std::cos(pose.theta), s = std::sin(pose.theta);
    const double tx = pose.x / map_.resolution(), ty = pose.y / map_.resolution();
    const int reach = lattice_.shifts + 1;
    std::vector<std::int32_t> cells;
    std::vector<float> weights;
    cells.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double px = double{points_.x[i]}, py = double{points_.y[i]};
      const int x = static_cast<int>(std::floor(c * px - s * py + tx));
      const int y = static_cast<int>(std::floor(s * px + c * py + ty));
      const bool reachable = x >= pyramid_.box.min.x - reach && x <= pyramid_.box.max.x + reach &&
                             y >= pyramid_.box.min.y - reach && y <= pyramid_.box.max.y + reach;
      if (!reachable) continue;
      cells.push_back((y - pyramid_.min_y) * pyramid_.width + (x - pyramid_.min_x));
      if (!points_.weights.empty()) weights.push_back(points_.weights[i]);
    }
    rotated_.push_back(std::move(cells));
    rotated_weights_.push_back(std::move(weights));
  }

  std::vector<Block> coarsest_blocks() {
    const int level = static_cast<int>(pyramid_.levels.size()) - 1;
    std::vector<Block> blocks;
    for (int turn = -lattice_.turns; turn <= lattice_.turns; ++turn) {
      for (int y = -lattice_.shifts; y <= lattice_.shifts; y += 1 << level) {
        for (int x = -lattice_.shifts; x <= lattice_.shifts; x += 1 << level) {
          blocks.push_back({bound_of(turn, x, y, level), turn, x, y});
        }
      }
    }
    return blocks;
  }

  double bound_of(int turn, int x, int y, int level) {
    ++looked_at_;
    const std::vector<std::int32_t>& cells =
        rotated_[static_cast<std::size_t>(turn + lattice_.turns)];
    const std::uint8_t* bounds = pyramid_.levels[static_cast<std::size_t>(level)].data() +
                                 std::ptrdiff_t{y} * pyramid_.width + x;
    const double sum = sum_of(bounds, cells, turn);
    const Pose2 low = pose_on(lattice_, prediction_.mean, map_.resolution(), turn, x, y);
    const double side = ((1 << level) - 1) * map_.resolution();
    const Eigen::Vector2d corner = low.position(), opposite = corner + Eigen::Vector2d(side, side);
    return floor_ + sum * pyramid_.step +
           std::max(prior_bound_.over(corner, opposite, low.theta),
                    tail_log_ + tail_bound_.over(corner, opposite, low.theta));
  }

  double sum_of(const std::uint8_t* bounds, const std::vector<std::int32_t>& cells,
                int turn) const {
    if (points_.weights.empty()) {
      int sum = 0;
      for (const std::int32_t cell : cells) sum += bounds[cell];
      return sum;
    }
    const std::vector<float>& weights =
        rotated_weights_[static_cast<std::size_t>(turn + lattice_.turns)];
    double sum = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) sum += double{weights[i]} * bounds[cells[i]];
    return sum;
  }

  void branch(const Block& block, int level) {
    if (level == 0) {
      ++looked_at_;
      const Pose2 pose =
          pose_on(lattice_, prediction_.mean, map_.resolution(), block.turn, block.x, block.y);
      const double value = map_.sum_log_at(points_, pose) + prediction_.log_at(pose);
      if (value <= best_ || limits_.exclude(pose)) return;
      best_ = value;
      best_pose_ = pose;
      return;
    }
    const int half = 1 << (level - 1);
    std::array<Block, 4> children;
    std::size_t count = 0;
    for (const int y : {block.y, block.y + half}) {
      for (const int x : {block.x, block.x + half}) {
        if (x > lattice_.shifts || y > lattice_.shifts) continue;
        children[count++] = {bound_of(block.turn, x, y, level - 1), block.turn, x, y};
      }
    }
    for (std::size_t i = 1; i < count; ++i) {  // best bound first
      for (std::size_t j = i; j > 0 && children[j].bound > children[j - 1].bound; --j) {
        std::swap(children[j], children[j - 1]);
      }
    }
    for (std::size_t i = 0; i < count && children[i].bound > best_ && !over(); ++i) {
      branch(children[i], level - 1);
    }
  }

  const FieldPoints& points_;
  const LikelihoodField& map_;
  const BoundPyramid& pyramid_;
  const PosePrior& prediction_;
  PriorBound prior_bound_, tail_bound_;
  double tail_log_;
  Lattice lattice_;
  const SearchLimits& limits_;
  double floor_;
  std::vector<std::vector<std::int32_t>> rotated_;   // by turn
  std::vector<std::vector<float>> rotated_weights_;  // of the same points, where they have any
  double best_;
  std::optional<Pose2> best_pose_;
  std::size_t looked_at_ = 0;  // blocks, and poses
};

ScanMatch match_at(const Pose2& pose, const FieldPoints& points, const LikelihoodField& map,
                   const PosePrior& prediction, double min_inlier_ratio) {
  ScanMatch match{.map_from_robot = pose, .points_used = static_cast<int>(points.size())};
  match.log_likelihood = map.sum_log_at(points, pose);
  match.log_posterior = match.log_likelihood + prediction.log_at(pose);
  match.inlier_ratio =
      inlier_ratio(match.log_likelihood, double{map.outlier_log()} * points.total_weight());
  match.trustworthy = match.inlier_ratio >= min_inlier_ratio;
  return match;
}

}  // namespace

bool SearchLimits::exclude(const Pose2& pose) const {
  return away_from && mapbed::distance(pose, *away_from) <= distance &&
         std::abs(angle_difference(pose.theta, away_from->theta)) <= turn;
}

LimitedSearch best_match_within(const FieldPoints& points, const LikelihoodField& map,
                                const BoundPyramid& pyramid, const PosePrior& prediction,
                                const CorrelativeMatcherOptions& options,
                                const SearchLimits& limits) {
  CHECK(options.window >= 0.0 && options.turn_window >= 0.0 && !pyramid.levels.empty());
  if (points.size() == 0) return {};
  const Lattice lattice = lattice_of(points, map.resolution(), options);
  CHECK(lattice.shifts <= pyramid.max_shifts);
  CorrelativeSearch search(points, map, pyramid, prediction, lattice, limits);
  const std::optional<Pose2> best = search.search();
  LimitedSearch result{.match = {}, .complete = !search.gave_up()};
  if (best) result.match = match_at(*best, points, map, prediction, options.min_inlier_ratio);
  return result;
}

ScanMatch match_correlative(const FieldPoints& points, const LikelihoodField& map,
                            const BoundPyramid& pyramid, const PosePrior& prediction,
                            const CorrelativeMatcherOptions& options) {
  return best_match_within(points, map, pyramid, prediction, options, {})
      .match.value_or(ScanMatch{.map_from_robot = prediction.mean});
}

ScanMatch match_exhaustive(const FieldPoints& points, const LikelihoodField& map,
                           const PosePrior& prediction, const CorrelativeMatcherOptions& options) {
  if (points.size() == 0) return {.map_from_robot = prediction.mean};
  const Lattice lattice = lattice_of(points, map.resolution(), options);
  Pose2 best;
  double best_value = -1e300;
  for (int turn = -lattice.turns; turn <= lattice.turns; ++turn) {
    for (int y = -lattice.shifts; y <= lattice.shifts; ++y) {
      for (int x = -lattice.shifts; x <= lattice.shifts; ++x) {
        const Pose2 pose = pose_on(lattice, prediction.mean, map.resolution(), turn, x, y);
        const double value = map.sum_log_at(points, pose) + prediction.log_at(pose);
        if (value <= best_value) continue;
        best_value = value;
        best = pose;
      }
    }
  }
  return match_at(best, points, map, prediction, options.min_inlier_ratio);
}

}  // namespace mapbed
