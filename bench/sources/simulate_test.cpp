#include "bench/sources/simulate.h"

#include <algorithm>
#include <string>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "bench/sources/log_source.h"
#include "bench/sources/simulation_files.h"
#include "core/file/text_file.h"
#include "core/log/dialects/carmen_log.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

SimulationPlan short_drive(int people) {
  SimulationPlan plan{.world = "corridor", .robot = "pioneer", .people = people};
  plan.settings = {parse_setting("recorder.longest=2 s")};
  return plan;
}

// Log, truth and map of some drives, recorded by so many threads at a time.
std::vector<std::string> bytes_of_drives(int threads) {
  constexpr std::size_t kDrives = 4;
  const TemporaryFolder folder;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, kDrives, [&](std::size_t i) {
      write_simulation(folder.file(std::to_string(i) + ".log"), run_simulation(short_drive(3), i));
    });
  });
  std::vector<std::string> bytes;
  for (std::size_t i = 0; i < kDrives; ++i) {
    for (const char* ending : {".log", ".truth.gz", "_map.pgm", ".tum"}) {
      bytes.push_back(read_text_file(folder.file(std::to_string(i) + ending)));
    }
  }
  return bytes;
}

TEST(Simulate, GivesTheSameLogTruthAndMapWithAnyNumberOfThreads) {
  const std::vector<std::string> alone = bytes_of_drives(1);
  EXPECT_EQ(alone, bytes_of_drives(2));
  EXPECT_EQ(alone, bytes_of_drives(8));
  EXPECT_NE(alone[0], alone[4]);  // another seed, another log
}

TEST(Simulate, APersonMoreChangesNobodyElsesNoise) {
  const SimulationResult without = run_simulation(short_drive(0), 1);
  const SimulationResult with = run_simulation(short_drive(1), 1);
  ASSERT_EQ(without.log.size(), with.log.size());
  std::size_t same = 0;
  for (std::size_t i = 0; i < with.log.size(); ++i) {
    if (const auto* odometry = std::get_if<Odometry>(&with.log[i])) {
      EXPECT_EQ(odometry->odometry_from_robot,
                std::get<Odometry>(without.log[i]).odometry_from_robot);
      continue;
    }
    const auto& a = std::get<LaserScan>(without.log[i]).ranges;
    const auto& b = std::get<LaserScan>(with.log[i]).ranges;
    const auto& ideal_a = std::get<IdealScan>(without.recording.readings[i]);
    const auto& ideal_b = std::get<IdealScan>(with.recording.readings[i]);
    for (std::size_t k = 0; k < a.size(); ++k) {
      const bool is_alone = ideal_a.beam(k).size() == 1 && ideal_b.beam(k).size() == 1;
      // He may stand in this beam.
      if (!is_alone || ideal_a.beam(k)[0].range != ideal_b.beam(k)[0].range) continue;
      EXPECT_EQ(a[k], b[k]);
      ++same;
    }
  }
  EXPECT_GT(same, 1000u);
}

// Every option of it, written out, is a scenario that gives the same bytes.
TEST(Simulate, TheConfigurationBesideALogSimulatesItAgain) {
  const TemporaryFolder folder;
  SimulationPlan plan = short_drive(2);
  plan.settings.push_back(parse_setting("world.doors_a_side=2"));
  plan.settings.push_back(parse_setting("robot.front.sensor=hokuyo_urg04lx"));
  plan.settings.push_back(parse_setting("robot.front.noise.bias=1 cm"));
  plan.settings.push_back(parse_setting("driver.speed=0.3 m/s"));
  write_simulation(folder.file("a.log"), run_simulation(plan, 7));

  Settings written = load_settings(folder.file("a.config.yaml"));
  ASSERT_EQ(written.front().path, "seed");
  EXPECT_EQ(written.front().text, "7");
  written.erase(written.begin());
  std::erase_if(written, [](const Setting& setting) { return setting.path == "files"; });
  write_simulation(folder.file("b.log"), run_simulation(simulation_plan(written), 7));
  for (const char* ending : {".log", ".truth.gz", "_map.pgm", ".config.yaml"}) {
    EXPECT_EQ(read_text_file(folder.file(std::string("a") + ending)),
              read_text_file(folder.file(std::string("b") + ending)));
  }
}

