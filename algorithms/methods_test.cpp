#include "algorithms/methods.h"

#include <gmock/gmock.h>

#include "algorithms/lazy_association/lazy_slam_options.h"
#include "algorithms/motion/motion_learning.h"
#include "algorithms/rbpf/grid_slam.h"
#include "algorithms/submaps/graph_slam_options.h"
#include "algorithms/testing/remark_texts.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Methods, AreFoundByNameAndListTheirOptions) {
  OccupancyMap map(1.0);
  map.at({0, 0}) = known(0.0);
  const Given given{.map = std::make_shared<OccupancyMap>(map)};
  for (const Method& method : methods()) {
    EXPECT_EQ(method_by_name(method.name).name, method.name);
    EXPECT_FALSE(method.about.empty()) << method.name;
    const ConfiguredMethod configured = method.configure({});
    EXPECT_NE(configured.make(given, Rng(1)), nullptr) << method.name;
    EXPECT_FALSE(configured.complete_yaml.empty()) << method.name;
  }
}

TEST(Methods, OneThatNeedsAMapIsRefusedWithoutAndInOneWithoutFreeSpace) {
  const ConfiguredMethod localization = method_by_name("localization").configure({});
  EXPECT_TRUE(method_by_name("localization").needs_map);
  EXPECT_INPUT_ERROR(localization.make({}, Rng(1)), "--map MAP.yaml");
  const Given nothing{.map = std::make_shared<OccupancyMap>(0.05)};
  EXPECT_INPUT_ERROR(localization.make(nothing, Rng(1)), "nothing of the map is free");
}

TEST(Methods, AMisspeltNameGetsTheNearestOne) {
  EXPECT_INPUT_ERROR(method_by_name("odometri"),
                     "unknown method 'odometri'; did you mean 'odometry'?");
}

TEST(Methods, ASettingThatNoOptionTakesIsAnError) {
  const Settings settings{parse_setting("longest_gapp=2 s")};
  EXPECT_INPUT_ERROR(method_by_name("odometry").configure(settings),
                     "unknown key 'longest_gapp' in odometry");
}

TEST(Methods, SettingsReachTheCompleteConfiguration) {
  const Settings settings{parse_setting("longest_gap=250 ms")};
  EXPECT_THAT(method_by_name("odometry").configure(settings).complete_yaml,
              HasSubstr("longest_gap: 0.25 s"));
}

class EveryMethod : public ::testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Estimator> made() const {
    return method_by_name(GetParam()).configure({}).make({}, Rng(1));
  }
  static RecordedLog drive() {
    return drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1));
  }
  static void expect_same_path(const Estimator& a, const Estimator& b) {
    const Trajectory of_a = a.estimate().trajectory, of_b = b.estimate().trajectory;
    ASSERT_EQ(of_a.size(), of_b.size());
    for (std::size_t i = 0; i < of_a.size(); ++i) EXPECT_EQ(of_a[i].pose, of_b[i].pose);
  }

  static Trajectory path(const Given& given) {
    const RecordedLog log = drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}},
                                          {.forward_sigma = 0.0, .turn_sigma = 0.0}, Rng(1));
    const auto method = method_by_name(GetParam()).configure({}).make(given, Rng(1));
    for (const Measurement& measurement : log.measurements) method->add(measurement);
    method->finish();
    return method->estimate().trajectory;
  }
};

// The map's cells lie otherwise in the room then, so that matches differ by a part of a cell.
TEST_P(EveryMethod, StartsWhereItIsTold) {
  const Pose2 start{2.0, -1.0, 0.7};
  const Trajectory path_from_origin = path({});
  const Trajectory path_from_start = path({.start = start});
  ASSERT_EQ(path_from_start.size(), path_from_origin.size());
  EXPECT_EQ(path_from_origin.front().pose, Pose2{});
  EXPECT_EQ(path_from_start.front().pose, start);
  EXPECT_THAT(path_from_start.back().pose,
              IsNear(start * path_from_origin.back().pose, Tolerance{0.05, 0.02}));
}

