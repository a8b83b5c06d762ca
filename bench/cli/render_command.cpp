#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/map_loader.h"
#include "bench/map_picture.h"
#include "core/config/quantity.h"
#include "core/geometry/tum_file.h"
#include "core/image/png.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

struct RenderArguments {
  std::string map;
  std::string output;
  std::string resolution;
  std::vector<std::string> trajectories;
  std::vector<std::string> names;
  PictureOptions picture;
};

int render(const RenderArguments& arguments) {
  std::optional<double> resolution;
  if (!arguments.resolution.empty()) {
    resolution = parse_quantity(arguments.resolution, Unit::meter, {"--resolution", 0});
    if (!(*resolution > 0.0)) throw InputError("--resolution must be greater than 0 m");
  }
  const OccupancyMap map = load_map(arguments.map, resolution);
  std::vector<DrawnPath> paths;
  for (const std::string& path : arguments.trajectories) {
    const std::string name = paths.size() < arguments.names.size()
                                 ? arguments.names[paths.size()]
                                 : std::filesystem::path(path).stem().string();
    paths.push_back({name, load_trajectory(path)});
  }
  const RgbImage image = picture_of(map, paths, arguments.picture);
  write_png(arguments.output, image);
  fmt::print("{}: {} x {} pixels\n", arguments.output, image.width(), image.height());
  return kDone;
}

}  // namespace

void add_render_command(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("render", "Draw a map with trajectories, a scale bar and a legend");
  const auto arguments = std::make_shared<RenderArguments>();
  command
      ->add_option("MAP", arguments->map,
                   "map.yaml as map servers read it, or a .png with such a file beside it")
      ->required();
  command->add_option("-o,--output", arguments->output, "the picture, a PNG file")->required();
  command
      ->add_option("--trajectory", arguments->trajectories,
                   "poses to draw, lines 't x y z qx qy qz qw' or 't x y theta'; may come again")
      ->allow_extra_args(false);
  command
      ->add_option("--name", arguments->names,
                   "the trajectory's name in the legend, in the same order; its file's name "
                   "where left out")
      ->allow_extra_args(false);
  command->add_option("--resolution", arguments->resolution,
                      "side of a .png's cell, as in '5 cm', where no .yaml says it");
  command
      ->add_option("--size", arguments->picture.longest_side,
                   "[pixels] of the map's longer side, at most")
      ->capture_default_str()
      ->check(CLI::Range(100, 16000));
  command->callback([arguments, &action] { action = [arguments] { return render(*arguments); }; });
}

}  // namespace mapbed
