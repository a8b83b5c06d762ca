#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "algorithms/field/local_map.h"
#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/scan_matching/correlative_matcher.h"
#include "algorithms/scan_matching/incremental_matcher.h"
#include "algorithms/scan_matching/scan_matcher.h"
#include "core/data_path.h"
#include "core/geometry/angle.h"
#include "core/log/dialects/carmen_log.h"
#include "core/log/log_description.h"

namespace mapbed {
namespace {

// The example log, a drive round four rooms on 20 m x 14 m, and the map of its true poses.
struct SourceLocation {
  RecordedLog log;
  std::vector<LaserScan> scans;
  std::vector<std::vector<SurfacePoint>> surfaces;  // in the map, of scans half a metre apart
  LikelihoodField field;

  SourceLocation() : log(open_log(find_data_file("log", "scenarios/logs", "example").string())) {
    const IncrementalMatcherOptions options;
    SurfaceMeans means(field.resolution());
    std::vector<Pose2> kept;
    for (const Measurement& measurement : log.measurements) {
      const auto* scan = std::get_if<LaserScan>(&measurement);
      if (scan == nullptr) continue;
      scans.push_back(*scan);
      const Pose2 pose = true_pose(*scan);
      if (!kept.empty() && !is_far_enough(kept.back(), pose, options.local_map)) continue;
      kept.push_back(pose);
      surfaces.push_back(transformed(surface_points(*scan, options.points.max_range,
                                                    options.local_map.max_gap, field.resolution()),
                                     pose));
      means.add(surfaces.back());
    }
    field.add(means.means());
  }

  Pose2 true_pose(const LaserScan& scan) const { return *pose_at(log.true_poses, scan.time); }
  FieldPoints points(const LaserScan& scan) const {
    return to_field_points(hit_points(scan, {}), field.resolution());
  }
};

const SourceLocation& place() {
  static const SourceLocation made;
  return made;
}

// The items are points.
void BM_ScanLikelihood(benchmark::State& state) {
  const LaserScan& scan = place().scans[100];
  const FieldPoints points = place().points(scan);
  const Pose2 pose = place().true_pose(scan);
  for (auto _ : state) benchmark::DoNotOptimize(place().field.sum_log_at(points, pose));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(BM_ScanLikelihood);

// From predictions 10 cm and 3 degrees off.
void BM_HillClimbing(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const LaserScan& scan = place().scans[i++ % place().scans.size()];
    const FieldPoints points = place().points(scan);
    const Pose2 start = place().true_pose(scan) * Pose2{0.1, 0.0, radians(3.0)};
    state.ResumeTiming();
    benchmark::DoNotOptimize(
        match_scan(points, place().field, independent_prior(start, 0.1, 0.1, 0.1)));
  }
}
BENCHMARK(BM_HillClimbing)->Unit(benchmark::kMicrosecond);

// `prior_of(true pose)` is what is known of it.
template <class PriorOf>
void match_correlatively(benchmark::State& state, const CorrelativeMatcherOptions& options,
                         const PriorOf& prior_of) {
  const BoundPyramid pyramid = make_bound_pyramid(place().field, options.window);
  std::size_t i = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const LaserScan& scan = place().scans[(i += 7) % place().scans.size()];
    const FieldPoints points = place().points(scan);
    const PosePrior prior = prior_of(place().true_pose(scan));
    state.ResumeTiming();
    benchmark::DoNotOptimize(match_correlative(points, place().field, pyramid, prior, options));
  }
}

// In the whole map, shifts of up to 7 m and turns of up to 30 degrees, without a prior.
void BM_CorrelativeMatch(benchmark::State& state) {
  match_correlatively(state, {.window = 7.0, .turn_window = radians(30.0)}, [](const Pose2& pose) {
    return PosePrior{.mean = pose * Pose2{2.0, -1.0, radians(20.0)}};
  });
}
BENCHMARK(BM_CorrelativeMatch)->Unit(benchmark::kMillisecond);

// Near a prediction, as scans are matched one after the other.
void BM_CorrelativeMatchNearby(benchmark::State& state) {
  match_correlatively(state, {}, [](const Pose2& pose) {
    return independent_prior(pose * Pose2{0.1, -0.05, radians(3.0)}, 0.1, 0.1, 0.1);
  });
}
BENCHMARK(BM_CorrelativeMatchNearby)->Unit(benchmark::kMicrosecond);

void BM_BoundPyramid(benchmark::State& state) {
  const double window = static_cast<double>(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_bound_pyramid(place().field, window));
  }
}
BENCHMARK(BM_BoundPyramid)->Arg(1)->Arg(7)->Unit(benchmark::kMillisecond);

// As after each scan that is kept: the surfaces of all of them and the field about these.
void BM_LocalMapRebuild(benchmark::State& state) {
  LikelihoodField field;
  SurfaceMeans means(field.resolution());
  const auto scans = static_cast<std::size_t>(state.range(0));
  for (auto _ : state) {
    means.clear();
    for (std::size_t i = 0; i < scans; ++i) means.add(place().surfaces.at(i));
    field.clear();
    field.add(means.means());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(BM_LocalMapRebuild)->Arg(25)->Arg(100)->Unit(benchmark::kMillisecond);

// As a local map moves on: a scan comes in for one that leaves, and the field follows.
void BM_LocalMapUpdate(benchmark::State& state) {
  LikelihoodField field;
  SurfaceMeans means(field.resolution());
  const std::size_t scans = place().surfaces.size() / 2;
  for (std::size_t i = 0; i < scans; ++i) means.add(place().surfaces[i]);
  field.update(means, means.take_changed());
  std::size_t oldest = 0;
  for (auto _ : state) {
    means.remove(place().surfaces[oldest]);
    means.add(place().surfaces[(oldest + scans) % place().surfaces.size()]);
    oldest = (oldest + 1) % place().surfaces.size();
    field.update(means, means.take_changed());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(BM_LocalMapUpdate)->Unit(benchmark::kMicrosecond);

// CARMEN text in memory; the bytes are those of the text.
void BM_LogReading(benchmark::State& state) {
  const std::string text = carmen_text(place().log);
  for (auto _ : state) benchmark::DoNotOptimize(parse_log("drive.log", text));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(BM_LogReading)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mapbed