// Somebody walks along beside the robot.
TEST_P(EveryMethod, TakesBeamsThatWeighNothingAsFailed) {
  const auto weighted = made(), failed = made();
  for (const Measurement& measurement : drive().measurements) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) {
      weighted->add(measurement);
      failed->add(measurement);
      continue;
    }
    LaserScan with_person = *scan, with_failures = *scan;
    std::vector<float> weights(scan->ranges.size(), 1.0F);
    for (std::size_t beam = 30; beam < 70; ++beam) {
      with_person.ranges[beam] = 0.6;
      with_failures.ranges[beam] = 0.0;
      weights[beam] = 0.0F;
    }
    weighted->add(with_person, weights);
    failed->add(with_failures);
  }
  expect_same_path(*weighted, *failed);
}

TEST_P(EveryMethod, WeighsBeamsByTheirWeights) {
  const auto half = made(), full = made(), plain = made();
  for (const Measurement& measurement : drive().measurements) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    const std::size_t beams = scan != nullptr ? scan->ranges.size() : 0;
    half->add(measurement, std::vector<float>(beams, 0.5F));
    full->add(measurement, std::vector<float>(beams, 1.0F));
    plain->add(measurement);
  }
  expect_same_path(*full, *plain);
  // What a half counts is tested with the likelihoods. Here: that it reaches each method.
  const Trajectory by_half = half->estimate().trajectory;
  ASSERT_EQ(by_half.size(), plain->estimate().trajectory.size());
  if (GetParam() != "odometry") {  // the prediction counts twice as much
    EXPECT_NE(by_half.back().pose, plain->estimate().trajectory.back().pose);
  }
}

TEST_P(EveryMethod, LeavesATiltedLaserOutAndSaysSo) {
  const auto both = made(), level = made();
  for (const Measurement& measurement : drive().measurements) {
    both->add(measurement);
    level->add(measurement);
    if (const auto* scan = std::get_if<LaserScan>(&measurement)) {
      LaserScan tilted = *scan;
      tilted.laser = 1;
      tilted.robot_from_laser.pitch = radians(10.0);
      for (double& range : tilted.ranges) range = std::min(range, 1.5);  // the floor
      both->add(tilted);
    }
  }
  expect_same_path(*both, *level);
  EXPECT_THAT(texts_of(both->estimate().remarks),
              Contains(HasSubstr("laser 1 is tilted by 10 degrees")));
  EXPECT_THAT(texts_of(level->estimate().remarks), Not(Contains(HasSubstr("laser"))));
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod,
                         ::testing::Values("odometry", "scan_matching", "correlative", "icp",
                                           "rbpf", "maximum_likelihood", "graph", "lazy", "em"),
                         [](const auto& method) { return method.param; });

TEST(Methods, OfLocalMapsTakeLearnedErrorModelsByName) {
  GraphSlamOptions graph;
  LazySlamOptions lazy;
  for (NodeChainOptions* chain : {&graph.chain, &lazy.chain}) {
    chain->odometry_errors = load_motion_model("pioneer_odometry");
    chain->matching_errors = load_motion_model("pioneer_matching");
  }
  const Settings settings{parse_setting("odometry_errors=pioneer_odometry"),
                          parse_setting("matching_errors=pioneer_matching")};
  const auto complete = [&](const std::string& name) {
    const ConfiguredMethod method = method_by_name(name).configure(settings);
    EXPECT_EQ(method.files.size(), 2u) << name;
    return method.complete_yaml;
  };
  EXPECT_EQ(complete("graph"), to_yaml(options_of(graph)));
  EXPECT_EQ(complete("lazy"), to_yaml(options_of(lazy)));
}

class MethodWithErrorModels : public ::testing::TestWithParam<std::string> {};

