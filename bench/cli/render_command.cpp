#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "algorithms/grid/map_file.h"
#include "bench/cli/commands.h"
#include "bench/plot/map_picture.h"
#include "bench/plot/world_picture.h"
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
  WorldPicture world;
  std::string after;
  std::vector<std::string> world_options;
  std::vector<std::string> camera_options;
};

void write_picture(const std::string& path, const RgbImage& image) {
  write_png(path, image);
  fmt::print("{}: {} x {} pixels\n", path, image.width(), image.height());
}

int render_world(const RenderArguments& arguments) {
  WorldPicture picture = arguments.world;
  picture.world = arguments.map;
  for (const std::string& option : arguments.world_options) {
    picture.world_settings.push_back(parse_setting(option));
  }
  Settings camera;
  for (const std::string& option : arguments.camera_options) {
    camera.push_back(parse_setting(option));
  }
  apply(camera, options_of(picture.camera), "camera");
  if (!arguments.after.empty()) {
    picture.after = parse_quantity(arguments.after, Unit::second, {"--after", 0});
  }
  write_picture(arguments.output, picture_of(picture));
  return kDone;
}

int render(const RenderArguments& arguments) {
  if (is_world(arguments.map)) return render_world(arguments);
  std::optional<double> resolution;
  if (!arguments.resolution.empty()) {
    resolution = parse_quantity(arguments.resolution, Unit::meter, {"--resolution", 0});
    if (!(*resolution > 0.0)) throw InputError("--resolution must be greater than 0 m");
  }
  const OccupancyMap map = read_map(arguments.map, resolution);
  std::vector<DrawnPath> paths;
  for (const std::string& path : arguments.trajectories) {
    const std::string name = paths.size() < arguments.names.size()
                                 ? arguments.names[paths.size()]
                                 : std::filesystem::path(path).stem().string();
    paths.push_back({name, load_trajectory(path)});
  }
  write_picture(arguments.output, picture_of(map, paths, arguments.picture));
  return kDone;
}

}  // namespace

void add_render_command(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("render", "Draw a map with its trajectories, or a world");
  const auto arguments = std::make_shared<RenderArguments>();
  command
      ->add_option(
          "MAP|WORLD", arguments->map,
          "map.yaml as map servers read it, or a .png or .pgm with such a file beside it; or "
          "a world's name or file")
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
                      "side of a picture's cell, as in '5 cm', where no .yaml says it");
  command
      ->add_option("--size", arguments->picture.longest_side,
                   "[pixels] of the map's longer side, at most")
      ->capture_default_str()
      ->check(CLI::Range(100, 16000));
  const char* const of_world = "Of a world";
  command
      ->add_option("--robot", arguments->world.robot,
                   "draw it in the middle of a drive of this robot, people and doors included")
      ->group(of_world);
  command->add_option("--path", arguments->world.path, "that the robot follows; else the first one")
      ->group(of_world);
  command->add_option("--after", arguments->after, "how long it has driven; 20 s where left out")
      ->group(of_world);
  command->add_option("--seed", arguments->world.seed, "of people and doors")
      ->capture_default_str()
      ->group(of_world);
  command
      ->add_option("--set", arguments->world_options,
                   "an option of the world, as in size=30m; may come again")
      ->allow_extra_args(false)
      ->group(of_world);
  command
      ->add_option("--camera", arguments->camera_options,
                   "an option of the picture, as in view=plan or reach=8m, see 'describe camera'; "
                   "may come again")
      ->allow_extra_args(false)
      ->group(of_world);
  command->callback([arguments, &action] { action = [arguments] { return render(*arguments); }; });
}

}  // namespace mapbed
