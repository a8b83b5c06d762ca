#include "algorithms/scan_matching/correlative_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

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

// 2^level x 2^level shifts at 2^group_bits(level) turns.
struct Block {
  double bound;
  int turn, x, y;  // the first of them
};

// Turns that are bounded together. In a large window most headings fit nowhere near; in a small one
// each turn is bounded by itself.
int group_bits(int level) {
  return level > 3 ? level - 2 : 0;
}

// The points at the middle of a group of turns, in cells of the map: shifted by a block's shifts
// and turned by the group's turns, each falls into the cells from here up to what its level covers.
struct TurnedPoints {
  std::vector<int> x, y;
  std::vector<std::uint8_t> level;  // of the pyramid
  std::vector<float> weights;       // of the same points, where they have any
};

class CorrelativeSearch {
 public:
  CorrelativeSearch(const FieldPoints& points, const LikelihoodField& map,
                    const BoundPyramid& pyramid, const PosePrior& prediction,
                    const SearchLattice& lattice, const SearchLimits& limits)
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
        best_(limits.above),
        top_(static_cast<int>(pyramid.levels.size()) - 2) {
    for (int level = 0; level <= top_; ++level) {
      const int groups = (2 * lattice.turns >> group_bits(level)) + 1;
      turned_.emplace_back(level > 0 && group_bits(level) == 0 ? 0 : groups);
    }
  }

  // The best pose of the lattice within the limits.
  std::optional<Pose2> search() {
    std::vector<Block> blocks = coarsest_blocks();
    std::sort(blocks.begin(), blocks.end(),
              [](const Block& a, const Block& b) { return a.bound > b.bound; });
    for (const Block& block : blocks) {
      if (block.bound <= best_ || over()) break;
      branch(block, top_);
    }
    return best_pose_;
  }

  bool gave_up() const { return limits_.max_blocks > 0 && looked_at_ >= limits_.max_blocks; }

 private:
  bool over() const { return best_ >= limits_.enough || gave_up(); }

  // Made when first needed. Levels of single turns share theirs.
  const TurnedPoints& turned(int first_turn, int level) {
    const int bits = group_bits(level);
    std::optional<TurnedPoints>& made =
        turned_[static_cast<std::size_t>(bits == 0 ? 0 : level)]
               [static_cast<std::size_t>((first_turn + lattice_.turns) >> bits)];
    if (!made) made = turn(first_turn, level);
    return *made;
  }

