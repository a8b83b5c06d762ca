#include "bench/cli/render/render_antenna.h"

#include "bench/plot/antenna_picture.h"
#include "sim/render/render_world.h"

namespace mapbed {

std::vector<CommandOption> antenna_options(AntennaArguments& arguments) {
  const std::string of_world = "Of a world";
  return {{.name = "--antenna",
           .target = &arguments.antenna,
           .help = "x, y, z, heading of an RFID antenna, as in '7 m, 6.6 m, 0.6 m, 45 deg': draw "
                   "what tags receive of it all over the world",
           .group = of_world},
          {.name = "--sensor",
           .target = &arguments.sensor,
           .help = "of that antenna, a name or file of kind rfid; alien_alr9780 if left out",
           .group = of_world}};
}

RgbImage picture_of_antenna(const AntennaArguments& arguments) {
  RenderOptions camera;
  apply(arguments.camera, options_of(camera), "camera");
  AntennaPicture picture{.world = arguments.world,
                         .world_settings = arguments.world_settings,
                         .antenna = arguments.antenna};
  if (!arguments.sensor.empty()) picture.sensor = arguments.sensor;
  picture.center = camera.center;
  picture.reach = camera.reach;
  picture.longest_side = arguments.longest_side.value_or(picture.longest_side);
  return picture_of(picture);
}

}  // namespace mapbed
