#include "bench/pages/testing/example_results.h"

#include <cmath>
#include <filesystem>

#include "bench/plot/heat_map.h"
#include "bench/plot/plot.h"
#include "bench/results/replay.h"
#include "core/file/text_file.h"
#include "core/image/png.h"

namespace mapbed {
namespace {

constexpr const char* kConfig = R"(scenario:
  id: example
  about: Does <b> & a question pass through?
  thesis: Figure 3.10
  quick: false
  seeds: 2
)";

constexpr const char* kClaims = R"(claim,held,measured,thesis
failures of on at most those of off,yes,0.1 against 0.3,fewer at every level
error below 0.5 m,no,0.73 m at 16 deg,
fewer in the upper half,not judged,no such level,yes
)";

constexpr const char* kSummary =
    "level,robot.odometry.rotation_sigma,variant,metric,unit,runs,failed,missing,mean,low,high,"
    "median,min,max\n"
    "0,0 deg,off,translation_error,m,2,0,0,0.5,0.4,0.6,0.5,0.3,0.7\n"
    "0,0 deg,on,translation_error,m,2,0,0,0.125,0.1,0.2,0.1,0.1,0.3\n"
    "1,16 deg,off,heading_error,rad,2,1,1,0.5,0.25,1,0.5,0.25,1\n"
    "1,16 deg,on,heading_error,rad,2,0,2,,,,,,\n";

constexpr const char* kRuns =
    "run,seed,level,robot.odometry.rotation_sigma,variant,translation_error,failure\n"
    "0,7,0,0 deg,off,0.5,\n1,7,1,16 deg,off,,\"lost </script>, at 3 s\"\n";

constexpr const char* kCost =
    "run,seconds,recording_seconds,recorded_seconds,peak_memory_bytes\n"
    "0,1.5,3,60,1e8\n1,0.5,0,60,1.2e8\n";

Replay example_replay() {
  Replay replay{.title = "seed 7 </script>",
                .outlines = {{{0, 0}, {20, 0}, {20, 12}, {0, 12}, {0, 0}}}};
  replay.map.image = RgbImage(40, 24, kWhite);
  replay.map.resolution = 0.5;
  ReplayTrack person{"anna", "person", 0.25, {}};
  for (int i = 0; i < 50; ++i) {
    const double t = 0.2 * i;
    const Pose2 pose{4.0 + t, 6.0 + std::sin(t), std::atan(std::cos(t))};
    replay.truth.push_back({t, pose});
    replay.estimate.push_back({t, {pose.x + 0.02 * t, pose.y, pose.theta}});
    person.world_from_it.push_back({t, {12.0 - t, 3.0, 0.0}});
    replay.scans.push_back({.time = t,
                            .first_bearing = -1.5,
                            .bearing_step = 0.1,
                            .max_range = 8.0,
                            .ranges = std::vector<double>(31, 2.0)});
  }
  replay.others.push_back(person);
  return replay;
}

}  // namespace

void make_example_results(const std::string& folder) {
  for (const char* name : {"figures", "maps", "replays"}) {
    std::filesystem::create_directories(folder + "/" + name);
  }
  write_text_file(folder + "/config.yaml", kConfig);
  write_text_file(folder + "/claims.csv", kClaims);
  write_text_file(folder + "/summary.csv", kSummary);
  write_text_file(folder + "/runs.csv", kRuns);
  write_text_file(folder + "/cost.csv", kCost);
  write_text_file(folder + "/provenance.json", "{\"seed\": 7}\n");
  const Plot plot{.title = "Error over noise",
                  .x = {"noise", "deg"},
                  .y = {"error", "m"},
                  .series = {{"off", {0, 16}, {0.5, 0.7}, {0.4, 0.6}, {0.6, 0.8}},
                             {.name = "on", .x = {0, 16}, .y = {0.1, 0.2}, .mark = Mark::bars}}};
  write_text_file(folder + "/figures/error.svg", svg_of(plot));
  write_text_file(folder + "/figures/error.csv", csv_of(plot));
  const HeatMap heat{.title = "Heat", .xs = {0, 1}, .ys = {0, 1}, .values = {0, 1, 2, 3}};
  write_text_file(folder + "/figures/heat.svg", svg_of(heat));
  write_png(folder + "/maps/on.png", RgbImage(900, 300, kWhite));
  write_text_file(folder + "/replays/seed_7.json", replay_json(example_replay()));
}

}  // namespace mapbed
