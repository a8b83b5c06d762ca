#include "algorithms/pose_graph/normal_equations.h"

#include <algorithm>
#include <utility>

#include <Eigen/SparseCholesky>

#include "algorithms/pose_graph/elimination_order.h"
#include "core/check.h"

namespace mapbed {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

// Eigen orders nothing anew: the matrix comes in the order of elimination.
using Factors = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Upper, Eigen::NaturalOrdering<int>>;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

template <class Pose>
struct NormalEquations<Pose>::State {
  static constexpr int kSize = kDegreesOfFreedom<Pose>;
  using Block = PoseInformation<Pose>;

  std::vector<int> places;     // of nodes in the order of elimination; -1 where held
  std::vector<int> nodes;      // that stand at these places
  std::vector<int> first_row;  // of each place, into `rows`
  std::vector<int> rows;       // places of the blocks above the diagonal, ascending in each column
  std::vector<int> blocks;     // into `rows`, of each constraint between two nodes that are free
  SparseMatrix matrix;         // upper triangle
  Eigen::VectorXd gradient;
  Factors factors;

  int count() const { return static_cast<int>(nodes.size()); }

  // Columns of one place lie one after the other, each with all blocks above and its own part of
  // the diagonal's; that of column c within it begins here.
  double* column(int place, int c) {
    return matrix.valuePtr() + matrix.outerIndexPtr()[kSize * place + c];
  }

  void find_pattern(const PoseGraph<Pose>& graph);
  void lay_out();
  void add_diagonal(int place, const Block& block);
  void add_above(int place, int row, const Block& block);  // row: into `rows`
};

// Pairs of free nodes that constraints join, as (later, earlier) place.
template <class Pose>
void NormalEquations<Pose>::State::find_pattern(const PoseGraph<Pose>& graph) {
  const std::vector<bool> held = held_nodes(graph);
  std::vector<int> number(graph.nodes.size(), -1);
  for (std::size_t node = 0; node < held.size(); ++node) {
    if (held[node]) continue;
    number[node] = static_cast<int>(nodes.size());
    nodes.push_back(static_cast<int>(node));
  }
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(graph.constraints.size());
  for (const PoseConstraint<Pose>& constraint : graph.constraints) {
    const int a = number[index(constraint.from)];
    const int b = number[index(constraint.to)];
    if (a >= 0 && b >= 0 && a != b) pairs.emplace_back(a, b);
  }
  const std::vector<int> place_of_number = elimination_places(count(), pairs);
  places = number;
  for (int& place : places) {
    if (place >= 0) place = place_of_number[index(place)];
  }
  for (std::size_t node = 0; node < places.size(); ++node) {
    if (places[node] >= 0) nodes[index(places[node])] = static_cast<int>(node);
  }

  for (auto& [a, b] : pairs) {
    a = place_of_number[index(a)];
    b = place_of_number[index(b)];
    if (a < b) std::swap(a, b);
  }
  std::vector<std::pair<int, int>> entries = pairs;
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  first_row.assign(nodes.size() + 1, 0);
  for (const auto& [column, row] : entries) {
    ++first_row[index(column) + 1];
    rows.push_back(row);
  }
  for (std::size_t place = 0; place < nodes.size(); ++place) {
    first_row[place + 1] += first_row[place];
  }
  blocks.assign(graph.constraints.size(), -1);
  auto pair = pairs.begin();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const PoseConstraint<Pose>& constraint = graph.constraints[i];
    const int a = places[index(constraint.from)];
    const int b = places[index(constraint.to)];
    if (a < 0 || b < 0 || a == b) continue;
    const auto begin = rows.begin() + first_row[index(pair->first)];
    const auto end = rows.begin() + first_row[index(pair->first) + 1];
    blocks[i] = static_cast<int>(std::lower_bound(begin, end, pair->second) - rows.begin());
    ++pair;
  }
}

// The same for scalars.
template <class Pose>
void NormalEquations<Pose>::State::lay_out() {
  const int size = kSize * count();
  matrix.resize(size, size);
  const int above = kSize * kSize * static_cast<int>(rows.size());
  matrix.resizeNonZeros(above + count() * kSize * (kSize + 1) / 2);
  int next = 0;
  for (int place = 0; place < count(); ++place) {
    for (int c = 0; c < kSize; ++c) {
      matrix.outerIndexPtr()[kSize * place + c] = next;
      for (int i = first_row[index(place)]; i < first_row[index(place) + 1]; ++i) {
        for (int r = 0; r < kSize; ++r) matrix.innerIndexPtr()[next++] = kSize * rows[index(i)] + r;
      }
      for (int r = 0; r <= c; ++r) matrix.innerIndexPtr()[next++] = kSize * place + r;
    }
  }
  matrix.outerIndexPtr()[size] = next;
  Eigen::Map<Eigen::VectorXd>(matrix.valuePtr(), next).setZero();
  gradient.setZero(size);
  factors.analyzePattern(matrix);
}

