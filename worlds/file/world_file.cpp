#include "worlds/file/world_file.h"

#include <filesystem>
#include <memory>

#include "core/config/config_node.h"
#include "core/config/suggestion.h"
#include "core/image/map_server.h"
#include "core/input_error.h"
#include "worlds/build/building.h"
#include "worlds/build/clearance.h"
#include "worlds/build/furniture.h"
#include "worlds/file/plan_import.h"
#include "worlds/file/shape_config.h"
#include "worlds/tags.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

// Reads one world file from top to bottom into a world.
class WorldReader {
 public:
  WorldReader(const std::string& path, const Settings& settings)
      : path_(path), settings_(settings), files_{input_file(path)}, file_(load_config(path)) {}

  Configured<World()> read() {
    if (const ConfigNode* about = file_.find("about")) about->text();
    read_start();
    if (const ConfigNode* ceiling = file_.find("ceiling")) {
      world_.ceiling = ceiling->number(Unit::meter, between(0.5, 100));
    }
    if (const ConfigNode* materials = file_.find("materials")) read_materials(*materials);
    if (const ConfigNode* floor = file_.find("floor")) read_floor(*floor);
    for_each("walls", [&](const ConfigNode& wall) { read_wall(wall); });
    for_each("shapes", [&](const ConfigNode& shape) { read_shape(shape); });
    for_each("movables", [&](const ConfigNode& movable) { read_movable(movable); });
    if (const ConfigNode* paths = file_.find("paths")) read_paths(*paths);
    for_each("tags", [&](const ConfigNode& tag) { read_tag(tag); });
    if (const ConfigNode* crowd = file_.find("crowd")) read_crowd(*crowd);
    file_.check_all_used("world file");
    if (world_.entities.empty()) {
      throw InputError({path_}, "the world is empty", "add start, plan, walls or shapes");
    }
    const auto world = std::make_shared<const World>(std::move(world_));
    return {start_yaml_, [world] { return *world; }, std::move(files_)};
  }

 private:
  template <class Read>
  void for_each(const std::string& key, Read read) {
    if (const ConfigNode* list = file_.find(key)) {
      for (const ConfigNode& item : list->items()) read(item);
    }
  }

  int material(const ConfigNode& map, const std::string& otherwise) const {
    const ConfigNode* node = map.find("material");
    return material_of(node != nullptr ? node->text() : otherwise,
                       node != nullptr ? node->place() : map.place());
  }

