#include "bench/sources/simulate.h"

#include <string>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/file/text_file.h"
#include "core/log/dialects/carmen_log.h"
#include "core/testing/temporary_folder.h"
#include "sim/truth.h"

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
    for (const char* ending : {".log", ".truth.gz", "_map.pgm", ".relations", ".tum"}) {
      bytes.push_back(read_text_file(folder.file(std::to_string(i) + ending)));
    }
  }
  return bytes;
}

TEST(Simulate, GivesTheSameLogTruthAndMapWithAnyNumberOfThreads) {
  const std::vector<std::string> alone = bytes_of_drives(1);
  EXPECT_EQ(alone, bytes_of_drives(2));
  EXPECT_EQ(alone, bytes_of_drives(8));
  EXPECT_NE(alone[0], alone[5]);  // another seed, another log
}

TEST(Simulate, APersonMoreChangesNobodyElsesNoise) {
  const SimulationResult without = run_simulation(short_drive(0), 1);
  const SimulationResult with = run_simulation(short_drive(1), 1);
  ASSERT_EQ(without.log.size(), with.log.size());
  std::size_t same = 0;
  std::size_t scan = 0;
  for (std::size_t i = 0; i < with.log.size(); ++i) {
    if (const auto* odometry = std::get_if<Odometry>(&with.log[i])) {
      EXPECT_EQ(odometry->odometry_from_robot,
                std::get<Odometry>(without.log[i]).odometry_from_robot);
      continue;
    }
    const auto& a = std::get<LaserScan>(without.log[i]).ranges;
    const auto& b = std::get<LaserScan>(with.log[i]).ranges;
    const auto& truth_a = without.recording.truth.scans[scan].beams;
    const auto& truth_b = with.recording.truth.scans[scan].beams;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const bool is_alone = without.recording.scans[scan].beam(k).size() == 1 &&
                            with.recording.scans[scan].beam(k).size() == 1;
      if (!is_alone || truth_a[k].range != truth_b[k].range) continue;  // he stands in this beam
      EXPECT_EQ(a[k], b[k]);
      ++same;
    }
    ++scan;
  }
  EXPECT_GT(same, 1000u);
}

TEST(Simulate, NoPeopleMeansNobody) {
  SimulationPlan plan{.world = "museum", .robot = "pioneer", .people = 0};
  const PreparedSimulation prepared = prepare_simulation(plan);
  EXPECT_EQ(prepared.simulation.people.walkers, 0);
  EXPECT_EQ(prepared.simulation.people.standing, 0);
  EXPECT_EQ(prepared.simulation.people.blockers, 0);
}

TEST(Simulate, WhatIsSetOfThePeopleWinsOverTheirNumber) {
  SimulationPlan plan{.world = "museum", .robot = "pioneer", .people = 15};
  plan.settings = {parse_setting("simulation.people.standing=7")};
  const PreparedSimulation prepared = prepare_simulation(plan);
  EXPECT_EQ(prepared.simulation.people.walkers, 12);
  EXPECT_EQ(prepared.simulation.people.standing, 7);
}

}  // namespace
}  // namespace mapbed
