#include "algorithms/pose_graph/incremental_graph.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "algorithms/pose_graph/constraint_error.h"
#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// Rounding errors of a change are of the order of 1e-16; what is left of the poses' digits is ten.
constexpr double kMostRounding = 1e6;
constexpr double kConverged = 1e-9;  // [m], [rad]

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// The root S' of R = S S', which takes errors to such of unit covariance.
template <int B>
Eigen::Matrix<double, B, B> root_of(const Eigen::Matrix<double, B, B>& information) {
  const Eigen::LLT<Eigen::Matrix<double, B, B>> cholesky(information);
  CHECK(cholesky.info() == Eigen::Success);
  return cholesky.matrixU();
}

template <int B>
double log_normalizer_of(const Eigen::Matrix<double, B, B>& information) {
  return root_of<B>(information).diagonal().array().log().sum() - 0.5 * B * std::log(2.0 * kPi);
}

template <int B>
struct Equations {
  std::vector<NodeBlock<B>> blocks;
  Eigen::VectorXd h;
  double c = 0.0;

  explicit Equations(int nodes) : h(Eigen::VectorXd::Zero(nodes * B)) {}

  void add(const NodeRows<B>& rows) {
    const auto add_node = [&](int node, const Eigen::Matrix<double, B, B>& of_node) {
      blocks.push_back({node, node, of_node.transpose() * of_node});
      h.segment<B>(node * B) += of_node.transpose() * rows.value;
    };
    add_node(rows.first, rows.of_first);
    c += rows.value.squaredNorm();
    if (rows.second < 0) return;
    add_node(rows.second, rows.of_second);
    blocks.push_back({rows.first, rows.second, rows.of_first.transpose() * rows.of_second});
  }
};

}  // namespace

template <class Pose>
IncrementalGraph<Pose>::IncrementalGraph(const Pose& map_from_first,
                                         const IncrementalGraphOptions& options,
                                         const PoseInformation<Pose>& prior)
    : options_(options),
      map_from_first_(map_from_first),
      prior_(prior),
      linearized_at_{map_from_first},
      poses_{map_from_first},
      log_normalizer_(log_normalizer_of<kSize>(prior)) {
  linearize();
}

template <class Pose>
IncrementalGraph<Pose>::IncrementalGraph(const PoseGraph<Pose>& graph,
                                         const IncrementalGraphOptions& options,
                                         const PoseInformation<Pose>& prior)
    : options_(options),
      map_from_first_(graph.nodes.front()),
      prior_(prior),
      linearized_at_(graph.nodes),
      poses_(graph.nodes),
      log_normalizer_(log_normalizer_of<kSize>(prior)) {
  for (const PoseConstraint<Pose>& constraint : graph.constraints) {
    hold(constraint, rows_of(constraint));
  }
  const std::vector<int> component = components_of(graph);
  CHECK(std::all_of(component.begin(), component.end(), [](int c) { return c == 0; }));
  linearize();
  follow();
}

// |of_first step + of_second step - value|^2 is the constraint's part of J after a step.
template <class Pose>
NodeRows<IncrementalGraph<Pose>::kSize> IncrementalGraph<Pose>::rows_of(
    const PoseConstraint<Pose>& constraint) const {
  const LinearError<Pose> linear =
      linear_error(constraint.from_from_to, linearized_at_[at(constraint.from)],
                   linearized_at_[at(constraint.to)]);
  const PoseInformation<Pose> root = root_of<kSize>(constraint.information);
  return {constraint.from, constraint.to, root * linear.by_from, root * linear.by_to,
          -root * linear.error};
}

template <class Pose>
NodeRows<IncrementalGraph<Pose>::kSize> IncrementalGraph<Pose>::prior_rows() const {
  const LinearError<Pose> linear = linear_error(map_from_first_, Pose{}, linearized_at_.front());
  const PoseInformation<Pose> root = root_of<kSize>(prior_);
  return {0, -1, root * linear.by_to, PoseInformation<Pose>::Zero(), -root * linear.error};
}

template <class Pose>
int IncrementalGraph<Pose>::hold(const PoseConstraint<Pose>& constraint,
                                 const NodeRows<kSize>& rows) {
  constraints_.push_back(Held{constraint, rows});
  pairs_.emplace_back(constraint.from, constraint.to);
  log_normalizer_ += log_normalizer_of<kSize>(constraint.information);
  return static_cast<int>(constraints_.size()) - 1;
}

template <class Pose>
int IncrementalGraph<Pose>::add_node(const PoseConstraint<Pose>& constraint) {
  const int node = nodes();
  const bool is_to = constraint.to == node;
  CHECK(is_to != (constraint.from == node));
  const auto from_the_other = [&](const std::vector<Pose>& poses) {
    return is_to ? poses[at(constraint.from)] * constraint.from_from_to
                 : poses[at(constraint.to)] * inverse(constraint.from_from_to);
  };
  linearized_at_.push_back(from_the_other(linearized_at_));
  poses_.push_back(from_the_other(poses_));
  const NodeRows<kSize> rows = rows_of(constraint);
  factor_->append(rows);
  const int number = hold(constraint, rows);
  follow();
  return number;
}

