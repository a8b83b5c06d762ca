#include "worlds/file/world_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/image/pgm.h"
#include "core/testing/source_tree.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"
#include "worlds/geometry/footprint.h"
#include "worlds/geometry/raster.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

class WorldFile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.file(name)) << text;
    return folder_.file(name);
  }
  World load(const std::string& text) const { return build_world(write("lab.yaml", text)); }

  TemporaryFolder folder_;
};

const Entity& entity_named(const World& world, const std::string& name) {
  for (const Entity& entity : world.entities) {
    if (entity.name == name) return entity;
  }
  throw std::runtime_error("no entity " + name);
}

TEST_F(WorldFile, BuildsARoomFromNothing) {
  const World world = load(R"(
about: A room with a crate
floor: {from: [0 m, 0 m], to: [8 m, 6 m], material: carpet}
materials:
  velvet: {like: fabric, reflectivity: 0.05, color: [0.4, 0.1, 0.1]}
walls:
  - {name: south, from: [0 m, 0 m], to: [8 m, 0 m], thickness: 20 cm,
     openings: [{kind: door, at: 2 m, width: 0.9 m, open: true, opens_within: 1 m}]}
shapes:
  - {name: crate, box: [1 m, 0.5 m, 0.8 m], at: [3 m, 4 m], heading: 90 deg, material: velvet}
  - {name: pole, cylinder: {radius: 5 cm, height: 2 m}, at: [5 m, 4 m, 1 m]}
  - {name: stage, outline: [[6 m, 4 m], [6 m, 5 m], [7 m, 5 m]], height: 20 cm}
paths:
  across: {points: [[1 m, 2 m], [7 m, 2 m]], clearance: 0.4 m, speed: 0.5 m/s}
crowd:
  walkers: 2
  routes: [{name: to and fro, points: [[1 m, 3 m], [7 m, 3 m]]}]
  places: [{at: [4 m, 5 m], heading: 90 deg, radius: 0.5 m}]
)");
  EXPECT_EQ(world.name, "lab");
  EXPECT_EQ(world.doors.size(), 1u);
  EXPECT_TRUE(world.doors[0].starts_open);
  const Entity& crate = entity_named(world, "crate");
  const auto crate_foot = footprints(crate, 0, 0.0, 0.5);
  EXPECT_NEAR(distance_to(crate_foot[0], {3.0, 5.0}), 0.5, 1e-9) << "turned: 1 m along y";
  const Material& velvet = world.materials[static_cast<std::size_t>(crate.parts[0].material)];
  EXPECT_EQ(velvet.reflectivity, 0.05);
  EXPECT_EQ(velvet.permittivity, 1.5) << "as fabric";
  EXPECT_TRUE(footprints(entity_named(world, "pole"), 0, 0.0, 1.0).empty()) << "hangs at 1 m";
  const NamedPath& path = path_by_name(world, "across");
  EXPECT_EQ(path.points[1].speed, 0.5);
  EXPECT_EQ(world.crowd.routes[0].points.size(), 2u);
}

