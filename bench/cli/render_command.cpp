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
  std::vector<std::string> world_options;
  std::vector<std::string> camera_options;
};

RgbImage picture_of_world(const RenderArguments& arguments) {
  WorldPicture picture = arguments.world;
  picture.world = arguments.maps.front();
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
  return picture_of(picture);
}

std::optional<double> resolution_of(const RenderArguments& arguments) {
  if (arguments.resolution.empty()) return {};
  const double resolution = parse_quantity(arguments.resolution, Unit::meter, {"--resolution", 0});
  if (!(resolution > 0.0)) throw InputError("--resolution must be greater than 0 m");
  return resolution;
}

RgbImage picture_of_map(const RenderArguments& arguments) {
  const OccupancyMap map = read_map(arguments.maps.front(), resolution_of(arguments));
  std::vector<DrawnPath> paths;
  for (const std::string& path : arguments.trajectories) {
    const std::string name = paths.size() < arguments.names.size()
                                 ? arguments.names[paths.size()]
                                 : std::filesystem::path(path).stem().string();
    paths.push_back({name, load_trajectory(path)});
  }
  return picture_of(map, paths, arguments.picture);
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
    const std::string name = maps.size() < arguments.names.size()
                                 ? arguments.names[maps.size()]
                                 : std::filesystem::path(path).stem().string();
    maps.push_back({name, read_map(path, resolution_of(arguments))});
  }
  return figure_of(maps, arguments.picture.longest_side);
}

RgbImage picture_of(const RenderArguments& arguments) {
  if (arguments.maps.size() > 1) return picture_of_maps(arguments);
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

int render(const RenderArguments& arguments) {
  check_writable(arguments.output);
  refuse_foreign_picture(arguments.output);
  const RgbImage image = while_told("drawing", [&] { return picture_of(arguments); });
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
  return {
      .name = "render",
      .help = "Draw a map with its trajectories, or a world",
      .options =
          {{.name = "MAP|WORLD",
            .target = &a.maps,
            .help =
                "map.yaml as map servers read it, or a .png or .pgm with such a file beside it; "
                "several are drawn at one scale; or a world's name or file",
            .is_required = true},
           {.name = "-o,--out,--output",
            .target = &a.output,
            .help = "the picture, a PNG file; of the ending .pdf a PDF file",
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
            .target = &a.picture.longest_side,
            .help = "[pixels] of the map's longer side, or of several in a row, at most",
            .check = IntRange{100, 16000},
            .shows_default = true},
           world_option(
               "--robot", &a.world.robot,
               "draw it in the middle of a drive of this robot, people and doors included"),
           world_option("--path", &a.world.path,
                        "that the robot follows, as 'mapbed describe WORLD' lists them; the first "
                        "where left out"),
           world_option("--after", &a.after, "how long it has driven; 20 s where left out"),
           seed,
           world_option("--set", &a.world_options,
                        "an option of the world, as in size=30m; may come again"),
           world_option("--camera", &a.camera_options,
                        "an option of the picture, as in view=plan or reach=8m, see 'describe "
                        "camera'; may come again")},
      .run = [arguments] { return render(*arguments); }};
}

}  // namespace mapbed
