#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "algorithms/grid/map_file.h"
#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/progress.h"
#include "bench/cli/render/map_folder.h"
#include "bench/cli/render/render_antenna.h"
#include "bench/cli/render/render_figure.h"
#include "bench/cli/render/render_film.h"
#include "bench/film/film.h"
#include "bench/plot/map_figure.h"
#include "bench/plot/map_picture.h"
#include "bench/plot/world_picture.h"
#include "bench/process/foreign_files.h"
#include "core/config/quantity.h"
#include "core/file/atomic_file.h"
#include "core/geometry/tum_file.h"
#include "core/image/pdf.h"
#include "core/image/png.h"
#include "core/input_error.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

struct RenderArguments {
  std::vector<std::string> maps;  // or one world
  std::string output;
  std::string resolution;
  std::vector<std::string> trajectories;
  std::vector<std::string> names;
  PictureOptions picture;
  WorldPicture world;
  std::string after;
  AntennaArguments antenna;
  std::vector<std::string> world_options;
  std::vector<std::string> camera_options;
  std::optional<int> longest_side;  // [pixels]
  FilmArguments film;
  FigureArguments figure;
};

Settings settings_in(const std::vector<std::string>& options) {
  Settings settings;
  for (const std::string& option : options) settings.push_back(parse_setting(option));
  return settings;
}

RgbImage picture_of_world(const RenderArguments& arguments) {
  WorldPicture picture = arguments.world;
  picture.world = arguments.maps.front();
  picture.world_settings = settings_in(arguments.world_options);
  apply(settings_in(arguments.camera_options), options_of(picture.camera), "camera");
  if (!arguments.after.empty()) {
    picture.after = parse_quantity(arguments.after, Unit::second, {"--after", 0});
  }
  return picture_of(picture);
}

RgbImage picture_of_antenna(const RenderArguments& a) {
  if (!a.world.robot.empty() || !a.after.empty() || !a.world.path.empty()) {
    throw InputError("--antenna is of an empty world: leave out --robot, --path and --after");
  }
  AntennaArguments antenna = a.antenna;
  antenna.world = a.maps.front();
  antenna.world_settings = settings_in(a.world_options);
  antenna.camera = settings_in(a.camera_options);
  antenna.longest_side = a.longest_side;
  return picture_of_antenna(antenna);
}

std::optional<double> resolution_of(const RenderArguments& arguments) {
  if (arguments.resolution.empty()) return {};
  const double resolution = parse_quantity(arguments.resolution, Unit::meter, {"--resolution", 0});
  if (!(resolution > 0.0)) throw InputError("--resolution must be greater than 0 m");
  return resolution;
}

// A robot drives where its map knows something.
void remark_on_other_frame(const std::string& path, const Trajectory& trajectory,
                           const OccupancyMap& map) {
  const auto is_outside = [&map](const Stamped<Pose2>& at) {
    return !map[map.cell_of({at.pose.x, at.pose.y})].known();
  };
  const auto outside = std::count_if(trajectory.begin(), trajectory.end(), is_outside);
  if (2 * static_cast<std::size_t>(outside) <= trajectory.size()) return;
  fmt::print(stderr,
             "remark: {}: {} of {} poses lie where the map knows nothing; if its frame is not the "
             "map's, the picture says nothing\n",
             path, outside, trajectory.size());
}

RgbImage picture_of_map(const RenderArguments& arguments) {
  const OccupancyMap map = read_map(arguments.maps.front(), resolution_of(arguments));
  std::vector<DrawnPath> paths;
  for (const std::string& path : arguments.trajectories) {
    const std::string name = paths.size() < arguments.names.size()
                                 ? arguments.names[paths.size()]
                                 : std::filesystem::path(path).stem().string();
    paths.push_back({name, load_trajectory(path)});
    remark_on_other_frame(path, paths.back().map_from_robot, map);
  }
  const WhatMoved moved = what_moved(arguments.maps.front());
  return picture_of(map, paths, arguments.picture, moved.dynamic, moved.tracks);
}

bool is_name_of_world(const std::string& name) {
  const std::vector<std::string> files = world_file_names();
  return std::find(files.begin(), files.end(), name) != files.end() ||
         std::any_of(world_kinds().begin(), world_kinds().end(),
                     [&](const WorldKind& kind) { return kind.name == name; });
}

// A folder stands for the map in it.
std::string map_in_folder(const std::string& path) {
  if (!std::filesystem::is_directory(path) || is_name_of_world(path)) return path;
  const std::filesystem::path map = std::filesystem::path(path) / "map.yaml";
  if (std::filesystem::exists(map)) return map.string();
  throw InputError({path}, "is a folder without a map.yaml, of which no picture is made",
                   "name a map in it; a film of a run ends in .gif, .webp or .mp4");
}