  int material_of(const std::string& name, const SourceLocation& place) const {
    std::vector<std::string> names;
    for (const Material& known : world_.materials) names.push_back(known.name);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return static_cast<int>(i);
    }
    throw InputError(place, "unknown material '" + name + "'", suggestion(name, names));
  }

  void read_start() {
    const ConfigNode* start = file_.find("start");
    const ConfigNode* plan = file_.find("plan");
    if (start != nullptr && plan != nullptr) {
      throw InputError(plan->place(), "a world starts from a builder or from a plan, not from both",
                       "leave out 'start' or 'plan'");
    }
    Settings options = settings_;
    if (const ConfigNode* node = file_.find("options")) {
      if (start == nullptr)
        throw InputError(node->place(), "options are given for no builder", "name it with 'start'");
      const Settings written = settings_of(*node);
      options.insert(options.begin(), written.begin(), written.end());
    }
    if (start != nullptr) {
      world_ = build_start(*start, options);
    } else if (!settings_.empty()) {
      throw InputError(settings_.front().place,
                       "option '" + settings_.front().path +
                           "' is given for a world without a "
                           "builder",
                       "leave it out");
    }
    world_.name = std::filesystem::path(path_).stem().string();
    if (plan != nullptr) read_plan(*plan);
  }

  World build_start(const ConfigNode& start, const Settings& options) {
    std::vector<std::string> names;
    for (const WorldKind& kind : world_kinds()) names.push_back(kind.name);
    const auto index = static_cast<std::size_t>(start.choice(names));
    const Configured<World()> configured = world_kinds()[index].configure(options);
    start_yaml_ = configured.complete_yaml;
    return configured.make();
  }

  void read_plan(const ConfigNode& node) {
    PlanOptions plan;
    plan.file = beside(node.at("file").text());
    files_.push_back(input_file(plan.file));
    const std::string picture = read_map_server_file(plan.file).image;
    if (std::filesystem::exists(picture)) files_.push_back(input_file(picture));
    plan.height = length(node, "height", plan.height);
    plan.material = world_.materials[static_cast<std::size_t>(material(node, plan.material))].name;
    add_plan(world_, plan);
  }

  std::filesystem::path folder() const { return std::filesystem::path(path_).parent_path(); }

  std::string beside(const std::string& name) const { return (folder() / name).string(); }

  void read_materials(const ConfigNode& node) {
    for (const std::string& name : node.keys()) {
      const ConfigNode& entry = node.at(name);
      Material material;
      if (const ConfigNode* like = entry.find("like")) {
        material =
            world_.materials[static_cast<std::size_t>(material_of(like->text(), like->place()))];
      }
      material.name = name;
      read_options(entry, options_of(material));
      if (const ConfigNode* color = entry.find("color")) {
        const std::vector<double> rgb = color->numbers(Unit::none, kFraction);
        if (rgb.size() != 3) {
          throw InputError(color->place(), "a color has three numbers", "write [red, green, blue]");
        }
        material.color = {rgb[0], rgb[1], rgb[2]};
      }
      world_.materials.push_back(material);
    }
  }

  void read_floor(const ConfigNode& node) {
    const int index = material(node, "concrete");
    add_floor(world_, point(node.at("from")), point(node.at("to")),
              world_.materials[static_cast<std::size_t>(index)].name);
  }

  void read_wall(const ConfigNode& node) {
    Wall wall;
    if (const ConfigNode* name = node.find("name")) wall.name = name->text();
    wall.from = point(node.at("from"));
    wall.to = point(node.at("to"));
    wall.thickness = length(node, "thickness", wall.thickness);
    wall.material = world_.materials[static_cast<std::size_t>(material(node, wall.material))].name;
    const double reach = (wall.to - wall.from).norm();
    if (reach <= 0.0) {
      throw InputError(node.place(), "the wall has no length", "let from and to differ");
    }
    double done = 0.0;
    if (const ConfigNode* openings = node.find("openings")) {
      for (const ConfigNode& item : openings->items()) {
        const Opening opening = opening_of(item);
        const double half = opening.width / 2 + frame_width(opening.kind);
        if (opening.at - half < done || opening.at + half > reach) {
          throw InputError(item.place(), "the opening reaches beyond the wall or into another one",
                           "give openings from the wall's start to its end, apart from each other, "
                           "with 6 cm on either side for the frame of a door");
        }
        done = opening.at + half;
        wall.openings.push_back(opening);
      }
    }
    add_wall(world_, wall);
  }

  void read_shape(const ConfigNode& node) {
    Entity entity = shape_in(node);
    if (const ConfigNode* kind = node.find("kind")) {
      entity.kind = kind->choice({"structure", "furniture"}) == 0 ? EntityKind::structure
                                                                  : EntityKind::furniture;
    }
    world_.entities.push_back(std::move(entity));
  }

  Entity shape_in(const ConfigNode& node) {
    Part part;
    Entity entity{.kind = EntityKind::furniture};
    if (const ConfigNode* mesh = node.find("mesh")) {
      files_.push_back(input_file(beside(mesh->text())));
    }
    const ConfiguredShape shape = shape_of(node, world_.ceiling, folder());
    part.geometry = shape.geometry;
    if (const ConfigNode* name = node.find("name")) entity.name = name->text();
    if (entity.name.empty()) entity.name = "shape";
    part.name = entity.name;
    part.material = material(node, "wood");
    part.entity_from_part = upright({}, shape.rise);
    entity.world_from_entity = pose_of(node);
    entity.parts.push_back(std::move(part));
    return entity;
  }

  // A shape, or a piece of furniture by name.
  void read_movable(const ConfigNode& node) {
    Movable movable;
    if (const ConfigNode* piece = node.find("piece")) {
      const Pose2 pose = planar(pose_of(node));
      movable.entity = piece->choice({"chair", "office_chair"}) == 0 ? chair(world_, pose)
                                                                     : office_chair(world_, pose);
      if (const ConfigNode* name = node.find("name")) movable.entity.name = name->text();
    } else {
      movable.entity = shape_in(node);
    }
    movable.entity.kind = EntityKind::movable;
    movable.places = {movable.entity.world_from_entity.position.head<2>()};
    if (const ConfigNode* to = node.find("to")) {
      for (const Eigen::Vector2d& place : points(*to, 1)) movable.places.push_back(place);
    }
    if (const ConfigNode* speed = node.find("speed")) {
      movable.speed = speed->number(Unit::meter_per_second, between(0.01, 10.0));
    }
    if (const ConfigNode* rest = node.find("mean_rest")) {
      movable.mean_rest = rest->number(Unit::second, between(0.01, 1e6));
    }
    world_.movables.push_back(std::move(movable));
  }

  void read_paths(const ConfigNode& node) {
    for (const std::string& name : node.keys()) {
      const ConfigNode& entry = node.at(name);
      NamedPath path{name, {}, length(entry, "clearance", 0.3)};
      const ConfigNode* speed = entry.find("speed");
      const double fast =
          speed != nullptr ? speed->number(Unit::meter_per_second, between(0.001, 100.0)) : 0.0;
      for (const Eigen::Vector2d& p : points(entry.at("points"), 2)) {
        path.points.push_back({p, fast});
      }
      if (path.points.front().position == path.points[1].position) {
        throw InputError(entry.place(), "the path begins with the same point twice",
                         "let its first two points differ: they say where the robot looks");
      }
      check_at(entry.place(), [&] { check_clearance(world_, path); });
      std::erase_if(world_.paths, [&](const NamedPath& old) { return old.name == name; });
      world_.paths.push_back(std::move(path));
    }
  }

  void read_tag(const ConfigNode& node) {
    RfidTag tag{.id = node.at("id").text()};
    const std::vector<double> at = node.at("at").numbers(Unit::meter);
    if (at.size() != 3) {
      throw InputError(node.at("at").place(), "a tag's place has three numbers",
                       "write [x, y, z], as in [1 m, 2 m, 1.4 m]");
    }
    const auto angle = [&](const char* key) {
      const ConfigNode* found = node.find(key);
      return found != nullptr ? found->number(Unit::radian) : 0.0;
    };
    tag.world_from_tag = {{at[0], at[1], at[2]},
                          rotation_of(angle("facing"), angle("pitch"), angle("roll"))};
    const bool is_told = node.find("material") != nullptr;
    tag.material = is_told ? material(node, "") : material_behind(world_, tag.world_from_tag);
    check_at(node.place(), [&] { check_tag(world_, tag); });
    world_.tags.push_back(std::move(tag));
  }

  void read_crowd(const ConfigNode& node) {
    CrowdRules& crowd = world_.crowd;
    const auto count = [&](const std::string& key, int& value) {
      if (const ConfigNode* found = node.find(key)) value = found->whole_number(between(0, 5000));
    };
    count("walkers", crowd.walkers);
    count("standing", crowd.standing);
    count("blockers", crowd.blockers);
    if (const ConfigNode* fraction = node.find("pause_fraction")) {
      crowd.pause_fraction = fraction->number(Unit::none, kFraction);
    }
    if (const ConfigNode* pause = node.find("mean_pause")) {
      crowd.mean_pause = pause->number(Unit::second, between(0.01, 1e6));
    }
    if (const ConfigNode* routes = node.find("routes")) {
      for (const ConfigNode& item : routes->items()) {
        CrowdRoute route{.name = item.at("name").text(), .points = points(item.at("points"), 2)};
        if (const ConfigNode* closed = item.find("closed")) route.closed = closed->flag();
        if (const ConfigNode* weight = item.find("weight")) {
          route.weight = weight->number(Unit::none, between(1e-6, 1e6));
        }
        check_at(item.place(), [&] { check_clearance(world_, route); });
        crowd.routes.push_back(std::move(route));
      }
    }
    if (const ConfigNode* places = node.find("places")) {
      for (const ConfigNode& item : places->items()) {
        StandingPlace place{point(item.at("at")), 0.0, length(item, "radius", 0.5)};
        if (const ConfigNode* heading = item.find("heading")) {
          place.heading = heading->number(Unit::radian);
        }
        crowd.places.push_back(place);
      }
    }
    if (crowd.walkers > 0 && crowd.routes.empty()) {
      throw InputError(node.place(), "there are walkers but no routes for them",
                       "add routes to the crowd");
    }
    if (crowd.standing > 0 && crowd.places.empty()) {
      throw InputError(node.place(), "there are people who stand but no places for them",
                       "add places to the crowd");
    }
  }

  template <class Check>
  static void check_at(const SourceLocation& place, Check check) {
    try {
      check();
    } catch (const InputError& error) {
      throw InputError(place, error.what());
    }
  }

  std::string path_;
  Settings settings_;
  InputFiles files_;  // the world file before it is read
  ConfigNode file_;
  std::string start_yaml_;  // all options of the builder that it starts from
  World world_;
};

}  // namespace

Configured<World()> configure_world_file(const std::string& yaml_path, const Settings& settings) {
  return WorldReader(yaml_path, settings).read();
}

}  // namespace mapbed
