#include "bench/plot/world_picture.h"

#include <filesystem>

#include "core/config/config_node.h"
#include "core/input_error.h"
#include "robots/robot.h"
#include "sim/drivers/scripted_driver.h"
#include "sim/render/render_simulation.h"
#include "worlds/worlds.h"

namespace mapbed {

bool is_world(const std::string& argument) {
  const std::filesystem::path path(argument);
  if (!path.has_extension()) return !path.has_parent_path();
  if (path.extension() != ".yaml") return false;
  const ConfigNode file = load_config(argument);
  return file.kind() == ConfigNode::Kind::map && file.find("image") == nullptr;
}

RgbImage picture_of(const WorldPicture& picture) {
  const World world = build_world(picture.world, picture.world_settings);
  if (picture.robot.empty()) return render_world(world, picture.camera);
  if (world.paths.empty()) {
    throw InputError("world '" + world.name + "' has no path for a robot; add paths to it");
  }
  const NamedPath& path =
      picture.path.empty() ? world.paths.front() : path_by_name(world, picture.path);
  Simulation simulation(world, load_robot(picture.robot), start_of(path), {}, Rng(picture.seed));
  ScriptedDriver driver(simulation, path);
  while (simulation.now().time < picture.after && !driver.is_done()) {
    simulation.step(driver.command(simulation.now().time));
  }
  Painter painter;
  return render_simulation(painter, simulation, picture.camera);
}

}  // namespace mapbed
