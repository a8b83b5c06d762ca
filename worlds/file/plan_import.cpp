#include "worlds/file/plan_import.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

#include "core/config/config_node.h"
#include "core/geometry/pose2.h"
#include "core/image/png.h"
#include "core/image/pnm.h"
#include "core/input_error.h"
#include "worlds/build/building.h"

namespace mapbed {
namespace {

constexpr std::size_t kMostPieces = 200'000;

struct PlanFile {
  GrayImage image;
  double resolution;      // [m] of a pixel
  Pose2 world_from_plan;  // the low left corner of the image
  bool negate;
  double occupied_from;  // share of black
};

GrayImage read_image(const std::string& path, const SourceLocation& place) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".pgm") return read_pgm(path);
  if (ending == ".png") return read_gray_png(path);
  throw InputError(place, "image '" + path + "' is neither .pgm nor .png", "convert it to one");
}

PlanFile read_plan(const std::string& path) {
  const ConfigNode file = load_config(path);
  const ConfigNode& image = file.at("image");
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const ConfigNode& origin = file.at("origin");
  const std::vector<double> o = origin.numbers();
  if (o.size() != 3)
    throw InputError(origin.place(), "origin has " + std::to_string(o.size()) + " numbers",
                     "write [x, y, yaw]");
  const ConfigNode* negate = file.find("negate");
  const ConfigNode* occupied = file.find("occupied_thresh");
  PlanFile plan{read_image((folder / image.text()).string(), image.place()),
                file.at("resolution").number(Unit::none, kPositive),
                {o[0], o[1], o[2]},
                negate != nullptr && negate->whole_number(between(0, 1)) == 1,
                occupied == nullptr ? 0.65 : occupied->number(Unit::none, kShare)};
  file.use_all();  // other programs write more keys, none of which changes the walls
  return plan;
}

// Columns [first, last) of one row.
struct Run {
  int first;
  int last;
  auto operator<=>(const Run&) const = default;
};

std::vector<Run> occupied_runs(const PlanFile& plan, int row) {
  const auto is_occupied = [&](int column) {
    const double white = plan.image.at(column, row) / 255.0;
    return (plan.negate ? white : 1.0 - white) > plan.occupied_from;
  };
  std::vector<Run> runs;
  for (int column = 0; column < plan.image.width(); ++column) {
    if (!is_occupied(column)) continue;
    const int first = column;
    while (column < plan.image.width() && is_occupied(column)) ++column;
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
std::vector<Patch> occupied_patches(const PlanFile& plan) {
  std::vector<Patch> done;
  std::map<Run, int> open;  // columns -> first row
  for (int row = 0; row <= plan.image.height(); ++row) {
    const std::vector<Run> runs =
        row < plan.image.height() ? occupied_runs(plan, row) : std::vector<Run>{};
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
  const PlanFile plan = read_plan(options.file);
  Entity walls{.name = "plan",
               .kind = EntityKind::structure,
               .world_from_entity = upright(plan.world_from_plan)};
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
    const double y = m * (plan.image.height() - 0.5 * (patch.rows.first + patch.rows.last));
    walls.parts.push_back({.name = "wall",
                           .geometry = Box{{width, depth, options.height}},
                           .entity_from_part = upright({x, y, 0.0}, options.height / 2),
                           .material = material});
  }
  if (walls.parts.empty()) {
    throw InputError({options.file}, "the plan has no occupied pixel",
                     "check negate and occupied_thresh");
  }
  world.entities.push_back(std::move(walls));
  world.ceiling = options.height;
  const Eigen::AlignedBox3d box = bounds_of(world);
  add_floor(world, box.min().head<2>(), box.max().head<2>(), "concrete");
}

}  // namespace mapbed
