#include "bench/experiments/known_poses.h"

#include <algorithm>
#include <cmath>

#include "algorithms/grid/map_builder.h"
#include "bench/experiments/posed_scans.h"
#include "bench/metrics/entropy.h"
#include "bench/metrics/map_error.h"
#include "bench/plot/map_picture.h"
#include "core/image/png.h"
#include "sim/recording.h"

namespace mapbed {
namespace {

struct KnownPosesOptions {
  int scans = 0;
  int glass_looks = 10;
  MapOptions map;
};

template <class Visitor>
void visit_fields(KnownPosesOptions& o, Visitor&& visit) {
  visit("scans", o.scans, between(0, 10'000'000), "the first of the log that are used; 0: all");
  visit("glass_looks", o.glass_looks, between(1, 1'000'000),
        "beams that must have met glass in a cell for it to count as glass");
  visit("map", o.map, "how the map is made of the scans");
}

// What the map says of the cells that are truly glass.
struct GlassCells {
  int count = 0;
  int between = 0;   // in (0.1, 0.9): seen as what reflects some beams
  int occupied = 0;  // 0.5 or more
};

// The cells in which the axes of enough beams truly met glass. Beam k of a true scan is beam k of
// the measured one.
GlassCells look_at_glass(const OccupancyMap& map, const PosedScans& posed,
                         const Recording& recording, int looks) {
  const auto& materials = recording.truth.materials;
  const auto glass = std::find(materials.begin(), materials.end(), "glass") - materials.begin();
  TiledGrid<int> met(map.frame());
  for (std::size_t i = 0; i < posed.scans.size(); ++i) {
    const LaserScan& scan = posed.scans[i];
    const auto& beams = beams_of(recording.truth, scan.time, scan.laser)->beams;
    const Pose2 world_from_laser = posed.world_from_robot[i].pose * scan.robot_from_laser.planar;
    for (std::size_t k = 0; k < beams.size(); ++k) {
      if (beams[k].material != glass || !std::isfinite(beams[k].range)) continue;
      const double bearing = scan.bearing(k);
      const double range = beams[k].range;
      const Eigen::Vector2d point =
          world_from_laser * Eigen::Vector2d(range * std::cos(bearing), range * std::sin(bearing));
      ++met.at(met.cell_of(point));
    }
  }
  GlassCells result;
  met.for_each([&](CellIndex cell, int count) {
    if (count < looks || !map[cell].known()) return;
    ++result.count;
    if (map[cell].probability > 0.1F && map[cell].probability < 0.9F) ++result.between;
    if (map[cell].probability >= 0.5F) ++result.occupied;
  });
  return result;
}

RunOutcome run(const KnownPosesOptions& options, const RunInput& input) {
  const PosedScans posed = posed_scans(input, options.scans);
  const OccupancyMap map = build_map(posed.scans, posed.world_from_robot, options.map);
  RunOutcome outcome;
  if (input.recording != nullptr) {
    const GlassCells glass = look_at_glass(map, posed, *input.recording, options.glass_looks);
    outcome.values.emplace_back("glass_cells", glass.count);
    if (glass.count > 0) {
      outcome.values.emplace_back("glass_between",
                                  static_cast<double>(glass.between) / glass.count);
      outcome.values.emplace_back("glass_occupied",
                                  static_cast<double>(glass.occupied) / glass.count);
    }
  }
  if (input.true_map) {
    const MapErrors errors = compare_maps(map, input.true_map(map.resolution()));
    outcome.values.emplace_back("map_f1", errors.f1());
    outcome.values.emplace_back("map_precision", errors.precision());
    outcome.values.emplace_back("map_recall", errors.recall());
  }
  outcome.values.emplace_back("mean_entropy", mean_entropy(map));
  if (input.shown && !known_box(map).empty()) {
    outcome.files.push_back(
        {"maps/map.png",
         png_of(picture_of(map, {{"true path", posed.world_from_robot}}, {.longest_side = 1000}))});
  }
  return outcome;
}

}  // namespace

Experiment known_poses_experiment() {
  return make_experiment<KnownPosesOptions>(
      "known_poses", "a map of the scans at their true poses, Figures 2.8 and 2.9",
      Experiment::Needs::truth,
      {{"glass_cells", Unit::none, "cells that are truly glass and were seen"},
       {"glass_between", Unit::none, "fraction of these that the map puts into (0.1, 0.9)"},
       {"glass_occupied", Unit::none, "fraction of these that the map gives 0.5 or more"},
       {"map_f1", Unit::none, "of occupied cells against the world's own map, see map_error.h"},
       {"map_precision", Unit::none, "fraction of the occupied cells that are right"},
       {"map_recall", Unit::none, "fraction of the true occupied cells that were found"},
       {"mean_entropy", Unit::none, "[bit] of the known cells"}},
      run);
}

}  // namespace mapbed