template <class Pose>
int IncrementalGraph<Pose>::add(const PoseConstraint<Pose>& constraint) {
  CHECK(constraint.from != constraint.to && constraint.from < nodes() && constraint.to < nodes());
  const NodeRows<kSize> rows = rows_of(constraint);
  factor_->add(rows);
  const int number = hold(constraint, rows);
  follow();
  return number;
}

template <class Pose>
bool IncrementalGraph<Pose>::remove(int number) {
  CHECK(number >= 0 && at(number) < constraints_.size() && constraints_[at(number)]);
  if (!is_connected_without(number)) return false;
  const Held held = *constraints_[at(number)];
  constraints_[at(number)].reset();
  pairs_[at(number)] = {0, 0};
  log_normalizer_ -= log_normalizer_of<kSize>(held.constraint.information);
  if (!factor_->remove(held.rows)) linearize();  // what is left is little beside it
  follow();
  return true;
}

template <class Pose>
bool IncrementalGraph<Pose>::is_connected_without(int number) const {
  std::vector<std::pair<int, int>> pairs = pairs_;
  pairs[at(number)] = {0, 0};
  const std::vector<int> component = components_of(nodes(), pairs);
  return std::all_of(component.begin(), component.end(), [](int c) { return c == 0; });
}

// All constraints at linearized_at_, and their factor.
template <class Pose>
void IncrementalGraph<Pose>::linearize() {
  Equations<kSize> equations(nodes());
  equations.add(prior_rows());
  for (std::optional<Held>& held : constraints_) {
    if (!held) continue;
    held->rows = rows_of(held->constraint);
    equations.add(held->rows);
  }
  if (!factor_ || factor_->blocks() > 2 * blocks_when_ordered_) {
    factor_.emplace(nodes(), equations.blocks);
    blocks_when_ordered_ = factor_->blocks();
  }
  CHECK(factor_->factorize(equations.blocks, equations.h, equations.c));
  ++linearizations_;
}

template <class Pose>
double IncrementalGraph<Pose>::objective_at(const std::vector<Pose>& poses) const {
  const PoseTangent<Pose> error = constraint_error(map_from_first_, Pose{}, poses.front());
  double sum = error.dot(prior_ * error);
  for (const std::optional<Held>& held : constraints_) {
    if (held) sum += chi_square_of(held->constraint, poses);
  }
  return sum;
}

template <class Pose>
void IncrementalGraph<Pose>::update_poses(const Eigen::VectorXd& step) {
  for (int i = 0; i < nodes(); ++i) {
    poses_[at(i)] = moved(linearized_at_[at(i)], step.segment<kSize>(i * kSize));
  }
}

// How often the largest of a node's steps is what the options allow.
template <class Pose>
double IncrementalGraph<Pose>::largest_excess(const Eigen::VectorXd& step) const {
  constexpr int kPosition = kSize == 3 ? 2 : 3;
  double largest = 0.0;
  for (int i = 0; i < nodes(); ++i) {
    const auto of_node = step.segment<kSize>(i * kSize);
    largest = std::max({largest, of_node.template head<kPosition>().norm() / options_.max_move,
                        of_node.template tail<kSize - kPosition>().norm() / options_.max_turn});
  }
  return largest;
}

// The step, or as much of it as does not make J larger, leads to where constraints are linearised.
template <class Pose>
void IncrementalGraph<Pose>::take_step(Eigen::VectorXd step) {
  const double most = objective_at(linearized_at_) * (1.0 + 1e-12);
  for (int halvings = 0; halvings < 20; ++halvings, step *= 0.5) {
    update_poses(step);
    if (objective_at(poses_) <= most) break;
  }
  linearized_at_ = poses_;
  linearize();
}

// The poses after a change.
template <class Pose>
void IncrementalGraph<Pose>::follow() {
  if (factor_->rounding() > kMostRounding || factor_->blocks() > 2 * blocks_when_ordered_) {
    linearize();
  }
  Eigen::VectorXd step = factor_->minimizer();
  for (int i = 0; i < options_.max_iterations && largest_excess(step) > 1.0; ++i) {
    take_step(std::move(step));
    step = factor_->minimizer();
  }
  update_poses(step);
}

template <class Pose>
bool IncrementalGraph<Pose>::converge() {
  Eigen::VectorXd step = factor_->minimizer();
  for (int i = 0; i < options_.max_iterations; ++i) {
    if (step.lpNorm<Eigen::Infinity>() < kConverged) break;
    take_step(std::move(step));
    step = factor_->minimizer();
  }
  update_poses(step);
  return step.lpNorm<Eigen::Infinity>() < kConverged;
}

template <class Pose>
PoseInformation<Pose> IncrementalGraph<Pose>::covariance_between(int a, int b) const {
  const Pose& map_from_a = linearized_at_[at(a)];
  const Pose& map_from_b = linearized_at_[at(b)];
  const LinearError<Pose> linear =
      linear_error(motion_between(map_from_a, map_from_b), map_from_a, map_from_b);
  return factor_->covariance({a, b, linear.by_from, linear.by_to, PoseTangent<Pose>::Zero()});
}

template <class Pose>
PoseGraph<Pose> IncrementalGraph<Pose>::graph() const {
  PoseGraph<Pose> graph{.nodes = poses_};
  for (const std::optional<Held>& held : constraints_) {
    if (held) graph.constraints.push_back(held->constraint);
  }
  return graph;
}

template class IncrementalGraph<Pose2>;
template class IncrementalGraph<Pose3>;

}  // namespace mapbed
