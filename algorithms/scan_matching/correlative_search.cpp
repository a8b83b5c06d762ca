#include "algorithms/scan_matching/correlative_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "algorithms/field/bound_sums.h"
#include "algorithms/scan_matching/turned_points.h"
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

  struct AtHeading {
    Eigen::Vector2d best = Eigen::Vector2d::Zero();  // position [m]
    double of_heading = 0.0;                         // times -2
    double flattest = 0.0;

    double over(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
      if (flattest <= 0.0) return 0.0;
      const Eigen::Vector2d outside =
          (low - best).cwiseMax(best - high).cwiseMax(Eigen::Vector2d::Zero());
      return -0.5 * (of_heading + flattest * outside.squaredNorm());
    }
  };
  AtHeading at(double theta) const {
    if (flattest_ <= 0.0) return {};
    const double error = angle_difference(mean_.theta, theta);
    return {mean_ * (offset_per_radian_ * error).eval(), heading_ * error * error, flattest_};
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

// What the blocks of a group of turns have in common.
struct Turns {
  TurnedPoints points;
  double theta = 0.0;                 // [rad] of the first turn
  PriorBound::AtHeading prior, tail;  // of a single turn
};

// The quarters of a block, at up to four groups of turns.
struct Children {
  std::array<Block, 16> blocks;
  std::size_t count = 0;
  void push_back(const Block& block) { blocks[count++] = block; }
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
        top_(static_cast<int>(pyramid.levels.size()) - 2),
        turner_(points, prediction.mean, map.resolution(), pyramid, lattice, group_bits(top_)) {
    for (int level = 0; level <= top_; ++level) {
      const int groups = (2 * lattice.turns >> group_bits(level)) + 1;
      turns_.emplace_back(level > 0 && group_bits(level) == 0 ? 0 : groups);
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
  const Turns& turns_from(int first, int level) {
    const int bits = group_bits(level);
    std::optional<Turns>& made = turns_[static_cast<std::size_t>(bits == 0 ? 0 : level)]
                                       [static_cast<std::size_t>((first + lattice_.turns) >> bits)];
    if (made) return *made;
    made.emplace();
    made->points = turner_.turned({first, bits, level});
    if (points_.weights.empty()) sort_by_level(made->points.cells);
    made->theta = lattice_.pose(prediction_.mean, map_.resolution(), first, 0, 0).theta;
    if (bits > 0) return *made;
    made->prior = prior_bound_.at(made->theta);
    made->tail = tail_bound_.at(made->theta);
    return *made;
  }

  std::vector<Block> coarsest_blocks() {
    const int across = (2 * lattice_.shifts >> top_) + 1;
    std::vector<Block> blocks;
    for (int turn = -lattice_.turns; turn <= lattice_.turns; turn += 1 << group_bits(top_)) {
      add_blocks(turn, {-lattice_.shifts, -lattice_.shifts, top_, across, across}, blocks);
    }
    return blocks;
  }

  // Those of a grid, with their bounds, row by row.
  template <class Blocks>
  void add_blocks(int turn, const BlockGrid& grid, Blocks& blocks) {
    const Turns& turns = turns_from(turn, grid.level);
    looked_at_ += static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
    const bool weighted = !points_.weights.empty();
    if (!weighted) sum_bounds(pyramid_, turns.points.cells, grid, sums_);
    std::size_t i = 0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column, ++i) {
        const int x = grid.x + (column << grid.level), y = grid.y + (row << grid.level);
        const double sum =
            weighted ? weighted_sum(turns.points, x, y, grid.level) : static_cast<double>(sums_[i]);
        blocks.push_back({bound_of(turns, sum, x, y, grid.level), turn, x, y});
      }
    }
  }

  double bound_of(const Turns& turns, double sum, int x, int y, int level) const {
    const double bound = floor_ + sum * pyramid_.step;
    if (group_bits(level) > 0) return bound + std::max(0.0, tail_log_);  // the prior's largest
    const Eigen::Vector2d corner(prediction_.mean.x + x * map_.resolution(),
                                 prediction_.mean.y + y * map_.resolution());
    const double side = ((1 << level) - 1) * map_.resolution();
    const Eigen::Vector2d opposite = corner + Eigen::Vector2d(side, side);
    return bound + std::max(turns.prior.over(corner, opposite),
                            tail_log_ + turns.tail.over(corner, opposite));
  }

  // In their order, as sums of weights depend on it.
  double weighted_sum(const TurnedPoints& points, int x, int y, int level) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < points.cells.size(); ++i) {
      sum += double{points.weights[i]} * bound_at(points.cells, i, x, y, level);
    }
    return sum;
  }
  int bound_at(const PointsInCells& points, std::size_t i, int x, int y, int level) const {
    const std::size_t its_level =
        points.level.empty() ? static_cast<std::size_t>(level) : points.level[i];
    if (its_level == PointsInCells::kUnbounded) return 255;
    return pyramid_.levels[its_level].at(points.x[i] + x, points.y[i] + y);
  }

  // Whether the limits exclude all poses of a block: they do so for those between others, too.
  bool is_excluded(const Block& block, int level) const {
    if (!limits_.away_from) return false;
    const int side = (1 << level) - 1, turns = (1 << group_bits(level)) - 1;
    if (turns * lattice_.turn_step >= 1.0) return false;  // nothing lies between
    for (const int turn : {block.turn, block.turn + turns}) {
      for (const int y : {block.y, block.y + side}) {
        for (const int x : {block.x, block.x + side}) {
          if (!limits_.exclude(lattice_.pose(prediction_.mean, map_.resolution(), turn, x, y))) {
            return false;
          }
        }
      }
    }
    return true;
  }

  void branch(const Block& block, int level) {
    if (level == 0) {
      ++looked_at_;
      const Pose2 pose =
          lattice_.pose(prediction_.mean, map_.resolution(), block.turn, block.x, block.y);
      if (limits_.exclude(pose)) return;
      const double value = map_.sum_log_at(points_, pose) + prediction_.log_at(pose);
      if (value <= best_) return;
      best_ = value;
      best_pose_ = pose;
      return;
    }
    if (is_excluded(block, level)) return;
    const int half = 1 << (level - 1);
    const int last_turn = std::min(lattice_.turns, block.turn + (1 << group_bits(level)) - 1);
    const BlockGrid quarters{block.x, block.y, level - 1, block.x + half > lattice_.shifts ? 1 : 2,
                             block.y + half > lattice_.shifts ? 1 : 2};
    Children children;
    for (int turn = block.turn; turn <= last_turn; turn += 1 << group_bits(level - 1)) {
      add_blocks(turn, quarters, children);
    }
    for (std::size_t i = 1; i < children.count; ++i) {  // best bound first
      for (std::size_t j = i; j > 0 && children.blocks[j].bound > children.blocks[j - 1].bound;
           --j) {
        std::swap(children.blocks[j], children.blocks[j - 1]);
      }
    }
    for (std::size_t i = 0; i < children.count && children.blocks[i].bound > best_ && !over();
         ++i) {
      branch(children.blocks[i], level - 1);
    }
  }

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
  int top_;  // level of the coarsest blocks
  PointTurner turner_;
  std::vector<std::vector<std::optional<Turns>>> turns_;  // by level, by group of turns
  std::vector<int> sums_;
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