  // Points that no shift brings into the map are left out.
  TurnedPoints turn(int first_turn, int level) const {
    const int last = (1 << group_bits(level)) - 1;  // turn of the group, from the first
    const Pose2& mean = prediction_.mean;
    const double theta = mean.theta + (first_turn + 0.5 * last) * lattice_.turn_step;
    const double c = std::cos(normalized_angle(theta)), s = std::sin(normalized_angle(theta));
    const double tx = mean.x / map_.resolution(), ty = mean.y / map_.resolution();
    TurnedPoints turned;
    turned.x.reserve(points_.size());
    turned.y.reserve(points_.size());
    turned.level.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double px = double{points_.x[i]}, py = double{points_.y[i]};
      // What the turns move it to either side, at most.
      const double moves = 0.5 * last * lattice_.turn_step * std::hypot(px, py);
      const int x = static_cast<int>(std::floor(c * px - s * py + tx - moves));
      const int y = static_cast<int>(std::floor(s * px + c * py + ty - moves));
      const int more = static_cast<int>(std::ceil(2.0 * moves));
      const int reach = lattice_.shifts + 1;
      const bool reachable =
          x + more >= pyramid_.box.min.x - reach && x <= pyramid_.box.max.x + reach &&
          y + more >= pyramid_.box.min.y - reach && y <= pyramid_.box.max.y + reach;
      if (!reachable) continue;
      turned.x.push_back(x);
      turned.y.push_back(y);
      if (last > 0) turned.level.push_back(level_over((1 << level) + more));
      if (!points_.weights.empty()) turned.weights.push_back(points_.weights[i]);
    }
    return turned;
  }

  // The finest one that covers so many cells; kUnbounded where none does.
  std::uint8_t level_over(int cells) const {
    int level = 0;
    while (level < static_cast<int>(pyramid_.levels.size()) && 1 << level < cells) ++level;
    return level < static_cast<int>(pyramid_.levels.size()) ? static_cast<std::uint8_t>(level)
                                                            : kUnbounded;
  }

  std::vector<Block> coarsest_blocks() {
    std::vector<Block> blocks;
    for (int turn = -lattice_.turns; turn <= lattice_.turns; turn += 1 << group_bits(top_)) {
      for (int y = -lattice_.shifts; y <= lattice_.shifts; y += 1 << top_) {
        for (int x = -lattice_.shifts; x <= lattice_.shifts; x += 1 << top_) {
          blocks.push_back({bound_of(turn, x, y, top_), turn, x, y});
        }
      }
    }
    return blocks;
  }

  double bound_of(int turn, int x, int y, int level) {
    ++looked_at_;
    const double sum = points_.weights.empty() ? plain_sum(turned(turn, level), x, y, level)
                                               : weighted_sum(turned(turn, level), x, y, level);
    const double bound = floor_ + sum * pyramid_.step;
    if (group_bits(level) > 0) return bound + std::max(0.0, tail_log_);  // the prior's largest
    const Pose2 low = lattice_.pose(prediction_.mean, map_.resolution(), turn, x, y);
    const double side = ((1 << level) - 1) * map_.resolution();
    const Eigen::Vector2d corner = low.position(), opposite = corner + Eigen::Vector2d(side, side);
    return bound + std::max(prior_bound_.over(corner, opposite, low.theta),
                            tail_log_ + tail_bound_.over(corner, opposite, low.theta));
  }

  double plain_sum(const TurnedPoints& points, int x, int y, int level) const {
    int sum = 0;
    if (points.level.empty()) {
      const BoundPyramid::Level& bounds = pyramid_.levels[static_cast<std::size_t>(level)];
      for (std::size_t i = 0; i < points.x.size(); ++i) {
        sum += bounds.at(points.x[i] + x, points.y[i] + y);
      }
    } else {
      for (std::size_t i = 0; i < points.x.size(); ++i) sum += bound_at(points, i, x, y);
    }
    return sum;
  }

  double weighted_sum(const TurnedPoints& points, int x, int y, int level) const {
    const BoundPyramid::Level& bounds = pyramid_.levels[static_cast<std::size_t>(level)];
    double sum = 0.0;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      const int bound = points.level.empty() ? bounds.at(points.x[i] + x, points.y[i] + y)
                                             : bound_at(points, i, x, y);
      sum += double{points.weights[i]} * bound;
    }
    return sum;
  }

  // Of a point of a group of turns.
  int bound_at(const TurnedPoints& points, std::size_t i, int x, int y) const {
    if (points.level[i] == kUnbounded) return 255;
    return pyramid_.levels[points.level[i]].at(points.x[i] + x, points.y[i] + y);
  }

  void branch(const Block& block, int level) {
    if (level == 0) {
      ++looked_at_;
      const Pose2 pose =
          lattice_.pose(prediction_.mean, map_.resolution(), block.turn, block.x, block.y);
      const double value = map_.sum_log_at(points_, pose) + prediction_.log_at(pose);
      if (value <= best_ || limits_.exclude(pose)) return;
      best_ = value;
      best_pose_ = pose;
      return;
    }
    const int half = 1 << (level - 1);
    const int last_turn = std::min(lattice_.turns, block.turn + (1 << group_bits(level)) - 1);
    std::array<Block, 16> children;
    std::size_t count = 0;
    for (int turn = block.turn; turn <= last_turn; turn += 1 << group_bits(level - 1)) {
      for (const int y : {block.y, block.y + half}) {
        for (const int x : {block.x, block.x + half}) {
          if (x > lattice_.shifts || y > lattice_.shifts) continue;
          children[count++] = {bound_of(turn, x, y, level - 1), turn, x, y};
        }
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

  static constexpr std::uint8_t kUnbounded = 255;

  const FieldPoints& points_;
  const LikelihoodField& map_;
  const BoundPyramid& pyramid_;
  const PosePrior& prediction_;
  PriorBound prior_bound_, tail_bound_;
  double tail_log_;
  SearchLattice lattice_;
  const SearchLimits& limits_;
  double floor_;
  double best_;
  int top_;                                                       // level of the coarsest blocks
  std::vector<std::vector<std::optional<TurnedPoints>>> turned_;  // by level, by group of turns
  std::optional<Pose2> best_pose_;
  std::size_t looked_at_ = 0;  // blocks, and poses
};

}  // namespace

LatticeOptimum search_lattice(const FieldPoints& points, const LikelihoodField& map,
                              const BoundPyramid& pyramid, const PosePrior& prediction,
                              const SearchLattice& lattice, const SearchLimits& limits) {
  CorrelativeSearch search(points, map, pyramid, prediction, lattice, limits);
  const std::optional<Pose2> best = search.search();
  return {best, !search.gave_up()};
}

}  // namespace mapbed
