#include "bench/film/course.h"

#include <gmock/gmock.h>

#include "algorithms/estimator.h"
#include "bench/sources/run_input.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LaserScan scan_at(double time) {
  return {.time = time, .bearing_step = 0.1, .max_range = 10.0, .ranges = {2.0}};
}

// Believes what it is told.
class Told : public Estimator {
 public:
  void add(const Measurement& /*measurement*/, std::span<const float> /*weights*/) override {}
  Pose2 pose() const override { return path.back().pose; }
  Estimate estimate() const override { return {.trajectory = path}; }
  Hypotheses hypotheses() const override { return held; }

  Trajectory path;
  Hypotheses held;
};

// A robot that goes 1 m/s along x and has a scan every second, from 100 s to 110 s; in truth from
// (5, 5) along y.
class CourseOf : public ::testing::Test {
 protected:
  CourseOf() {
    for (int second = 0; second <= 10; ++second) {
      input_.log.push_back(scan_at(100.0 + second));
      input_.truth.push_back({100.0 + second, {5.0, 5.0 + second, M_PI / 2}});
    }
  }

  CourseRecorder recorder(const CourseMoments& moments) {
    return {[this, moments](double length) {
              length_ = length;
              return moments;
            },
            [](double) {}, [this] { return goes_on_; }};
  }
  void drive(CourseRecorder& recorder) {
    for (const Measurement& measurement : input_.log) {
      const double time = time_of(measurement);
      method_.path.push_back({time, {time - 100.0, 0.0, 0.0}});
      recorder.after(measurement, method_);
    }
  }

  RunInput input_;
  Told method_;
  double length_ = 0.0;
  bool goes_on_ = true;
};

std::vector<double> times_of(const Course& course) {
  std::vector<double> times;
  for (const CourseStep& step : course.steps) times.push_back(step.time);
  return times;
}

TEST_F(CourseOf, HasAStepForEachMomentThatIsLookedAt) {
  CourseRecorder recorder = this->recorder({.from = 2.0, .to = 8.0, .step = 3.0});
  recorder.begins(input_, "told");
  EXPECT_THROW(drive(recorder), Interrupted) << "the run ends there";
  EXPECT_TRUE(recorder.is_complete());
  EXPECT_EQ(length_, 10.0);
  EXPECT_THAT(times_of(recorder.course()), ElementsAre(102.0, 105.0, 108.0));
  EXPECT_EQ(recorder.course().of_map.size(), 9u) << "also before the first moment";
}

TEST_F(CourseOf, OfARobotThatStandsPutsAScanIntoTheMapEveryFiveSeconds) {
  CourseRecorder recorder = this->recorder({.step = 20.0});
  recorder.begins(input_, "told");
  for (const Measurement& measurement : input_.log) {
    method_.path.push_back({time_of(measurement), {0.0, 0.0, 0.0}});
    recorder.after(measurement, method_);
  }
  EXPECT_THAT(recorder.course().of_map, ElementsAre(0u, 5u, 10u));
}

TEST_F(CourseOf, TellsOfAPathWhatHasChanged) {
  CourseRecorder recorder = this->recorder({.step = 1.0});
  recorder.begins(input_, "told");
  method_.path = {{100.0, {0.0, 0.0, 0.0}}};
  recorder.after(input_.log[0], method_);
  method_.path = {{100.0, {0.0, 0.0, 0.0}}, {101.0, {1.0, 0.0, 0.0}}};
  recorder.after(input_.log[1], method_);
  method_.path = {{100.0, {0.0, 0.0, 0.0}}, {101.0, {1.0, 0.5, 0.0}}, {102.0, {2.0, 1.0, 0.0}}};
  recorder.after(input_.log[2], method_);
  const std::vector<CourseStep>& steps = recorder.course().steps;
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[1].kept, 1u);
  EXPECT_EQ(steps[2].kept, 1u) << "the second pose was another one";
  EXPECT_THAT(steps[2].later, ElementsAre(Pose2{1.0, 0.5, 0.0}, Pose2{2.0, 1.0, 0.0}));
}

TEST_F(CourseOf, LiesInTheWorldByTheFirstPose) {
  CourseRecorder recorder = this->recorder({.step = 1.0});
  recorder.begins(input_, "told");
  drive(recorder);
  recorder.ends(method_.estimate());
  const Pose2 last = recorder.course().world_from_map * Pose2{10.0, 0.0, 0.0};
  EXPECT_NEAR(last.x, 5.0, 1e-9);
  EXPECT_NEAR(last.y, 15.0, 1e-9);
  EXPECT_TRUE(recorder.course().last.has_value());
}

