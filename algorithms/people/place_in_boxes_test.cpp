#include "algorithms/people/place_in_boxes.h"

#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/test_room.h"

namespace mapbed {
namespace {

constexpr float kOnSomebody = 0.05F;
constexpr float kElsewhere = 0.95F;
constexpr double kWall = 3.0;  // [m] ahead of the robot, which stands at the origin

// Scans of a wall across the view, in front of which somebody may stand, and their labels: all
// within a box about him is dynamic.
class SomebodyAtAWall : public ::testing::Test {
 protected:
  struct Kind {
    bool has_wall = true, has_somebody = false, has_box = false;
  };

  void add(int times, const Kind& kind) {
    for (int i = 0; i < times; ++i) {
      TestRoom room({{{-1.0, -9.0}, {-1.0, 9.0}}});
      if (kind.has_wall) room.add({{kWall, -9.0}, {kWall, 9.0}});
      if (kind.has_somebody) room.add({{kWall - 0.3, -0.1}, {kWall - 0.3, 0.1}});
      const double time = static_cast<double>(scans_.size());
      LaserScan scan = scan_of(room, {}, {.max_range = 20.0}, time);
      std::vector<float> labels(scan.ranges.size(), kNoLabel);
      for (std::size_t b = 0; b < scan.ranges.size(); ++b) {
        if (scan.is_hit(b))
          labels[b] = kind.has_box && is_in_box(scan, b) ? kOnSomebody : kElsewhere;
      }
      labels_.push_back({time, 0, std::move(labels)});
      path_.push_back({time, {}});
      scans_.push_back({std::move(scan), {}});
    }
  }

  static bool is_in_box(const LaserScan& scan, std::size_t b) {
    const Eigen::Vector2d end = scan.point_on(b, scan.ranges[b]);
    return std::abs(end.x() - (kWall - 0.3)) < 0.4 && std::abs(end.y()) < 0.4;
  }

  struct Ends {
    int of_him = 0, beside_him = 0;
  };
  // Dynamic beams of the last scan, but for those at the edge of the box: others end beside them.
  Ends dynamic() const {
    Ends ends;
    const LaserScan& scan = scans_.back().readings;
    for (std::size_t b = 0; b < scan.ranges.size(); ++b) {
      if (!is_dynamic(labels_.back(), b)) continue;
      const Eigen::Vector2d end = scan.point_on(b, scan.ranges[b]);
      if (std::abs(end.y()) > 0.3) continue;
      ++(end.x() > kWall - 0.1 ? ends.beside_him : ends.of_him);
    }
    return ends;
  }

  void keep() { keep_the_place(scans_, path_, kElsewhere, labels_); }

  std::vector<KeptScan> scans_;
  Trajectory path_;
  BeamLabels labels_;
};

TEST_F(SomebodyAtAWall, IsLeftOutAndTheWallIsKept) {
  add(2, {});
  add(1, {.has_somebody = true, .has_box = true});
  const Ends before = dynamic();
  ASSERT_GT(before.of_him, 2);
  ASSERT_GT(before.beside_him, 3);
  keep();
  EXPECT_EQ(dynamic().of_him, before.of_him);
  EXPECT_EQ(dynamic().beside_him, 0);
}

TEST_F(SomebodyAtAWall, OneOtherScanProvesNoWall) {
  add(1, {});
  add(1, {.has_somebody = true, .has_box = true});
  const int before = dynamic().beside_him;
  keep();
  EXPECT_EQ(dynamic().beside_him, before);
}

TEST_F(SomebodyAtAWall, WhatIsSeenInBoxesAloneProvesNothing) {
  add(20, {.has_somebody = true, .has_box = true});
  const int before = dynamic().beside_him;
  keep();
  EXPECT_EQ(dynamic().beside_him, before);
}

// He stood there for a while before anybody knew, then went.
TEST_F(SomebodyAtAWall, IsNoPartOfThePlaceWhereMoreBeamsGoOnLater) {
  for (const auto& [longer, is_of_place] : {std::pair(7, false), std::pair(3, true)}) {
    scans_.clear(), labels_.clear(), path_.clear();
    add(5, {.has_somebody = true});
    add(longer, {});
    add(1, {.has_somebody = true, .has_box = true});
    const int before = dynamic().of_him;
    keep();
    EXPECT_EQ(dynamic().of_him, is_of_place ? 0 : before);
  }
}

TEST_F(SomebodyAtAWall, NothingChangesWhereNothingIsDynamic) {
  add(5, {.has_somebody = true});
  const BeamLabels before = labels_;
  keep();
  for (std::size_t k = 0; k < before.size(); ++k) {
    for (std::size_t b = 0; b < before[k].static_probability.size(); ++b) {
      const float p = before[k].static_probability[b], q = labels_[k].static_probability[b];
      EXPECT_TRUE(p == q || (std::isnan(p) && std::isnan(q)));
    }
  }
}

}  // namespace
}  // namespace mapbed