// "drive" of drive.yaml and of drive/map.yaml.
std::string name_of_map(const std::filesystem::path& path) {
  const bool is_of_folder = path.stem() == "map" && path.has_parent_path();
  return is_of_folder ? path.parent_path().filename().string() : path.stem().string();
}

RgbImage picture_of_maps(const RenderArguments& arguments) {
  if (!arguments.trajectories.empty()) {
    throw InputError("--trajectory is drawn over one map, and there are several");
  }
  std::vector<NamedMap> maps;
  for (const std::string& path : arguments.maps) {
    if (is_world(path)) {
      throw InputError({path}, "is a world; only maps are drawn together");
    }
    const std::string name =
        maps.size() < arguments.names.size() ? arguments.names[maps.size()] : name_of_map(path);
    maps.push_back({name, read_map(path, resolution_of(arguments))});
  }
  return figure_of(maps, arguments.picture.longest_side);
}

// Options of pictures and of films are not mixed: one that says nothing would be a slip.
void refuse_where_named(const std::vector<std::pair<const char*, bool>>& options,
                        const std::string& why) {
  for (const auto& [option, is_named] : options) {
    if (is_named) throw InputError(std::string(option) + " " + why);
  }
}

// Of a run: what a picture of a map or a world is made of would say nothing.
RgbImage picture_of_run(const RenderArguments& a) {
  refuse_where_named({{"--trajectory", !a.trajectories.empty()},
                      {"--name", !a.names.empty()},
                      {"--robot", !a.world.robot.empty()},
                      {"--path", !a.world.path.empty()},
                      {"--after", !a.after.empty()},
                      {"--camera", !a.camera_options.empty()}},
                     "says nothing of a figure");
  if (a.maps.size() != 1) throw InputError("a figure is of one run, and several are named");
  FigureArguments figure = a.figure;
  figure.run = a.maps.front();
  figure.number = a.film.number;
  figure.longest_side = a.longest_side;
  figure.resolution = resolution_of(a);
  figure.settings = settings_in(a.world_options);
  return figure_of_run(figure);
}

RgbImage picture_of(const RenderArguments& arguments) {
  if (arguments.maps.size() > 1) return picture_of_maps(arguments);
  if (!arguments.antenna.antenna.empty()) return picture_of_antenna(arguments);
  if (!arguments.antenna.sensor.empty())
    throw InputError("--sensor says which one --antenna is of");
  return is_world(arguments.maps.front()) ? picture_of_world(arguments) : picture_of_map(arguments);
}

constexpr double kPixel = 0.15;  // [mm] in a PDF

// A chunk "Software" of a PNG, with its length and checksum; it stands behind the header.
constexpr std::string_view kMark(
    "\0\0\0\x0F"
    "tEXtSoftware\0mapbed"
    "\xB3\x1D\x98\x93",
    27);
constexpr std::size_t kHeaderEnd = 33;              // [bytes] signature and IHDR
constexpr std::string_view kPdfMark = "%mapbed\n";  // behind all else, a comment

bool is_pdf(const std::string& path) {
  return std::filesystem::path(path).extension() == ".pdf";
}

// Nothing is written over but a picture of ours.
void refuse_foreign_picture(const std::string& path) {
  if (!std::filesystem::is_regular_file(path) || is_special_file(path)) return;
  std::ifstream file(path, std::ios::binary);
  const std::string content(std::istreambuf_iterator<char>(file), {});
  const bool is_ours = is_pdf(path) ? content.ends_with(kPdfMark)
                                    : content.size() > kHeaderEnd &&
                                          content.compare(kHeaderEnd, kMark.size(), kMark) == 0;
  if (!is_ours) refuse_foreign(path);
}

void write_marked(const std::string& path, const RgbImage& image) {
  if (is_pdf(path)) {
    write_file(path, pdf_of(image, kPixel * image.width()).append(kPdfMark));
  } else {
    write_file(path, png_of(image).insert(kHeaderEnd, kMark));
  }
}

int render_run(const RenderArguments& a) {
  refuse_where_named({{"--trajectory", !a.trajectories.empty()},
                      {"--name", !a.names.empty()},
                      {"--resolution", !a.resolution.empty()},
                      {"--robot", !a.world.robot.empty()},
                      {"--path", !a.world.path.empty()},
                      {"--after", !a.after.empty()},
                      {"--set", !a.world_options.empty()},
                      {"--camera", !a.camera_options.empty()},
                      {"--figure", !a.figure.figure.empty()}},
                     "says nothing of a film");
  if (a.maps.size() != 1) throw InputError("a film is of one run, and several are named");
  FilmArguments film = a.film;
  film.run = a.maps.front();
  film.output = a.output;
  film.longest_side = a.longest_side;
  return render_film(film);
}