TEST_F(CourseOf, ParticlesMoveOnWithTheRobotSinceTheLastUpdate) {
  CourseRecorder recorder = this->recorder({.step = 1.0});
  recorder.begins(input_, "told");
  method_.path = {{100.0, {0.0, 0.0, 0.0}}};
  recorder.after(input_.log[0], method_);
  method_.path.push_back({101.0, {1.0, 0.0, 0.0}});
  // Of the update at 100 s, one of them turned to the left.
  method_.held.branches = {{{100.0, {0.0, 0.0, 0.0}}}, {{100.0, {0.0, 0.2, M_PI / 2}}}};
  recorder.after(input_.log[1], method_);
  const std::vector<Pose2>& particles = recorder.course().steps.back().particles;
  ASSERT_EQ(particles.size(), 2u);
  EXPECT_NEAR(particles[0].x, 1.0, 1e-9);
  EXPECT_NEAR(particles[1].y, 1.2, 1e-9);
  EXPECT_NEAR(particles[1].x, 0.0, 1e-9);
}

TEST_F(CourseOf, OfAProgramThatShowsNothingIsItsPathFromScanToScan) {
  CourseRecorder recorder = this->recorder({.from = 1.0, .step = 4.0});
  recorder.begins(input_, "program");
  Estimate estimate;
  for (int second = 1; second <= 10; ++second) {  // nothing of the first scan
    estimate.trajectory.push_back({100.0 + second, {1.0 * second, 0.0, 0.0}});
  }
  recorder.ends(estimate);
  EXPECT_TRUE(recorder.is_complete());
  EXPECT_THAT(times_of(recorder.course()), ElementsAre(101.0, 105.0, 109.0));
  EXPECT_EQ(recorder.course().steps.back().later.size(), 4u);
  EXPECT_THAT(recorder.course().steps.back().particles, IsEmpty());
}

// Of each scan the one beam is called dynamic; somebody is followed 3 m ahead of the start.
Estimate telling_what_moves(const Trajectory& path) {
  Estimate estimate{.trajectory = path, .labels = BeamLabels{}};
  for (const Stamped<Pose2>& pose : path) estimate.labels->push_back({pose.time, 0, {0.1F}});
  estimate.tracks = Tracks{{1, {{.time = 100.0, .position = {3.0, 0.0}}}}};
  return estimate;
}

class TellsWhatMoves : public Told {
 public:
  Estimate estimate() const override { return telling_what_moves(path); }
};

void expect_what_moves(const Course& course) {
  ASSERT_EQ(course.labels.size(), course.scans.size());
  EXPECT_TRUE(is_dynamic(course.labels.begin()->second, 0));
  ASSERT_EQ(course.tracks.size(), 1u);
  // The map's x axis is the world's y axis, and it begins at (5, 5).
  EXPECT_NEAR((course.tracks[0].states[0].position - Eigen::Vector2d(5.0, 8.0)).norm(), 0.0, 1e-9);
}

TEST_F(CourseOf, TellsWhatMovesAsItIsHeldInTheEnd) {
  CourseRecorder recorder = this->recorder({.step = 1.0});
  recorder.begins(input_, "told");
  drive(recorder);
  EXPECT_TRUE(recorder.course().labels.empty());
  recorder.ends(telling_what_moves(method_.path));
  expect_what_moves(recorder.course());
}

TEST_F(CourseOf, TellsWhatMovesWhereItEndsBeforeTheRun) {
  CourseRecorder recorder = this->recorder({.to = 4.0, .step = 1.0});
  recorder.begins(input_, "told");
  TellsWhatMoves method;
  EXPECT_THROW(
      {
        for (const Measurement& measurement : input_.log) {
          const double time = time_of(measurement);
          method.path.push_back({time, {time - 100.0, 0.0, 0.0}});
          recorder.after(measurement, method);
        }
      },
      Interrupted);
  expect_what_moves(recorder.course());
}

TEST_F(CourseOf, EndsWhereItIsNotToGoOn) {
  CourseRecorder recorder = this->recorder({.step = 1.0});
  recorder.begins(input_, "told");
  goes_on_ = false;
  EXPECT_THROW(drive(recorder), Interrupted);
  EXPECT_FALSE(recorder.is_complete());
}

}  // namespace
}  // namespace mapbed
