#include "bench/pages/testing/example_results.h"

#include <cmath>
#include <filesystem>
#include <limits>

#include "bench/plot/heat_map.h"
#include "bench/plot/plot.h"
#include "bench/results/plan_yaml.h"
#include "bench/results/replay.h"
#include "bench/results/result_folder.h"
#include "core/config/settings.h"
#include "core/file/text_file.h"
#include "core/image/png.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string config_of(const Results& plan) {
  return "scenario:\n" + indented(plan_yaml(plan));
}

// A filter on and off under two noises, with one seed; half of the runs were done.
Results example_results() {
  Results r{.id = "example",
            .about = "Does <b> & a question pass through?",
            .thesis = "Figure 3.10",
            .experiment = "slam",
            .seed = 7};
  r.axes = {axis_of("robot.odometry.rotation_sigma", {"0 deg", "16 deg"})};
  r.levels = levels_of(r.axes);
  r.variants = {"off", "on"};
  r.metrics = {{"translation_error", Unit::meter, "ATE"}, {"heading_error", Unit::radian, "ATE"}};
  r.plots = {{.file = "error",
              .title = "Error over noise",
              .x = "robot.odometry.rotation_sigma",
              .y = "translation_error"}};
  r.config_yaml = config_of(r);
  r.runs = {{.run = 0, .level = 0, .variant = 0, .seed = 7, .values = {0.5, 0.1}},
            {.run = 2,
             .level = 1,
             .variant = 0,
             .seed = 7,
             .values = {kNone, kNone},
             .failure = "lost </script>, at 3 s"}};
  r.summary = {{0, 0, 0, 2, 0, 0, 0.5, 0.4, 0.6, 0.5, 0.3, 0.7},
               {0, 1, 0, 2, 0, 0, 0.125, 0.1, 0.2, 0.1, 0.1, 0.3},
               {1, 0, 1, 2, 1, 1, 0.5, 0.25, 1.0, 0.5, 0.25, 1.0},
               {1, 1, 1, 2, 0, 2, kNone, kNone, kNone, kNone, kNone, kNone}};
  r.verdicts = {{.claim = "failures of on at most those of off",
                 .held = true,
                 .measured = "0.1 against 0.3",
                 .thesis = "fewer at every level"},
                {.claim = "error below 0.5 m", .held = false, .measured = "0.73 m at 16 deg"},
                {.claim = "fewer in the upper half",
                 .judged = false,
                 .measured = "no such level",
                 .thesis = "yes"}};
  r.costs = {{.run = 0,
              .seconds = 1.5,
              .recording_seconds = 3.0,
              .recorded_seconds = 60.0,
              .peak_memory = 1e8},
             {.run = 2, .seconds = 0.5, .recorded_seconds = 60.0, .peak_memory = 1.2e8}};
  r.files = {{"figures/heat_level_0_off.svg", 0, "heat"},
             {"maps/map_level_1_off.png", 2, "map"},
             {"replays/run_level_0_off.json", 0, ""},
             {"replays/run_level_1_off.json", 2, ""}};
  r.provenance_json = "{\"seed\": 7}\n";
  return r;
}

// Its estimate is that many metres further off after each second. One person is followed, hidden
// from 4 s to 6 s; the beams ahead are called dynamic.
Replay example_replay(double drift) {
  Replay replay{.title = "seed 7 </script>",
                .outlines = {{{0, 0}, {20, 0}, {20, 12}, {0, 12}, {0, 0}}}};
  replay.map.image = RgbImage(40, 24, kWhite);
  replay.map.resolution = 0.5;
  ReplayTrack person{"anna", "person", 0.25, {}};
  ObjectTrack followed{.id = 3};
  for (int i = 0; i < 50; ++i) {
    const double t = 0.2 * i;
    const Pose2 pose{4.0 + t, 6.0 + std::sin(t), std::atan(std::cos(t))};
    replay.truth.push_back({t, pose});
    replay.estimate.push_back({t, {pose.x + drift * t, pose.y, pose.theta}});
    person.world_from_it.push_back({t, {12.0 - t, 3.0, 0.0}});
    replay.scans.push_back({.time = t,
                            .first_bearing = -1.5,
                            .bearing_step = 0.1,
                            .max_range = 8.0,
                            .ranges = std::vector<double>(31, 2.0)});
    ScanLabels labels{.time = t, .static_probability = std::vector<float>(31, 1.0F)};
    labels.static_probability[15] = 0.1F;
    replay.labels.push_back(std::move(labels));
    followed.states.push_back({.time = t,
                               .position = {12.0 - t, 3.0},
                               .covariance = 0.04 * Eigen::Matrix2d::Identity(),
                               .occluded = t > 4.0 && t < 6.0});
  }
  replay.others.push_back(person);
  replay.tracks.push_back(followed);
  return replay;
}

}  // namespace

void make_example_results(const std::string& folder) {
  for (const char* name : {"figures", "maps", "replays"}) {
    std::filesystem::create_directories(folder + "/" + name);
  }
  write_results(folder, example_results());
  const Plot plot{.title = "Error over noise",
                  .x = {"noise", "deg"},
                  .y = {"error", "m"},
                  .series = {{"off", {0, 16}, {0.5, 0.7}, {0.4, 0.6}, {0.6, 0.8}},
                             {.name = "on", .x = {0, 16}, .y = {0.1, 0.2}, .mark = Mark::bars}}};
  write_text_file(folder + "/figures/error.svg", svg_of(plot));
  write_text_file(folder + "/figures/error.csv", csv_of(plot));
  const HeatMap heat{.title = "Heat", .xs = {0, 1}, .ys = {0, 1}, .values = {0, 1, 2, 3}};
  write_text_file(folder + "/figures/heat_level_0_off.svg", svg_of(heat));
  write_png(folder + "/maps/map_level_1_off.png", RgbImage(900, 300, kWhite));
  write_text_file(folder + "/replays/run_level_0_off.json", replay_json(example_replay(0.02)));
  write_text_file(folder + "/replays/run_level_1_off.json", replay_json(example_replay(0.1)));
}

}  // namespace mapbed
