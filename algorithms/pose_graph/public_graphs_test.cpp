// Certificates of public graphs; skipped where MAPBED_DATA does not name the folder that holds
// them.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "algorithms/pose_graph/certificate.h"
#include "algorithms/pose_graph/graph_file.h"
#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/pose_graph/initial_poses.h"

namespace mapbed {
namespace {

struct PublicGraph {
  const char* name;
  // f as SE-Sync's reader has it, see isotropic_problem.h, by Rosen et al. 2019, tables 1 and 2;
  // 0: not among them.
  double published = 0.0;
};

class Certificates : public ::testing::TestWithParam<PublicGraph> {};

template <class Pose>
void expect_certified(PoseGraph<Pose> graph, double published) {
  // What SE-Sync reads as kappa.
  if (published > 0.0) {
    constexpr int kTurns = kDegreesOfFreedom<Pose> == 3 ? 1 : 3;
    for (auto& c : graph.constraints) {
      c.information.template bottomRightCorner<kTurns, kTurns>() *= kTurns == 1 ? 2.0 : 4.0;
    }
  }
  graph.nodes = chordal_poses(graph);
  graph.nodes = optimize(graph).poses;
  const Certificate certificate = certify(graph);
  EXPECT_TRUE(certificate.certified);
  EXPECT_EQ(certificate.problem, CertifiedProblem::isotropic);
  EXPECT_GT(certificate.min_eigenvalue, 0.0);
  EXPECT_LE(certificate.gap,
            1e-5 * (certificate.objective +
                    static_cast<double>(kDegreesOfFreedom<Pose> * graph.constraints.size())));
  if (published > 0.0) {
    EXPECT_NEAR(certificate.objective, published, 5e-4 * published);
  }
}

TEST_P(Certificates, AreFound) {
  const char* const data = std::getenv("MAPBED_DATA");
  if (data == nullptr || *data == '\0') GTEST_SKIP() << "MAPBED_DATA is not set";
  const std::filesystem::path path =
      std::filesystem::path(data) / "pose_graphs" / (std::string(GetParam().name) + ".g2o.gz");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  std::visit([](const auto& graph) { expect_certified(graph, GetParam().published); },
             load_graph(path.string()).graph);
}

INSTANTIATE_TEST_SUITE_P(
    PublicGraphs, Certificates,
    ::testing::Values(PublicGraph{"intel", 52.35}, PublicGraph{"intel"}, PublicGraph{"manhattan"},
                      PublicGraph{"MIT"}, PublicGraph{"kitti_00"},
                      PublicGraph{"sphere2500", 1687.0}, PublicGraph{"sphere2500"}),
    [](const auto& test) {
      return std::string(test.param.name) + (test.param.published > 0.0 ? "_as_published" : "");
    });

}  // namespace
}  // namespace mapbed