TEST(Simulate, AWrongDriverIsRefusedWithTheNearestOne) {
  SimulationPlan plan = short_drive(0);
  plan.driver = "scriptd";
  EXPECT_INPUT_ERROR(prepare_simulation(plan),
                     "unknown driver 'scriptd'; did you mean 'scripted'?");
}

TEST(Simulate, WhoDrivesSuitsTheDriveAndOneWhoCannotIsRefused) {
  SimulationPlan plan = short_drive(0);
  plan.robot = "f1tenth";
  EXPECT_NE(prepare_simulation(plan).config.find("driver: car\n"), std::string::npos);
  plan.driver = "scripted";
  EXPECT_INPUT_ERROR(prepare_simulation(plan),
                     "driver 'scripted' cannot drive robot 'f1tenth' (ackermann); take driver "
                     "'car'");
}

TEST(Simulate, AnotherSensorOfTheShelfIsRecorded) {
  SimulationPlan plan = short_drive(0);
  plan.settings.push_back(parse_setting("robot.front.sensor=rplidar_a1"));
  const SimulationResult result = run_simulation(plan, 1);
  const auto scan = std::find_if(result.log.begin(), result.log.end(), [](const auto& m) {
    return std::holds_alternative<LaserScan>(m);
  });
  ASSERT_NE(scan, result.log.end());
  EXPECT_EQ(std::get<LaserScan>(*scan).ranges.size(), 360u);
}

TEST(Simulate, SensorSettingsThatDoNotGoTogetherAreRefused) {
  SimulationPlan plan = short_drive(0);
  plan.settings.push_back(parse_setting("robot.front.scan_rate=100 Hz"));
  EXPECT_INPUT_ERROR(prepare_simulation(plan), "sweeps come faster than the mirror turns");
}

TEST(Simulate, SettingsThatLeaveARobotWithoutAFootprintAreRefused) {
  SimulationPlan plan = short_drive(0);
  plan.settings.push_back(parse_setting("robot.footprint.width=0 m"));
  EXPECT_INPUT_ERROR(prepare_simulation(plan), "the footprint is neither a circle nor a box");
}

TEST(Simulate, PartsAreReadAndBuiltOnce) {
  SimulationParts parts;
  SimulationPlan plan = short_drive(0);
  const PreparedSimulation one = prepare_simulation(plan, parts);
  plan.settings.push_back(parse_setting("robot.front.noise.bias=1 cm"));
  const PreparedSimulation other = prepare_simulation(plan, parts);
  EXPECT_EQ(one.world, other.world);
  EXPECT_EQ(one.noiseless_config, other.noiseless_config);
  EXPECT_NE(one.config, other.config);
  plan.settings.push_back(parse_setting("robot.front.pitch=10 deg"));
  EXPECT_NE(prepare_simulation(plan, parts).noiseless_config, one.noiseless_config);
}

TEST(Simulate, NoPeopleMeansNobody) {
  SimulationPlan plan{.world = "museum", .robot = "pioneer", .people = 0};
  const PreparedSimulation prepared = prepare_simulation(plan);
  EXPECT_EQ(prepared.simulation.actors.people.walkers, 0);
  EXPECT_EQ(prepared.simulation.actors.people.standing, 0);
  EXPECT_EQ(prepared.simulation.actors.people.blockers, 0);
}

TEST(Simulate, WhatIsSetOfThePeopleWinsOverTheirNumber) {
  SimulationPlan plan{.world = "museum", .robot = "pioneer", .people = 15};
  plan.settings = {parse_setting("simulation.people.standing=7")};
  const PreparedSimulation prepared = prepare_simulation(plan);
  EXPECT_EQ(prepared.simulation.actors.people.walkers, 12);
  EXPECT_EQ(prepared.simulation.actors.people.standing, 7);
}

}  // namespace
}  // namespace mapbed
