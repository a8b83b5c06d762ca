// Pose graphs by mapbed and by Ceres, in turn, in one run: the same residuals, derivatives and
// start, one thread. A program of its own, as Ceres comes with GPL libraries: never installed.
//
//   OMP_THREAD_LIMIT=1 mapbed_pose_graph_ceres ROUNDS FILE…
//
// The limit is for CHOLMOD, which takes four threads otherwise.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <ceres/ceres.h>
#include <fmt/format.h>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/graph_file.h"
#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/pose_graph/initial_poses.h"

namespace mapbed {
namespace {

template <class Pose>
inline constexpr int kNumbers = 0;  // of a pose as Ceres holds it
template <>
inline constexpr int kNumbers<Pose2> = 3;
template <>
inline constexpr int kNumbers<Pose3> = 7;

void write_numbers(const Pose2& pose, double* numbers) {
  numbers[0] = pose.x;
  numbers[1] = pose.y;
  numbers[2] = pose.theta;
}
void write_numbers(const Pose3& pose, double* numbers) {
  Eigen::Map<Eigen::Vector3d>{numbers} = pose.position;
  Eigen::Map<Eigen::Vector4d>(numbers + 3) = pose.rotation.coeffs();
}
template <class Pose>
Pose pose_from(const double* numbers) {
  Pose pose;
  if constexpr (kNumbers<Pose> == 3) {
    pose = {numbers[0], numbers[1], numbers[2]};
  } else {
    pose.position = Eigen::Map<const Eigen::Vector3d>(numbers);
    pose.rotation.coeffs() = Eigen::Map<const Eigen::Vector4d>(numbers + 3);
  }
  return pose;
}

// Steps as mapbed's. Derivatives are by steps already, so that of Plus is the identity.
class Steps : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 7; }
  int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* result) const override {
    write_numbers(moved(pose_from<Pose3>(x), Eigen::Map<const PoseTangent<Pose3>>(delta)), result);
    return true;
  }
  bool PlusJacobian(const double*, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, 7, 6, Eigen::RowMajor>>(jacobian).setIdentity();
    return true;
  }
  bool Minus(const double*, const double*, double*) const override { return false; }
  bool MinusJacobian(const double*, double*) const override { return false; }
};

template <class Pose>
class Constraint
    : public ceres::SizedCostFunction<kDegreesOfFreedom<Pose>, kNumbers<Pose>, kNumbers<Pose>> {
 public:
  explicit Constraint(const PoseConstraint<Pose>& constraint)
      : from_from_to_(constraint.from_from_to), root_(constraint.information.llt().matrixU()) {}

  bool Evaluate(double const* const* poses, double* residuals, double** jacobians) const override {
    constexpr int kSize = kDegreesOfFreedom<Pose>;
    const Pose from = pose_from<Pose>(poses[0]);
    const Pose to = pose_from<Pose>(poses[1]);
    Eigen::Map<PoseTangent<Pose>> error(residuals);
    if (jacobians == nullptr) {
      error = root_ * constraint_error(from_from_to_, from, to);
      return true;
    }
    const LinearError<Pose> linear = linear_error(from_from_to_, from, to);
    error = root_ * linear.error;
    for (int i = 0; i < 2; ++i) {
      if (jacobians[i] == nullptr) continue;
      Eigen::Map<Eigen::Matrix<double, kSize, kNumbers<Pose>, Eigen::RowMajor>> jacobian(
          jacobians[i]);
      jacobian.setZero();
      jacobian.template leftCols<kSize>() = root_ * (i == 0 ? linear.by_from : linear.by_to);
    }
    return true;
  }

 private:
  Pose from_from_to_;
  PoseInformation<Pose> root_;
};

// One thread each, so that whatever else runs on the machine counts little.
double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Run {
  double seconds = 0.0;
  double chi2 = 0.0;
  int iterations = 0;
};

template <class Pose>
Run by_ceres(const PoseGraph<Pose>& graph, ceres::TrustRegionStrategyType strategy,
             double tolerance) {
  const double start = processor_seconds();
  std::vector<double> numbers(graph.nodes.size() * kNumbers<Pose>);
  const auto at = [&](int node) {
    return numbers.data() + static_cast<std::size_t>(node) * kNumbers<Pose>;
  };
  ceres::Problem problem;
  const std::vector<bool> held = held_nodes(graph);
  Steps* const steps = kNumbers<Pose> == 7 ? new Steps : nullptr;
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node) {
    write_numbers(graph.nodes[static_cast<std::size_t>(node)], at(node));
    problem.AddParameterBlock(at(node), kNumbers<Pose>, steps);
    if (held[static_cast<std::size_t>(node)]) problem.SetParameterBlockConstant(at(node));
  }
  for (const PoseConstraint<Pose>& constraint : graph.constraints) {
    problem.AddResidualBlock(new Constraint<Pose>(constraint), nullptr, at(constraint.from),
                             at(constraint.to));
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
  options.trust_region_strategy_type = strategy;
  options.dogleg_type = ceres::SUBSPACE_DOGLEG;
  options.max_num_iterations = 300;
  options.function_tolerance = tolerance;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return {processor_seconds() - start, 2.0 * summary.final_cost,
          summary.num_successful_steps + summary.num_unsuccessful_steps};
}

template <class Pose>
Run by_mapbed(const PoseGraph<Pose>& graph) {
  const double start = processor_seconds();
  const GraphOptimum<Pose> optimum = optimize(graph);
  return {processor_seconds() - start, optimum.chi2_after, optimum.iterations};
}

double median_seconds(std::vector<Run> runs) {
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.seconds < b.seconds; });
  return runs[runs.size() / 2].seconds;
}

template <class Pose>
void compare(const std::string& name, const PoseGraph<Pose>& graph, int rounds) {
  std::vector<Run> ours, theirs;
  for (int round = 0; round < rounds; ++round) {
    ours.push_back(by_mapbed(graph));
    theirs.push_back(by_ceres(graph, ceres::LEVENBERG_MARQUARDT, 1e-6));  // its default
  }
  const Run exact = by_ceres(graph, ceres::LEVENBERG_MARQUARDT, 1e-12);
  const Run dogleg = by_ceres(graph, ceres::DOGLEG, 1e-12);
  const double best = std::min({theirs[0].chi2, exact.chi2, dogleg.chi2});
  fmt::print(
      "{:44} mapbed {:9.2f} ms {:3} it chi2 {:.9g} | Ceres {:9.2f} ms {:3} it {:.9g}, best {:.9g} "
      "| "
      "{:5.2f}x, chi2 {:+.1e}\n",
      name, 1e3 * median_seconds(ours), ours[0].iterations, ours[0].chi2,
      1e3 * median_seconds(theirs), theirs[0].iterations, theirs[0].chi2, best,
      median_seconds(theirs) / median_seconds(ours), ours[0].chi2 / best - 1.0);
}

}  // namespace
}  // namespace mapbed

int main(int count, char** arguments) {
  using namespace mapbed;
  const int rounds = count > 1 ? std::max(1, std::atoi(arguments[1])) : 1;
  for (int i = 2; i < count; ++i) {
    const std::string path = arguments[i];
    const GraphFile file = load_graph(path);
    const std::string name = path.substr(path.find_last_of('/') + 1);
    std::visit(
        [&](auto graph) {
          if (file.has_poses) compare(name + ", its own start", graph, rounds);
          graph.nodes = spanning_tree_poses(graph);
          compare(name + ", spanning tree", graph, rounds);
          graph.nodes = chordal_poses(graph);
          compare(name + ", chordal", graph, rounds);
        },
        file.graph);
  }
}