void check_ending(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".png" || is_pdf(path) || is_special_file(path)) return;
  throw InputError({path},
                   "has none of the endings .png and .pdf, of a picture, and .gif, .webp "
                   "and .mp4, of a film");
}

int render(RenderArguments arguments) {
  if (is_film(arguments.output)) return render_run(arguments);
  check_ending(arguments.output);
  const FilmArguments& film = arguments.film;
  const bool of_run = !arguments.figure.figure.empty();
  refuse_where_named({{"--run", film.number.has_value() && !of_run},
                      {"--fps", film.rate != FilmArguments().rate},
                      {"--speed", film.speed != 0.0},
                      {"--from", !film.from.empty()},
                      {"--to", !film.to.empty()}},
                     "is of a film: name a file ending in .gif, .webp or .mp4");
  refuse_where_named({{"--at", !arguments.figure.at.empty() && !of_run},
                      {"--variant", !arguments.figure.variants.empty() && !of_run}},
                     "is of a figure: name it with --figure");
  arguments.picture.longest_side = arguments.longest_side.value_or(arguments.picture.longest_side);
  if (!of_run) {
    for (std::string& map : arguments.maps) map = map_in_folder(map);
  }
  check_writable(arguments.output);
  refuse_foreign_picture(arguments.output);
  const RgbImage image = of_run ? picture_of_run(arguments)
                                : while_told("drawing", [&] { return picture_of(arguments); });
  write_marked(arguments.output, image);
  fmt::print("{}: {} x {} pixels\n", arguments.output, image.width(), image.height());
  return kDone;
}

}  // namespace

Command render_command() {
  const auto arguments = std::make_shared<RenderArguments>();
  RenderArguments& a = *arguments;
  const std::string of_world = "Of a world";
  const auto world_option = [&](const char* name, OptionTarget target, const char* help) {
    return CommandOption{.name = name, .target = target, .help = help, .group = of_world};
  };
  CommandOption seed = world_option("--seed", &a.world.seed, "of people and doors");
  seed.shows_default = true;
  Command command{
      .name = "render",
      .help =
          "Draw a map with its trajectories, a world, or a figure of a run; or make a film of one",
      .options =
          {{.name = "MAP|WORLD|RUN",
            .target = &a.maps,
            .help =
                "map.yaml as map servers read it, its folder (with labels and tracks "
                "where it has them), or a .png or .pgm with such a file "
                "beside it; several are drawn at one scale; or a world's name or file; for a film "
                "or "
                "a figure, the folder that 'mapbed map' or 'mapbed run' has written, or a "
                "scenario's name or file",
            .is_required = true},
           {.name = "-o,--out,--output",
            .target = &a.output,
            .help = "the picture, .png or .pdf; or the film, .gif, .webp or, by the program "
                    "ffmpeg, .mp4",
            .is_required = true},
           {"--trajectory", &a.trajectories,
            "poses to draw, lines 't x y z qx qy qz qw' or 't x y theta'; may come again"},
           {"--name", &a.names,
            "the trajectory's name in the legend, or of several maps a map's, in the same order; "
            "its "
            "file's name where left out"},
           {"--resolution", &a.resolution,
            "side of a picture's cell, as in '5 cm', where no .yaml says it"},
           {.name = "--size",
            .target = &a.longest_side,
            .help = "[pixels] of the map's longer side, or of several in a row, at most; 1600, of "
                    "a film 800 where left out",
            .check = IntRange{100, 16000}},
           world_option(
               "--robot", &a.world.robot,
               "draw it in the middle of a drive of this robot, people and doors included"),
           world_option("--path", &a.world.path,
                        "that the robot follows, as 'mapbed describe WORLD' lists them; the first "
                        "where left out"),
           world_option("--after", &a.after, "how long it has driven; 20 s where left out"),
           seed,
           world_option("--set", &a.world_options,
                        "an option of the world, as in size=30m, or of the people filter in a "
                        "figure; may come again"),
           world_option("--camera", &a.camera_options,
                        "an option of the picture, as in view=plan or reach=8m, see 'describe "
                        "camera'; may come again")},
      .run = [arguments] { return render(*arguments); }};
  for (const auto& more :
       {antenna_options(a.antenna), film_options(a.film), figure_options(a.figure)}) {
    command.options.insert(command.options.end(), more.begin(), more.end());
  }
  return command;
}

}  // namespace mapbed