TEST_P(MethodWithErrorModels, TakesLearnedOnesByName) {
  GridSlamOptions expected;
  expected.odometry_errors = load_motion_model("pioneer_odometry");
  expected.matching_errors = load_motion_model("pioneer_matching");
  expected.best_only_after_loop = GetParam() == "maximum_likelihood";
  const Settings settings{parse_setting("odometry_errors=pioneer_odometry"),
                          parse_setting("matching_errors=pioneer_matching")};
  EXPECT_EQ(method_by_name(GetParam()).configure(settings).complete_yaml,
            to_yaml(options_of(expected)));
}

TEST_P(MethodWithErrorModels, TheLaterOfModelAndParameterWins) {
  const Settings model{parse_setting("odometry_errors=pioneer_odometry")};
  const Settings parameter{parse_setting("odometry_errors.rotation_bias=0.25")};
  const auto complete = [&](const Settings& first, const Settings& second) {
    Settings both = first;
    both.insert(both.end(), second.begin(), second.end());
    return method_by_name(GetParam()).configure(both).complete_yaml;
  };
  EXPECT_THAT(complete(model, parameter), HasSubstr("rotation_bias: 0.25"));
  EXPECT_THAT(complete(parameter, model), Not(HasSubstr("rotation_bias: 0.25")));
}

TEST_P(MethodWithErrorModels, AMisspeltModelIsToldWithItsPlace) {
  const Settings settings{{"matching_errors", "pioner_matching", {"my.yaml", 9}}};
  EXPECT_INPUT_ERROR(method_by_name(GetParam()).configure(settings),
                     "my.yaml:9: unknown motion model 'pioner_matching'; did "
                     "you mean 'pioneer_matching'?");
}

TEST_P(MethodWithErrorModels, TheStandardFilterCannotLeaveOdometryOut) {
  const Settings settings{{"proposal", "odometry", {"my.yaml", 4}},
                          {"matcher.use_odometry", "false", {"my.yaml", 7}}};
  EXPECT_INPUT_ERROR(method_by_name(GetParam()).configure(settings).complete_yaml,
                     "my.yaml:7: proposal 'odometry' needs the");
  EXPECT_NO_THROW(method_by_name(GetParam()).configure({settings[0]}).complete_yaml);
  EXPECT_NO_THROW(method_by_name(GetParam()).configure({settings[1]}).complete_yaml);
}

INSTANTIATE_TEST_SUITE_P(Methods, MethodWithErrorModels,
                         ::testing::Values("rbpf", "maximum_likelihood"),
                         [](const auto& method) { return method.param; });

TEST(Em, TakesAnyMethodForItsPathWithThatOnesOptions) {
  const Settings settings{parse_setting("path=rbpf"), parse_setting("rbpf.particles=7"),
                          parse_setting("iterations=1")};
  const ConfiguredMethod em = method_by_name("em").configure(settings);
  EXPECT_THAT(em.complete_yaml, HasSubstr("path: rbpf"));
  EXPECT_THAT(em.complete_yaml, HasSubstr("particles: 7"));
  EXPECT_INPUT_ERROR(method_by_name("em").configure({parse_setting("path=em")}),
                     "em cannot find its own path");
  EXPECT_INPUT_ERROR(method_by_name("em").configure({parse_setting("rbpf.particles=7")}),
                     "unknown key 'rbpf");
}

// One iteration registers the scans once.
TEST(Em, OfOneIterationHasThePathOfTheParticleFilter) {
  const auto alone =
      method_by_name("rbpf").configure({parse_setting("particles=7")}).make({}, Rng(3));
  const auto em = method_by_name("em")
                      .configure({parse_setting("path=rbpf"), parse_setting("rbpf.particles=7"),
                                  parse_setting("iterations=1")})
                      .make({}, Rng(3));
  const RecordedLog log =
      drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1));
  for (const Measurement& measurement : log.measurements) {
    alone->add(measurement);
    em->add(measurement);
  }
  alone->finish();
  em->finish();
  const Trajectory expected = alone->estimate().trajectory, found = em->estimate().trajectory;
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].pose, expected[i].pose);
  EXPECT_TRUE(em->estimate().labels.has_value());
}

}  // namespace
}  // namespace mapbed
