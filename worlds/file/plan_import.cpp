#include "worlds/file/plan_import.h"

#include <map>
#include <vector>

#include "core/image/map_server.h"
#include "core/input_error.h"
#include "worlds/build/building.h"

namespace mapbed {
namespace {

constexpr std::size_t kMostPieces = 200'000;

// Columns [first, last) of one row.
struct Run {
  int first;
  int last;
  auto operator<=>(const Run&) const = default;
};

std::vector<Run> occupied_runs(const MapServerMap& plan, int row) {
  const int width = plan.occupancy.width();
  const auto is_occupied = [&](int column) {
    return plan.occupancy.at(column, row) > plan.thresholds.occupied;
  };
  std::vector<Run> runs;
  for (int column = 0; column < width; ++column) {
    if (!is_occupied(column)) continue;
    const int first = column;
    while (column < width && is_occupied(column)) ++column;
    runs.push_back({first, column});
  }
  return runs;
}

// A rectangle of pixels; rows count from the top.
struct Patch {
  Run columns;
  Run rows;
};

// Runs of equal columns in rows that follow each other become one patch.
std::vector<Patch> occupied_patches(const MapServerMap& plan) {
  std::vector<Patch> done;
  std::map<Run, int> open;  // columns -> first row
  for (int row = 0; row <= plan.occupancy.height(); ++row) {
    const std::vector<Run> runs =
        row < plan.occupancy.height() ? occupied_runs(plan, row) : std::vector<Run>{};
    std::map<Run, int> still_open;
    for (const Run& run : runs) {
      const auto before = open.find(run);
      still_open[run] = before == open.end() ? row : before->second;
    }
    for (const auto& [columns, first_row] : open) {
      if (!still_open.contains(columns)) done.push_back({columns, {first_row, row}});
    }
    open = std::move(still_open);
  }
  return done;
}

}  // namespace

void add_plan(World& world, const PlanOptions& options) {
  const MapServerMap plan = read_map_server(options.file);
  Entity walls{.name = "plan",
               .kind = EntityKind::structure,
               .world_from_entity = upright(plan.map_from_image)};
  const int material = material_index(world, options.material);
  const double m = plan.resolution;
  const std::vector<Patch> patches = occupied_patches(plan);
  if (patches.size() > kMostPieces) {
    throw InputError({options.file},
                     "the plan falls into " + std::to_string(patches.size()) +
                         " pieces of wall, too many for memory; at most " +
                         std::to_string(kMostPieces) + " fit",
                     "clean it of speckles or make it coarser");
  }
  for (const Patch& patch : patches) {
    const double width = m * (patch.columns.last - patch.columns.first);
    const double depth = m * (patch.rows.last - patch.rows.first);
    const double x = m * (patch.columns.first + patch.columns.last) / 2;
    const double y = m * (plan.occupancy.height() - 0.5 * (patch.rows.first + patch.rows.last));
    walls.parts.push_back({.name = "wall",
                           .geometry = Box{{width, depth, options.height}},
                           .entity_from_part = upright({x, y, 0.0}, options.height / 2),
                           .material = material});
  }
  if (walls.parts.empty()) {
    throw InputError({options.file}, "the plan has no occupied pixel",
                     "check mode, negate and occupied_thresh");
  }
  world.entities.push_back(std::move(walls));
  world.ceiling = options.height;
  const Eigen::AlignedBox3d box = bounds_of(world);
  add_floor(world, box.min().head<2>(), box.max().head<2>(), "concrete");
}

}  // namespace mapbed
