#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "sim/render/render_simulation.h"
#include "sim/render/render_world.h"

namespace mapbed {
namespace {

Entity box(const std::string& name, const Eigen::Vector3d& middle, const Eigen::Vector3d& size,
           int material) {
  return {.name = name,
          .kind = EntityKind::structure,
          .world_from_entity = Pose3{middle, Eigen::Quaterniond::Identity()},
          .parts = {{.name = name, .geometry = Box{size}, .material = material}}};
}

// Two pixels for every metre, straight from above: a white floor of 20 m x 20 m about the origin.
constexpr RenderOptions kPlan{
    .view = View::plan, .width = 41, .height = 41, .samples = 1, .cut_height = 0.0};

World white_floor() {
  World world;
  world.materials = {{.name = "white", .color = {0.8, 0.8, 0.8}},
                     {.name = "red", .color = {0.8, 0.1, 0.1}},
                     {.name = "glass", .color = {0.1, 0.1, 0.9}, .transmittance = 0.7}};
  world.entities = {box("floor", {0, 0, -0.05}, {20, 20, 0.1}, 0)};
  world.entities[0].kind = EntityKind::floor;
  return world;
}

// The pixel over a place; a picture of kPlan shows 3 % more than the 20 m.
Rgb seen_at(const RgbImage& image, double x, double y) {
  const double per_meter = image.width() / (20.0 * 1.03);
  return image.at(static_cast<int>(image.width() / 2.0 + per_meter * x),
                  static_cast<int>(image.height() / 2.0 - per_meter * y));
}

int brightness(const Rgb& pixel) {
  return pixel.red + pixel.green + pixel.blue;
}

bool is_red(const Rgb& pixel) {
  return pixel.red > 2 * pixel.green && pixel.red > 2 * pixel.blue;
}

TEST(RenderWorld, ShowsWhatStandsWhereNorthUpAndEastRight) {
  World world = white_floor();
  world.entities.push_back(box("crate", {6, 3, 0.5}, {2, 2, 1}, 1));
  const RgbImage image = render_world(world, kPlan);
  EXPECT_TRUE(is_red(seen_at(image, 6, 3)));
  EXPECT_FALSE(is_red(seen_at(image, -6, 3)));
  EXPECT_FALSE(is_red(seen_at(image, 6, -3)));
  EXPECT_EQ(image.at(0, 0), kWhite) << "beyond the floor there is paper";
}

TEST(RenderWorld, ThrowsShadowsAwayFromTheSun) {
  World world = white_floor();
  world.entities.push_back(box("tower", {0, 0, 3}, {2, 2, 6}, 0));
  const RgbImage image = render_world(world, kPlan);
  // The sun stands in the south-west.
  EXPECT_LT(brightness(seen_at(image, 2.0, 1.6)), brightness(seen_at(image, -3.0, -2.4)) - 60);
  RenderOptions no_shadows = kPlan;
  no_shadows.shadows = false;
  const RgbImage plain = render_world(world, no_shadows);
  EXPECT_EQ(seen_at(plain, 2.0, 1.6), seen_at(plain, -3.0, -2.4));
}

TEST(RenderWorld, LetsOneSeeThroughGlass) {
  World world = white_floor();
  world.entities.push_back(box("crate", {0, 0, 0.5}, {6, 6, 1}, 1));
  world.entities.push_back(box("pane", {0, 0, 1.5}, {3, 3, 0.1}, 2));
  const RgbImage image = render_world(world, kPlan);
  const Rgb through = seen_at(image, 0, 0);
  EXPECT_GT(through.red, 80) << "the crate below";
  EXPECT_GT(through.blue, seen_at(image, 2, 2).blue + 40) << "and the glass over it";
}

TEST(RenderWorld, CutsWallsAndNothingElse) {
  World world = white_floor();
  world.entities.push_back(box("wall", {-5, 0, 2}, {2, 2, 4}, 1));
  Entity statue = box("statue", {5, 0, 2}, {2, 2, 4}, 1);
  statue.kind = EntityKind::furniture;
  world.entities.push_back(statue);
  world.entities.push_back(box("lintel", {0, 5, 3}, {2, 2, 1}, 1));
  RenderOptions cut = kPlan;
  cut.cut_height = 1.0;
  cut.shadows = false;
  const RgbImage image = render_world(world, cut);
  EXPECT_LT(brightness(seen_at(image, -5, 0)), brightness(seen_at(image, 5, 0)) - 50)
      << "the cut is dark";
  EXPECT_EQ(seen_at(image, 0, 5), seen_at(image, 0, -5)) << "what begins above the cut is gone";
}

TEST(RenderWorld, ShowsWhatIsMovedAboutWhereItStandsInTheBeginning) {
  World world = white_floor();
  world.movables.push_back({.entity = box("crate", {6, 3, 0.5}, {2, 2, 1}, 1)});
  EXPECT_TRUE(is_red(seen_at(render_world(world, kPlan), 6, 3)));
  Visitors elsewhere;  // of a simulation that went on
  elsewhere.entities = {box("crate", {-6, 3, 0.5}, {2, 2, 1}, 1)};
  EXPECT_FALSE(is_red(seen_at(render_world(world, kPlan, elsewhere), 6, 3)));
}

TEST(RenderWorld, ShowsVisitorsAndTheirLaser) {
  const World world = white_floor();
  Visitors visitors;
  visitors.entities = {box("robot", {-5, 0, 0.5}, {2, 2, 1}, 1)};
  visitors.fans = {
      {.origin = {-4, 0, 0.3}, .ends = {{6, -4, 0.3}, {6, 4, 0.3}}, .is_hit = {true, true}}};
  const RgbImage image = render_world(world, kPlan, visitors);
  EXPECT_TRUE(is_red(seen_at(image, -5, 0)));
  const Rgb fan = seen_at(image, 3, 0);
  EXPECT_GT(fan.red, fan.green + 20) << "a tinge of red over the floor";
}

TEST(RenderWorld, ShowsOnlyWhatLiesAboutTheCenterWhereThatIsWanted) {
  World world = white_floor();
  world.entities.push_back(box("crate", {6, 3, 0.5}, {2, 2, 1}, 1));
  RenderOptions near = kPlan;
  near.center = {6.0, 3.0};
  near.reach = 0.8;
  const RgbImage image = render_world(world, near);
  EXPECT_TRUE(is_red(image.at(2, 2)));
  EXPECT_TRUE(is_red(image.at(38, 38)));
  near.center = {6.0};
  EXPECT_THROW(render_world(world, near), InputError);
}

TEST(RenderSimulation, ShowsTheRobotWhereItStandsAndWhatItSees) {
  World world = white_floor();
  world.entities.push_back(box("wall", {8, 0, 0.5}, {1, 12, 1}, 0));
  Robot robot;
  robot.name = "cart";
  robot.height = 0.4;
  robot.footprint = {.length = 2.0, .width = 2.0};
  robot.drive.track = 1.6;
  LaserModel laser;
  laser.max_range = 30.0;
  robot.sensors = {{.name = "front", .robot_from_sensor = {.z = 0.5}, .model = laser}};
  Simulation simulation(world, robot, {-5.0, 3.0, 0.0}, {}, Rng(1));
  for (int i = 0; i < 10; ++i) simulation.step({});
  Painter painter;
  const RgbImage image = render_simulation(painter, simulation, kPlan);
  EXPECT_TRUE(is_red(seen_at(image, -5.4, 3.4)));
  EXPECT_FALSE(is_red(seen_at(image, -5, -3)));
  const Rgb ahead = seen_at(image, 0, 3);
  const Rgb behind = seen_at(image, -8, 3);
  EXPECT_GT(ahead.red - ahead.green, behind.red - behind.green + 20) << "the fan of the laser";
}

TEST(RenderWorld, DrawsTheSamePictureAgain) {
  World world = white_floor();
  world.entities.push_back(box("crate", {2, 1, 0.5}, {2, 2, 1}, 1));
  RenderOptions options;
  options.width = 64;
  options.height = 48;
  Painter painter;
  const RgbImage once = render_world(painter, world, options, {});
  EXPECT_EQ(once, render_world(painter, world, options, {}));
  EXPECT_EQ(once, render_world(world, options));
}

TEST(RenderWorld, LooksTheSameThroughTheSecondLibrary) {
  std::unique_ptr<Painter> egl;
  try {
    egl = std::make_unique<Painter>(GlBackend::egl);
  } catch (const InputError&) {
    GTEST_SKIP() << "EGL is not installed";
  }
  World world = white_floor();
  world.entities.push_back(box("crate", {6, 3, 0.5}, {2, 2, 1}, 1));
  const RgbImage image = render_world(*egl, world, kPlan, {});
  EXPECT_TRUE(is_red(seen_at(image, 6, 3)));
  EXPECT_FALSE(is_red(seen_at(image, -6, 3)));
}

TEST(Camera, SeesAllOfTheBoxAndLittleElse) {
  const Eigen::AlignedBox3d world(Eigen::Vector3d(3, -4, 0), Eigen::Vector3d(33, 41, 2));
  for (const double azimuth : {-2.0, -1.2, 0.3}) {
    const Eigen::Matrix4d to_picture =
        projection(camera_on(world, azimuth, 0.9, 4.0 / 3.0), 4.0 / 3.0, world);
    Eigen::AlignedBox2d seen;
    for (int i = 0; i < 8; ++i) {
      const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(i);
      const Eigen::Vector4d p = to_picture * world.corner(corner).homogeneous();
      seen.extend(Eigen::Vector2d(p.head<2>() / p.w()));
      EXPECT_LT(std::abs(p.z() / p.w()), 1.0);
    }
    EXPECT_LE(seen.max().cwiseAbs().maxCoeff(), 1.0);
    EXPECT_GT(seen.sizes().maxCoeff(), 1.8) << "in one direction it fills the picture";
    EXPECT_LT(seen.center().norm(), 0.02);
  }
}

}  // namespace
}  // namespace mapbed