TEST_F(WorldFile, HasWhatIsMovedAboutBesideTheWorldItself) {
  const World world = load(R"(
floor: {from: [0 m, 0 m], to: [8 m, 6 m]}
movables:
  - {name: trolley, box: [0.9 m, 0.5 m, 0.8 m], at: [3 m, 4 m], heading: 90 deg,
     to: [[5 m, 4 m], [5 m, 2 m]], speed: 0.7 m/s, mean_rest: 12 s}
  - {piece: chair, at: [1 m, 2 m]}
crowd: {pause_fraction: 0.8, mean_pause: 60 s}
)");
  ASSERT_EQ(world.movables.size(), 2U);
  EXPECT_EQ(world.entities.size(), 1U) << "the floor: what moves is none of the true map";
  const Movable& trolley = world.movables[0];
  EXPECT_EQ(trolley.entity.kind, EntityKind::movable);
  EXPECT_EQ(trolley.entity.name, "trolley");
  ASSERT_EQ(trolley.places.size(), 3U) << "where it stands comes first";
  EXPECT_EQ(trolley.places[0], Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(trolley.places[2], Eigen::Vector2d(5.0, 2.0));
  EXPECT_EQ(trolley.speed, 0.7);
  EXPECT_EQ(trolley.mean_rest, 12.0);
  EXPECT_EQ(world.movables[1].entity.name, "chair");
  EXPECT_EQ(world.movables[1].places.size(), 1U);
  EXPECT_GE(world.movables[1].entity.parts.size(), 5U) << "four legs and a seat";
  EXPECT_EQ(world.crowd.pause_fraction, 0.8);
  EXPECT_EQ(world.crowd.mean_pause, 60.0);
}

TEST_F(WorldFile, AddsToABuilderWithItsOptions) {
  const World world = load(R"(
start: corridor
options: {length: 12 m, doors_a_side: 2, clutter: 0}
shapes:
  - {name: crate, box: [0.5 m, 0.5 m, 0.5 m], at: [6 m, 3.5 m]}
)");
  EXPECT_NEAR(path_by_name(world, "one_way").points[1].position.x(), 10.5, 1e-9);
  EXPECT_EQ(entity_named(world, "crate").parts.size(), 1u);
}

TEST_F(WorldFile, LetsSettingsOverrideItsOptions) {
  const std::string path = write("lab.yaml", "start: corridor\noptions: {length: 12 m}\n");
  const World world = build_world(path, {parse_setting("length=20 m")});
  EXPECT_NEAR(path_by_name(world, "one_way").points[1].position.x(), 18.5, 1e-9);
}

// As they stand in a configuration that is complete: later defaults of the builder change nothing.
TEST_F(WorldFile, TellsAllOptionsOfItsBuilderWithWhatIsSet) {
  const std::string path = write("lab.yaml", "start: corridor\noptions: {length: 12 m}\n");
  const std::string yaml = configure_world_file(path, {parse_setting("width=5 m")}).complete_yaml;
  EXPECT_THAT(yaml, ::testing::HasSubstr("length: 12 m  #"));
  EXPECT_THAT(yaml, ::testing::HasSubstr("width: 5 m  #"));
}

TEST_F(WorldFile, TellsTheFilesThatItIsMadeOf) {
  write_pgm(folder_.file("plan.pgm"), GrayImage(2, 2, 0));
  write("plan.yaml", "image: plan.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  write("tent.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n");
  const std::string path = write("lab.yaml",
                                 "plan: {file: plan.yaml}\n"
                                 "shapes: [{mesh: tent.obj}]\n");
  std::vector<std::string> names;
  for (const InputFile& file : configure_world_file(path).files) {
    names.push_back(std::filesystem::path(file.path).filename());
  }
  EXPECT_THAT(names,
              ::testing::UnorderedElementsAre("lab.yaml", "plan.yaml", "plan.pgm", "tent.obj"));
}

TEST_F(WorldFile, MakesWallsOfAPlan) {
  // A ring of walls, drawn from the top: 0 black, 254 free, 205 unknown.
  GrayImage image(6, 5, 254);
  for (int x = 0; x < 6; ++x) image.at(x, 0) = image.at(x, 4) = 0;
  for (int y = 0; y < 5; ++y) image.at(0, y) = image.at(5, y) = 0;
  image.at(3, 1) = 0;
  image.at(1, 3) = 205;
  write_pgm(folder_.file("plan.pgm"), image);
  write("plan.yaml",
        "image: plan.pgm\nresolution: 0.5\norigin: [10.0, 20.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const World world = load("plan: {file: plan.yaml, height: 2 m, material: brick}\n");
  const TrueMap map = raster(world, {.height = 1.0, .resolution = 0.5, .margin = 0.0});
  ASSERT_EQ(map.width, 6);
  ASSERT_EQ(map.height, 5);
  EXPECT_EQ(map.origin, Eigen::Vector2d(10.0, 20.0));
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 6; ++x) {
      const bool solid = map.entities[map.index(x, y)] >= 0;
      EXPECT_EQ(solid, image.at(x, 4 - y) == 0) << x << ", " << y;
    }
  }
  EXPECT_EQ(entity_named(world, "plan").parts.size(), 5u)
      << "top, bottom, left and right side, and the nose";
}

TEST_F(WorldFile, APlanOfPercentsHasTheSameWallsAsOneOfBlackAndWhite) {
  GrayImage greys(8, 4, 254), percents(8, 4, 0);
  for (int x = 1; x < 7; ++x) {
    greys.at(x, 2) = 20;
    percents.at(x, 2) = 90;
  }
  greys.at(5, 0) = 205;
  percents.at(5, 0) = 255;  // unknown in both
  write_pgm(folder_.file("greys.pgm"), greys);
  write_pgm(folder_.file("percents.pgm"), percents);
  const std::string place = "resolution: 0.5\norigin: [0, 0, 0]\n";
  write("greys.yaml", "image: greys.pgm\n" + place);
  write("percents.yaml", "image: percents.pgm\nmode: raw\n" + place);
  const World first = load("plan: {file: greys.yaml}\n");
  const World second = load("plan: {file: percents.yaml}\n");
  const RasterOptions options{.height = 1.0, .resolution = 0.5, .margin = 0.0};
  EXPECT_EQ(raster(first, options).entities, raster(second, options).entities);
  ASSERT_EQ(entity_named(second, "plan").parts.size(), 1u);
  EXPECT_EQ(std::get<Box>(entity_named(second, "plan").parts[0].geometry).size,
            Eigen::Vector3d(3.0, 0.5, 2.5));
}

TEST_F(WorldFile, APlanStandsAsItsOriginIsTurned) {
  GrayImage image(6, 1, 254);
  image.at(5, 0) = 0;  // its middle is 2.75 m along the lower edge and 0.25 m beside it
  write_pgm(folder_.file("plan.pgm"), image);
  write("plan.yaml", "image: plan.pgm\nresolution: 0.5\norigin: [1.0, 2.0, 1.5707963267948966]\n");
  const World world = load("plan: {file: plan.yaml}\n");
  const Entity& plan = entity_named(world, "plan");
  const Eigen::Vector3d middle =
      (plan.world_from_entity * plan.parts.at(0).entity_from_part).position;
  EXPECT_NEAR(middle.x(), 1.0 - 0.25, 1e-9);
  EXPECT_NEAR(middle.y(), 2.0 + 2.75, 1e-9);
}

TEST_F(WorldFile, RefusesAPlanThatIsAllSpeckles) {
  GrayImage image(640, 640, 254);
  for (int y = 0; y < 640; ++y) {
    for (int x = y % 2; x < 640; x += 2) image.at(x, y) = 0;
  }
  write_pgm(folder_.file("plan.pgm"), image);
  write("plan.yaml", "image: plan.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
  EXPECT_INPUT_ERROR(load("plan: {file: plan.yaml}\n"),
                     "plan.yaml: the plan falls into 204800 pieces of wall, too many for memory");
}

TEST_F(WorldFile, ReadsMeshes) {
  write("rock.obj",
        "# a tetrahedron\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
        "f 1 3 2\nf 1/1 2/2 4/3\nf 2 3 -1\nf 1 4 3\n");
  const World world = load("shapes: [{name: rock, mesh: rock.obj, at: [2 m, 3 m, 0 m]}]\n");
  const Eigen::AlignedBox3d box = bounds_of(world);
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(2, 3, 0)));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(3, 4, 1)));
}

