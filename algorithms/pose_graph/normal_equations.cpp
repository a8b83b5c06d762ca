#include "algorithms/pose_graph/normal_equations.h"

#include <utility>

#include "algorithms/pose_graph/free_nodes.h"
#include "core/check.h"

namespace mapbed {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

template <class Pose>
NormalEquations<Pose>::NormalEquations(const PoseGraph<Pose>& graph)
    : NormalEquations(FreeNodes(graph)) {}

template <class Pose>
NormalEquations<Pose>::NormalEquations(const FreeNodes& free)
    : places_(free.numbers), blocks_(free.pair_of_constraint), matrix_(free.count, free.pairs) {
  for (int& place : places_) {
    if (place >= 0) place = matrix_.place_of(place);
  }
  for (int& block : blocks_) {
    if (block >= 0) block = matrix_.block_of(index(block));
  }
  gradient_.setZero(size());
}

template <class Pose>
int NormalEquations<Pose>::offset_of(int node) const {
  const int place = places_[index(node)];
  return place < 0 ? -1 : kSize * place;
}

template <class Pose>
void NormalEquations<Pose>::linearize(const PoseGraph<Pose>& graph, const std::vector<Pose>& nodes,
                                      const std::vector<double>& weights) {
  CHECK(graph.constraints.size() == blocks_.size() && nodes.size() == places_.size());
  matrix_.set_zero();
  gradient_.setZero();
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    const PoseConstraint<Pose>& constraint = graph.constraints[i];
    const int a = places_[index(constraint.from)];
    const int b = places_[index(constraint.to)];
    if (weights[i] == 0.0 || constraint.from == constraint.to) continue;
    const LinearError<Pose> linear = linear_error(
        constraint.from_from_to, nodes[index(constraint.from)], nodes[index(constraint.to)]);
    const PoseInformation<Pose> information = weights[i] * constraint.information;
    const PoseTangent<Pose> pull = information * linear.error;
    const PoseInformation<Pose> of_from = information * linear.by_from;
    const PoseInformation<Pose> of_to = information * linear.by_to;
    if (a >= 0) {
      matrix_.diagonal(a) += linear.by_from.transpose() * of_from;
      gradient_.template segment<kSize>(kSize * a) += linear.by_from.transpose() * pull;
    }
    if (b >= 0) {
      matrix_.diagonal(b) += linear.by_to.transpose() * of_to;
      gradient_.template segment<kSize>(kSize * b) += linear.by_to.transpose() * pull;
    }
    if (a < 0 || b < 0) continue;
    if (a < b) {
      matrix_.off_diagonal(blocks_[i]) += linear.by_to.transpose() * of_from;
    } else {
      matrix_.off_diagonal(blocks_[i]) += linear.by_from.transpose() * of_to;
    }
  }
}

template <class Pose>
bool NormalEquations<Pose>::factorize(double damping) {
  constexpr double kLeast = 1e-6;  // of what nothing is known about
  return matrix_.factorize(damping * diagonal().cwiseMax(kLeast));
}

template <class Pose>
std::vector<Pose> NormalEquations<Pose>::moved(const std::vector<Pose>& nodes,
                                               const Eigen::VectorXd& step) const {
  std::vector<Pose> result = nodes;
  for (std::size_t node = 0; node < result.size(); ++node) {
    if (places_[node] < 0) continue;
    result[node] = mapbed::moved(result[node], step.segment<kSize>(kSize * places_[node]));
  }
  return result;
}

template class NormalEquations<Pose2>;
template class NormalEquations<Pose3>;

}  // namespace mapbed
