#include "algorithms/segments/segment_filter.h"

#include <cmath>
#include <functional>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/people/testing/people_in_a_room.h"

namespace mapbed {
namespace {

using ::testing::Each;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TestRoom hall() {
  TestRoom room = rectangular_room(30.0, 20.0);
  room.add_box({3.0, -8.0}, 0.6, 0.6);
  room.add_box({-4.0, 6.0}, 2.0, 0.5);
  add_leg(room, {2.0, -4.0});
  return room;
}

// What moves: how it is put into the hall, and half of its longest side.
struct Thing {
  std::string name;
  std::function<void(TestRoom&, const Eigen::Vector2d&)> add;
  double half;   // [m]
  double speed;  // [m/s]
};

const Thing kCar{"Car", [](TestRoom& r, const Eigen::Vector2d& at) { r.add_box(at, 1.8, 4.0); },
                 2.0, 2.0};
const Thing kChair{
    "Chair", [](TestRoom& r, const Eigen::Vector2d& at) { r.add_box(at, 0.45, 0.45); }, 0.23, 0.5};
const Thing kPerson{"Person", [](TestRoom& r, const Eigen::Vector2d& at) { add_person(r, at); },
                    0.2, 1.2};

struct Drive {
  std::vector<LaserScan> scans;
  std::vector<Eigen::Vector2d> positions;  // of the thing; nowhere() where there is none
};

// Seen by a robot that stands at the origin: `before` scans without it or with it where it begins,
// then it goes from (5, -5) to (5, 5), then it stays for `after` scans.
Drive drive_of(const Thing& thing, std::size_t before, bool stands_there, std::size_t after = 0) {
  Drive drive;
  const Eigen::Vector2d from(5.0, -3.0), to(5.0, 4.0);
  drive.positions.assign(before, stands_there ? from : nowhere());
  walk(drive.positions, from, to, thing.speed);
  drive.positions.insert(drive.positions.end(), after, to);
  for (std::size_t k = 0; k < drive.positions.size(); ++k) {
    TestRoom room = hall();
    if (std::isfinite(drive.positions[k].x())) thing.add(room, drive.positions[k]);
    drive.scans.push_back(
        scan_of(room, {}, round_laser(), 100.0 + kScanPeriod * static_cast<double>(k)));
  }
  return drive;
}

struct Filtered {
  FilterResult result;
  std::vector<std::vector<float>> weights;
};

Filtered filtered(const std::vector<LaserScan>& scans, const SegmentFilterOptions& options = {},
                  const Trajectory& path = {}) {
  SegmentFilter filter(options);
  Filtered all;
  Trajectory stands;
  for (const LaserScan& scan : scans) {
    const Pose2 pose = path.empty() ? Pose2{} : path[stands.size()].pose;
    filter.add(Odometry{.time = scan.time, .odometry_from_robot = pose});
    all.weights.push_back(filter.add(scan, {}));
    stands.push_back({scan.time, pose});
  }
  all.result = filter.result(stands);
  return all;
}

struct Count {
  int beams = 0;
  int dynamic = 0;
  double fraction() const { return static_cast<double>(dynamic) / beams; }
};

// Of beams that end within `reach` of the thing, from scan `first` on, or of all others.
Count count(const Drive& drive, const BeamLabels& labels, double reach, bool on_it,
            std::size_t first, std::size_t last) {
  Count count;
  for (std::size_t k = first; k < last; ++k) {
    for (std::size_t b = 0; b < drive.scans[k].ranges.size(); ++b) {
      if (!drive.scans[k].is_hit(b)) continue;
      const Eigen::Vector2d end = drive.scans[k].point_on(b, drive.scans[k].ranges[b]);
      const Eigen::Vector2d off = (end - drive.positions[k]).cwiseAbs();
      if ((off.maxCoeff() <= reach) != on_it) continue;
      ++count.beams;
      if (is_dynamic(labels[k], b)) ++count.dynamic;
    }
  }
  return count;
}

// It comes to where nobody was, crosses the view, and stays where it came to.
constexpr std::size_t kBefore = 20;  // scans
constexpr std::size_t kAfter = 60;

struct Crossing {
  Drive drive;
  Filtered all;
  std::size_t stops() const { return drive.scans.size() - kAfter; }  // index of the first scan
};

const Crossing& crossing_of(const Thing& thing) {
  static std::map<std::string, Crossing> done;
  const auto found = done.find(thing.name);
  if (found != done.end()) return found->second;
  const Drive drive = drive_of(thing, kBefore, false, kAfter);
  return done.emplace(thing.name, Crossing{drive, filtered(drive.scans)}).first->second;
}

class ASegmentFilter : public ::testing::TestWithParam<Thing> {};

TEST_P(ASegmentFilter, LabelsBeamsOfWhatMovesAndNoOthers) {
  const Thing& thing = GetParam();
  const Crossing& c = crossing_of(thing);
  const BeamLabels& labels = c.all.result.labels;
  const double reach = thing.half + 0.02;
  EXPECT_GT(count(c.drive, labels, reach, true, kBefore, c.stops()).fraction(), 0.95);
  EXPECT_GT(count(c.drive, labels, reach, true, c.stops(), labels.size()).fraction(), 0.95)
      << "it is kept where it stops";
  EXPECT_LT(count(c.drive, labels, reach, false, kBefore, labels.size()).fraction(), 0.002);
  EXPECT_EQ(count(c.drive, labels, reach, false, 0, kBefore).dynamic, 0);
}

TEST_P(ASegmentFilter, FollowsItUnderOneNumber) {
  const Thing& thing = GetParam();
  const Crossing& c = crossing_of(thing);
  ASSERT_THAT(*c.all.result.tracks, SizeIs(1));
  const ObjectTrack& track = c.all.result.tracks->front();
  EXPECT_GE(track.states.size() + 5, c.drive.scans.size() - kBefore);
  const auto scan_of_state = [](const TrackState& state) {
    return static_cast<std::size_t>(std::lround((state.time - 100.0) / kScanPeriod));
  };
  for (const TrackState& state : track.states) {
    // Only the side that is seen is known: its middle is off by half of the thing at most.
    EXPECT_LT((state.position - c.drive.positions[scan_of_state(state)]).norm(), thing.half + 0.25);
    if (scan_of_state(state) + 1 == c.stops()) {
      EXPECT_NEAR(state.velocity.y(), thing.speed, 0.3 * thing.speed + 0.1);
    }
  }
}

TEST_P(ASegmentFilter, LeavesItOutOfTheAlignmentOnceItHasMoved) {
  const Thing& thing = GetParam();
  const Crossing& c = crossing_of(thing);
  const std::size_t k = c.stops() - 1;
  const LaserScan& scan = c.drive.scans[k];
  for (std::size_t b = 0; b < scan.ranges.size(); ++b) {
    const Eigen::Vector2d end = scan.point_on(b, scan.ranges[b]);
    const double off = (end - c.drive.positions[k]).cwiseAbs().maxCoeff();
    EXPECT_EQ(c.all.weights[k][b], off < thing.half + 0.02 ? 0.0F : 1.0F) << b;
  }
}

TEST_P(ASegmentFilter, LabelsItAlsoBeforeItWent) {
  const Thing& thing = GetParam();
  const Drive drive = drive_of(thing, 30, true);
  const double reach = thing.half + 0.02;
  const Filtered all = filtered(drive.scans);
  EXPECT_GT(count(drive, all.result.labels, reach, true, 0, 30).fraction(), 0.9);
  const Filtered forward_alone = filtered(drive.scans, {.follow_back = false});
  EXPECT_EQ(count(drive, forward_alone.result.labels, reach, true, 0, 30).dynamic, 0);
}

INSTANTIATE_TEST_SUITE_P(Things, ASegmentFilter, ::testing::Values(kCar, kChair, kPerson),
                         [](const auto& thing) { return thing.param.name; });

TEST(SegmentFilter, FindsNothingWhereOnlyTheRobotMoves) {
  std::vector<LaserScan> scans;
  Trajectory path;
  for (int k = 0; k < 80; ++k) {
    const double time = 100.0 + kScanPeriod * k;
    path.push_back({time, {0.05 * k, 0.01 * k, 0.01 * k}});
    scans.push_back(scan_of(hall(), path.back().pose, round_laser(), time));
  }
  const Filtered all = filtered(scans, {}, path);
  EXPECT_THAT(*all.result.tracks, IsEmpty());
  for (const ScanLabels& labels : all.result.labels) {
    for (const float p : labels.static_probability) EXPECT_FALSE(is_dynamic(p));
  }
}

// The wall is where nobody looked before, and comes into view beside who walks.
TEST(SegmentFilter, TakesNoWallThatComesIntoViewForAPartOfWhoWalks) {
  std::vector<LaserScan> scans;
  Trajectory path;
  std::vector<Eigen::Vector2d> positions;
  walk(positions, {2.5, -2.0}, {2.5, 2.0}, 1.0);
  walk(positions, {2.5, 2.0}, {-1.0, 3.2}, 1.0);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    TestRoom room = rectangular_room(12.0, 7.4);  // its wall is 0.5 m behind him in the end
    add_person(room, positions[k]);
    const double time = 100.0 + kScanPeriod * static_cast<double>(k);
    const double turned = k < 40 ? 0.0 : 0.05 * static_cast<double>(k - 40);
    path.push_back({time, {0.0, 0.0, turned}});
    scans.push_back(scan_of(room, path.back().pose, TestLaser{.max_range = 20.0}, time));
  }
  const Filtered all = filtered(scans, {}, path);
  int on_wall = 0, walls = 0;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    for (std::size_t b = 0; b < scans[k].ranges.size(); ++b) {
      const Eigen::Vector2d end = path[k].pose * scans[k].point_on(b, scans[k].ranges[b]);
      if ((end - positions[k]).norm() < 0.3) continue;
      ++walls;
      on_wall += is_dynamic(all.result.labels[k], b) ? 1 : 0;
    }
  }
  ASSERT_GT(walls, 10'000);
  EXPECT_LT(on_wall, 0.005 * walls);
}

TEST(SegmentFilter, OfScansThatSawNothingSaysNothing) {
  std::vector<LaserScan> scans;
  for (int k = 0; k < 5; ++k) {
    LaserScan scan = scan_of(hall(), {}, round_laser(), 100.0 + k);
    scan.ranges.assign(scan.ranges.size(), k % 2 == 0 ? 0.0 : scan.max_range);
    if (k == 4) scan.ranges.clear();
    scans.push_back(scan);
  }
  const Filtered all = filtered(scans);
  EXPECT_THAT(*all.result.tracks, IsEmpty());
  EXPECT_THAT(all.weights[0], Each(1.0F));
  EXPECT_THAT(all.result.labels, SizeIs(5));
  for (const float p : all.result.labels[0].static_probability) EXPECT_TRUE(std::isnan(p));
}

}  // namespace
}  // namespace mapbed