template <class Pose>
void NormalEquations<Pose>::State::add_diagonal(int place, const Block& block) {
  const int above = kSize * (first_row[index(place) + 1] - first_row[index(place)]);
  for (int c = 0; c < kSize; ++c) {
    double* values = column(place, c) + above;
    for (int r = 0; r <= c; ++r) values[r] += block(r, c);
  }
}

template <class Pose>
void NormalEquations<Pose>::State::add_above(int place, int row, const Block& block) {
  const int begin = kSize * (row - first_row[index(place)]);
  for (int c = 0; c < kSize; ++c) {
    double* values = column(place, c) + begin;
    for (int r = 0; r < kSize; ++r) values[r] += block(r, c);
  }
}

template <class Pose>
NormalEquations<Pose>::NormalEquations(const PoseGraph<Pose>& graph)
    : state_(std::make_unique<State>()) {
  state_->find_pattern(graph);
  state_->lay_out();
}

template <class Pose>
NormalEquations<Pose>::~NormalEquations() = default;

template <class Pose>
int NormalEquations<Pose>::size() const {
  return static_cast<int>(state_->gradient.size());
}

template <class Pose>
int NormalEquations<Pose>::offset_of(int node) const {
  const int place = state_->places[index(node)];
  return place < 0 ? -1 : State::kSize * place;
}

template <class Pose>
void NormalEquations<Pose>::linearize(const PoseGraph<Pose>& graph, const std::vector<Pose>& nodes,
                                      const std::vector<double>& weights) {
  constexpr int kSize = State::kSize;
  State& s = *state_;
  CHECK(graph.constraints.size() == s.blocks.size() && nodes.size() == s.places.size());
  Eigen::Map<Eigen::VectorXd>(s.matrix.valuePtr(), s.matrix.nonZeros()).setZero();
  s.gradient.setZero();
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    const PoseConstraint<Pose>& constraint = graph.constraints[i];
    const int a = s.places[index(constraint.from)];
    const int b = s.places[index(constraint.to)];
    if (weights[i] == 0.0 || a == b) continue;
    const LinearError<Pose> linear = linear_error(
        constraint.from_from_to, nodes[index(constraint.from)], nodes[index(constraint.to)]);
    const PoseInformation<Pose> information = weights[i] * constraint.information;
    const PoseTangent<Pose> pull = information * linear.error;
    const PoseInformation<Pose> of_from = information * linear.by_from;
    const PoseInformation<Pose> of_to = information * linear.by_to;
    if (a >= 0) {
      s.add_diagonal(a, linear.by_from.transpose() * of_from);
      s.gradient.template segment<kSize>(kSize * a) += linear.by_from.transpose() * pull;
    }
    if (b >= 0) {
      s.add_diagonal(b, linear.by_to.transpose() * of_to);
      s.gradient.template segment<kSize>(kSize * b) += linear.by_to.transpose() * pull;
    }
    if (a < 0 || b < 0) continue;
    if (a < b) {
      s.add_above(b, s.blocks[i], linear.by_from.transpose() * of_to);
    } else {
      s.add_above(a, s.blocks[i], linear.by_to.transpose() * of_from);
    }
  }
}

template <class Pose>
const Eigen::VectorXd& NormalEquations<Pose>::gradient() const {
  return state_->gradient;
}

template <class Pose>
Eigen::VectorXd NormalEquations<Pose>::times(const Eigen::VectorXd& step) const {
  return state_->matrix.template selfadjointView<Eigen::Upper>() * step;
}

template <class Pose>
Eigen::VectorXd NormalEquations<Pose>::diagonal() const {
  return state_->matrix.diagonal();
}

template <class Pose>
bool NormalEquations<Pose>::factorize(double damping) {
  State& s = *state_;
  // The diagonal's entry is the last of its column.
  const Eigen::VectorXd undamped = diagonal();
  const auto entry = [&](int i) -> double& {
    return s.matrix.valuePtr()[s.matrix.outerIndexPtr()[i + 1] - 1];
  };
  constexpr double kLeast = 1e-6;  // of what nothing is known about
  for (int i = 0; i < size(); ++i) entry(i) += damping * std::max(undamped[i], kLeast);
  s.factors.factorize(s.matrix);
  for (int i = 0; i < size(); ++i) entry(i) = undamped[i];
  return s.factors.info() == Eigen::Success &&
         (size() == 0 || s.factors.vectorD().minCoeff() > 0.0);
}

template <class Pose>
Eigen::MatrixXd NormalEquations<Pose>::solve(const Eigen::MatrixXd& right_hand_sides) const {
  if (size() == 0) return right_hand_sides;
  return state_->factors.solve(right_hand_sides);
}

template <class Pose>
std::vector<Pose> NormalEquations<Pose>::moved(const std::vector<Pose>& nodes,
                                               const Eigen::VectorXd& step) const {
  constexpr int kSize = State::kSize;
  std::vector<Pose> result = nodes;
  for (int place = 0; place < state_->count(); ++place) {
    Pose& pose = result[index(state_->nodes[index(place)])];
    pose = mapbed::moved(pose, step.segment<kSize>(kSize * place));
  }
  return result;
}

template class NormalEquations<Pose2>;
template class NormalEquations<Pose3>;

}  // namespace mapbed
