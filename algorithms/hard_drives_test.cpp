// What tells things that move, on drives that say little or nothing of them: finite, a label of
// each scan, and a remark at most.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/beam_filters.h"
#include "algorithms/filtered_estimator.h"
#include "algorithms/methods.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

SensorLog drive() {
  return drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {0.0, 0.2}}, {}, Rng(1))
      .measurements;
}

// What `change` makes of each scan.
template <class Change>
SensorLog changed(SensorLog log, Change&& change) {
  for (Measurement& measurement : log) {
    if (auto* scan = std::get_if<LaserScan>(&measurement)) change(*scan);
  }
  return log;
}

template <class Kind>
SensorLog without(SensorLog log) {
  std::erase_if(log, [](const Measurement& m) { return std::holds_alternative<Kind>(m); });
  return log;
}

// Legs, three beams wide, all about the robot, and nothing else in reach.
void set_people_alone(LaserScan& scan) {
  for (std::size_t n = 0; n < scan.ranges.size(); ++n) {
    scan.ranges[n] = n % 20 < 3 ? 1.5 : scan.max_range;
  }
}

SensorLog standing() {
  SensorLog log;
  Rng rng(1);
  for (int i = 0; i < 12; ++i) {
    log.emplace_back(Odometry{.time = 0.25 * i});
    log.emplace_back(with_range_noise(
        scan_of(rectangular_room(6.0, 4.0), Pose2{}, TestLaser{}, 0.25 * i), 0.01, rng));
  }
  return log;
}

struct HardDrive {
  const char* name;
  SensorLog (*log)();
};

const HardDrive kHardDrives[] = {
    {"nobody is about", drive},
    {"people alone", [] { return changed(drive(), set_people_alone); }},
    {"the robot stands", standing},
    {"no odometry", [] { return without<Odometry>(drive()); }},
    {"one scan", [] { return SensorLog{without<Odometry>(drive()).front()}; }},
    {"no scans", [] { return without<LaserScan>(drive()); }},
    {"nothing at all", [] { return SensorLog{}; }},
    {"no beams", [] { return changed(drive(), [](LaserScan& scan) { scan.ranges.clear(); }); }},
    {"failed beams",
     [] { return changed(drive(), [](LaserScan& scan) { std::ranges::fill(scan.ranges, 0.0); }); }},
    {"beams that are no numbers",
     [] { return changed(drive(), [](LaserScan& scan) { std::ranges::fill(scan.ranges, NAN); }); }},
    {"nothing in reach",
     [] {
       return changed(drive(),
                      [](LaserScan& scan) { std::ranges::fill(scan.ranges, scan.max_range); });
     }},
};

void expect_finite_with_labels(Estimator& method, const SensorLog& log) {
  for (const Measurement& measurement : log) method.add(measurement);
  method.finish();
  const Estimate estimate = method.estimate();
  EXPECT_EQ(estimate.trajectory.size(), without<Odometry>(log).size());
  for (const Stamped<Pose2>& stamped : estimate.trajectory) EXPECT_TRUE(is_finite(stamped.pose));
  for (const IterationValues& iterations : estimate.iterations) {
    for (const double value : iterations.values) EXPECT_TRUE(std::isfinite(value));
  }
  if (estimate.trajectory.empty()) return;
  ASSERT_TRUE(estimate.labels.has_value());
  ASSERT_EQ(estimate.labels->size(), estimate.trajectory.size());
  auto next = estimate.labels->begin();
  for (const Measurement& measurement : without<Odometry>(log)) {
    const auto& scan = std::get<LaserScan>(measurement);
    ASSERT_EQ(next->static_probability.size(), scan.ranges.size());
    for (std::size_t n = 0; n < scan.ranges.size(); ++n) {
      const float label = next->static_probability[n];
      EXPECT_TRUE((label >= 0.0F && label <= 1.0F) || (std::isnan(label) && !scan.is_hit(n)));
    }
    ++next;
  }
}

class EveryFilter : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryFilter, BearsHardDrives) {
  for (const HardDrive& hard : kHardDrives) {
    SCOPED_TRACE(hard.name);
    FilteredEstimator method(method_by_name("scan_matching").configure({}).make({}, Rng(1)),
                             beam_filter_by_name(GetParam()).configure({}).make(Rng(1)));
    expect_finite_with_labels(method, hard.log());
  }
}

std::vector<std::string> filter_names() {
  std::vector<std::string> names;
  for (const BeamFilterEntry& entry : beam_filters()) names.push_back(entry.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Filters, EveryFilter, ::testing::ValuesIn(filter_names()),
                         [](const auto& filter) { return filter.param; });

class EveryPathOfEm : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryPathOfEm, BearsHardDrives) {
  Settings settings{parse_setting("path=" + GetParam())};
  if (GetParam() == "rbpf") settings.push_back(parse_setting("rbpf.particles=5"));
  for (const HardDrive& hard : kHardDrives) {
    SCOPED_TRACE(hard.name);
    expect_finite_with_labels(*method_by_name("em").configure(settings).make({}, Rng(1)),
                              hard.log());
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, EveryPathOfEm,
                         ::testing::Values("odometry", "scan_matching", "correlative", "icp",
                                           "rbpf", "maximum_likelihood", "graph", "lazy"),
                         [](const auto& method) { return method.param; });

}  // namespace
}  // namespace mapbed