TEST_F(WorldFile, RefusesAPathThroughAWall) {
  EXPECT_INPUT_ERROR(load("walls: [{name: wall, from: [0 m, -1 m], to: [0 m, 1 m]}]\n"
                          "paths:\n"
                          "  across: {points: [[-2 m, 0 m], [2 m, 0 m]]}\n"),
                     "lab.yaml:3: path 'across' of world 'lab' runs through 'wall' between");
  EXPECT_INPUT_ERROR(load("walls: [{name: wall, from: [0 m, 0.325 m], to: [0 m, 1 m]}]\n"
                          "paths:\n"
                          "  across: {points: [[-2 m, 0 m], [2 m, 0 m]]}\n"),
                     "comes within 0.25 m of 'wall'");
}

TEST_F(WorldFile, RefusesAPathThatDoesNotSayWhereToLook) {
  EXPECT_INPUT_ERROR(load("start: office\npaths: {p: {points: [[1 m, 1 m], [1 m, 1 m]]}}\n"),
                     "lab.yaml:2: the path begins with the same point twice");
}

TEST_F(WorldFile, SaysWhatItDoesNotKnowAndWhatWasMeant) {
  EXPECT_INPUT_ERROR(load("shapes:\n  - {name: crate, box: [1 m, 1 m, 1 m], material: plastre}\n"),
                     "lab.yaml:2: unknown material 'plastre'; did you mean 'plaster'?");
  EXPECT_INPUT_ERROR(load("start: offise\n"), "did you mean 'office'?");
  EXPECT_INPUT_ERROR(load("start: office\noptions: {sise: 30 m}\n"), "did you mean 'size'?");
  EXPECT_INPUT_ERROR(load("start: office\nwals: []\n"), "did you mean 'walls'?");
  EXPECT_INPUT_ERROR(load("shapes: [{name: crate, at: [1 m, 1 m]}]\n"),
                     "give box, cylinder, outline or mesh");
}

