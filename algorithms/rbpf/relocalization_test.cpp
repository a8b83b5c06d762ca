#include "algorithms/rbpf/relocalization.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/particles/hypotheses.h"
#include "algorithms/rbpf/testing/drives.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

constexpr double kResolution = 0.1;  // [m] of particles' maps
const TestLaser kLaser{.beams = 361, .first_bearing = -kPi, .max_range = 10.0};
const Pose2 kNotThere{-3.0, -2.0, 0.0};  // where the filter has the robot after the interruption
const Tolerance kCell{0.05, 0.02};       // half a cell of the maps that are searched

// A furnished room is known from three updates; then the robot is carried to `kFirst` and drives
// on.
const std::vector<Pose2> kBefore{{-3, -2, 0}, {0, -2, 0}, {3, 2, kPi / 2}};
const Pose2 kFirst{2.2, 0.7, 2.5};
const Pose2 kOn{0.6, 0.0, 0.1};  // from update to update
constexpr double kSince = 7.5;   // [s]

class CarriedRobot : public ::testing::Test {
 protected:
  CarriedRobot() {
    for (const Pose2& pose : kBefore) sees(pose, pose);
    Particle particle{.pose = kBefore.back(), .map = SurfaceMap(kResolution), .history = nullptr};
    for (std::size_t i = 0; i < kBefore.size(); ++i) {
      particle.history = std::make_shared<HistoryNode>(kBefore[i], i, particle.history);
      particle.map.add(scans_[i].surface, kBefore[i]);
    }
    before_.assign(3, particle);
  }

  // A new update.
  void sees(const Pose2& truth, const Pose2& seen_from_robot) {
    scans_.push_back(scan_for_weighting(scan_of(furnished_room(), truth, kLaser),
                                        {.min_spacing = 0.1, .max_points = 90}, {}, kResolution));
    updates_.push_back({.seen_from_robot = seen_from_robot});
  }
  Relocalization relocalization(const RelocalizationOptions& options = {}) const {
    return Relocalization(kSince, before_, view(), options);
  }
  Relocalization::Updates view() const { return {scans_, updates_}; }

  std::vector<ScanForWeighting> scans_;
  std::vector<FrontEnd::Update> updates_;
  std::vector<Particle> before_;
};

TEST_F(CarriedRobot, IsElsewhereOnceTwoUpdatesRunningAgree) {
  Relocalization relocalization = this->relocalization();
  sees(kFirst, kNotThere);
  const GlobalLocalizer::Answer once = relocalization.find(view(), kNotThere);
  EXPECT_FALSE(once.confirmed);
  EXPECT_FALSE(once.relocated_to);
  sees(kFirst * kOn, kNotThere * kOn);
  const GlobalLocalizer::Answer twice = relocalization.find(view(), kNotThere * kOn);
  ASSERT_TRUE(twice.relocated_to);
  EXPECT_THAT(*twice.relocated_to, IsNear(kFirst * kOn, kCell));
}

TEST_F(CarriedRobot, IsNotBelievedWhereTheMotionBetweenSaysOtherwise) {
  Relocalization relocalization = this->relocalization();
  sees(kFirst, kNotThere);
  relocalization.find(view(), kNotThere);
  sees({-2.4, 1.1, -1.0}, kNotThere * kOn);  // that is not one step on
  EXPECT_FALSE(relocalization.find(view(), kNotThere * kOn).relocated_to);
}

// Between the two the robot went on unseen, and the newest step alone does not tell how far.
TEST_F(CarriedRobot, IsNotBelievedWhereAnUpdateBetweenWasNotLookedAt) {
  Relocalization relocalization = this->relocalization();
  sees(kFirst, kNotThere);
  relocalization.find(view(), kNotThere);
  sees(kFirst, kNotThere);
  sees(kFirst * kOn, kNotThere * kOn);
  EXPECT_FALSE(relocalization.find(view(), kNotThere * kOn).relocated_to);
}

TEST_F(CarriedRobot, IsSoughtForSoManyUpdates) {
  const Relocalization relocalization = this->relocalization({.max_updates = 2});
  EXPECT_EQ(relocalization.first_update(), kBefore.size());
  sees(kFirst, kNotThere);
  EXPECT_FALSE(relocalization.gives_up(view()));
  sees(kFirst * kOn, kNotThere * kOn);
  EXPECT_TRUE(relocalization.gives_up(view()));
}

TEST_F(CarriedRobot, StartsAgainInTheMapOfBeforeWithAllThatItSawSince) {
  const Relocalization relocalization = this->relocalization();
  sees(kFirst, kNotThere);
  sees(kFirst * kOn, kNotThere * kOn);
  const Pose2 found = kFirst * kOn * Pose2{0.05, -0.05, 0.03};
  const std::vector<Particle> particles =
      relocalization.restarted(found, view(), SurfaceLikelihood{}, {}, Rng(1));
  ASSERT_EQ(particles.size(), before_.size());
  for (const Particle& particle : particles) {
    EXPECT_THAT(particle.pose, IsNear(kFirst * kOn, kCell));
    const std::vector<Pose2> path = path_of(*particle.history);
    ASSERT_EQ(path.size(), kBefore.size() + 2);
    EXPECT_EQ(path[2], kBefore[2]);
    EXPECT_THAT(path[3], IsNear(kFirst, kCell));
    EXPECT_EQ(path[4], particle.pose);
  }
}

// What the robot sees beside a wall that stands since, from where it was first after the
// interruption: only that scan has it, so only a map with that scan explains it.
TEST_F(CarriedRobot, EntersIntoTheMapsAllScansSinceButTheNewest) {
  const Relocalization relocalization = this->relocalization();
  sees(kFirst, kNotThere);
  sees(kFirst * kOn, kNotThere * kOn);
  const auto with_mark = [](ScanForWeighting& scan, const Eigen::Vector2d& at) {
    scan.surface.push_back({.position = at});
  };
  const Eigen::Vector2d mark{0.4, 0.4};  // [m] in the robot frame, where the room is free
  with_mark(scans_[3], mark);
  with_mark(scans_[4], -mark);
  const Particle particle =
      relocalization.restarted(kFirst * kOn, view(), SurfaceLikelihood{}, {}, Rng(1)).front();
  const std::vector<Pose2> path = path_of(*particle.history);
  EXPECT_TRUE(particle.map.nearest(path[3] * mark).found);
  EXPECT_FALSE(particle.map.nearest(path[4] * Eigen::Vector2d(-mark)).found);
}

// Each particle knows the place by what it passed there itself.
TEST_F(CarriedRobot, StartsAgainInEachParticlesOwnMap) {
  const Pose2 elsewhere{0.0, 0.4, 0.0};  // as this particle's map lies
  Particle other{
      .pose = elsewhere * kBefore.back(), .map = SurfaceMap(kResolution), .history = nullptr};
  for (std::size_t i = 0; i < kBefore.size(); ++i) {
    other.history = std::make_shared<HistoryNode>(elsewhere * kBefore[i], i, other.history);
    other.map.add(scans_[i].surface, elsewhere * kBefore[i]);
  }
  other.log_weight = -1.0;  // not the best one, whose map is searched
  before_.push_back(other);
  const Relocalization relocalization = this->relocalization();
  sees(kFirst, kNotThere);
  const std::vector<Particle> particles =
      relocalization.restarted(kFirst, view(), SurfaceLikelihood{}, {}, Rng(1));
  EXPECT_THAT(particles.front().pose, IsNear(kFirst, kCell));
  EXPECT_THAT(particles.back().pose, IsNear(elsewhere * kFirst, kCell));
}

}  // namespace
}  // namespace mapbed