TEST_F(WorldFile, RefusesWhatCannotStand) {
  EXPECT_INPUT_ERROR(load("about: nothing\n"), "the world is empty");
  EXPECT_INPUT_ERROR(load("start: office\nplan: {file: x.yaml}\n"), "not from both");
  EXPECT_INPUT_ERROR(load("shapes: [{box: [1 m, 0 m, 1 m]}]\n"), "the box has no size");
  EXPECT_INPUT_ERROR(load("shapes: [{cylinder: {radius: -5 cm}}]\n"), "too small");
  EXPECT_INPUT_ERROR(
      load("shapes: [{outline: [[0 m, 0 m], [1 m, 1 m], [1 m, 0 m], [0 m, 1 m]]}]\n"),
      "crosses itself");
  EXPECT_INPUT_ERROR(load("walls: [{from: [0 m, 0 m], to: [2 m, 0 m], openings: "
                          "[{kind: gap, at: 1.8 m, width: 1 m}]}]\n"),
                     "reaches beyond the wall");
  EXPECT_INPUT_ERROR(load("floor: {from: [0 m, 0 m], to: [1 m, 1 m]}\ncrowd: {walkers: 3}\n"),
                     "no routes for them");
}

TEST_F(WorldFile, HasTagsWithWhatIsBehindThem) {
  const std::string room =
      "walls: [{from: [0 m, 0 m], to: [8 m, 0 m], thickness: 20 cm, material: brick}]\ntags:\n";
  const World world = load(room +
                           "  - {id: on_wall, at: [2 m, 0.11 m, 1.4 m], facing: 90 deg}\n"
                           "  - {id: free, at: [2 m, 3 m, 1 m], facing: 180 deg, roll: 90 deg}\n"
                           "  - {id: told, at: [3 m, 3 m, 1 m], material: metal}\n");
  ASSERT_EQ(world.tags.size(), 3u);
  EXPECT_EQ(world.tags[0].id, "on_wall");
  EXPECT_EQ(world.tags[0].material, material_index(world, "brick"));
  EXPECT_EQ(world.tags[1].material, RfidTag::kNothing);
  EXPECT_EQ(world.tags[2].material, material_index(world, "metal"));
  const auto axis = [&](std::size_t tag, const Eigen::Vector3d& of_tag) {
    return Eigen::Vector3d(world.tags[tag].world_from_tag.rotation * of_tag);
  };
  EXPECT_LT((axis(0, Eigen::Vector3d::UnitX()) - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((axis(0, Eigen::Vector3d::UnitY()) + Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((axis(1, Eigen::Vector3d::UnitX()) + Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_NEAR(axis(1, Eigen::Vector3d::UnitY()).z(), 1.0, 1e-12);

  const auto refused = [&](const std::string& tags, const std::string& message) {
    EXPECT_INPUT_ERROR(load(room + tags), message);
  };
  refused("  - {id: a, at: [2 m, 0.05 m, 1 m]}\n", "lab.yaml:3: tag 'a' lies inside 'wall'");
  refused("  - {id: a, at: [2 m, 1 m, 1 m]}\n  - {id: a, at: [3 m, 1 m, 1 m]}\n",
          "lab.yaml:4: a second tag is called 'a'");
  refused("  - {id: a b, at: [2 m, 1 m, 1 m]}\n", "lab.yaml:3: the tag's id 'a b' is not one word");
  refused("  - {id: a, at: [2 m, 1 m]}\n", "lab.yaml:3: a tag's place has three numbers");
  refused("  - {id: a, at: [2 m, 1 m, 1 m], material: cheese}\n", "unknown material 'cheese'");
}

TEST_F(WorldFile, RefusesDamagedMeshesAndPlansByLine) {
  write("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
  EXPECT_INPUT_ERROR(load("shapes: [{mesh: bad.obj}]\n"), "bad.obj:3: face corner '3'");
  write("bad.obj", "v 0 nan 0\n");
  EXPECT_INPUT_ERROR(load("shapes: [{mesh: bad.obj}]\n"),
                     "bad.obj:1: a vertex needs three numbers");
  write("plan.yaml", "image: plan.jpg\nresolution: 0.05\norigin: [0, 0, 0]\n");
  EXPECT_INPUT_ERROR(load("plan: {file: plan.yaml}\n"), "plan.yaml:1: there is no picture");
  EXPECT_INPUT_ERROR(load("plan: {file: missing.yaml}\n"), "missing.yaml");
}

// The first YAML block after `title`, as it stands in the file.
std::string example_of(const std::string& path, const std::string& title) {
  std::ifstream readme(path);
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  const std::string fence = "```yaml\n";
  const std::size_t begin = text.find(fence, text.find(title)) + fence.size();
  return text.substr(begin, text.find("```", begin) - begin);
}

TEST_F(WorldFile, OfTheReadmeIsRight) {
  const std::string example = example_of(source_tree() + "/docs/simulation.md", "`my_world.yaml`");
  const World world = load(example);
  EXPECT_FALSE(world.paths.empty());
  EXPECT_FALSE(world.crowd.routes.empty());
  EXPECT_LT(std::count(example.begin(), example.end(), '\n'), 40);
}

TEST_F(WorldFile, OfTheWorkshopIsThatOfTheWorldsReadme) {
  const std::string example =
      example_of(source_tree() + "/worlds/README.md", "A world of your own");
  std::ifstream workshop(source_tree() + "/worlds/workshop.yaml");
  EXPECT_EQ(example, (std::string{std::istreambuf_iterator<char>(workshop), {}}));
  const World world = load(example);
  EXPECT_EQ(world.doors.size(), 1u);
  EXPECT_LT(std::count(example.begin(), example.end(), '\n'), 40);
  EXPECT_EQ(path_by_name(world, "round").points.size(), 5u);
}

}  // namespace
}  // namespace mapbed
