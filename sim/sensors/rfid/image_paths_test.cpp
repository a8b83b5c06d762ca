#include "sim/sensors/rfid/image_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <gmock/gmock.h>

#include "core/random.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

using Eigen::Vector3d;

std::vector<MirrorFace> faces_of(const World& world) {
  return mirror_faces(world, {.smallest = 0.33, .floor = true});
}

TEST(MirrorFaces, ABoxHasSixThatLookOutwards) {
  World world;
  Entity box{.world_from_entity = upright({1.0, 2.0, 0.3}, 0.5)};
  box.parts = {{"box", Box{{2.0, 1.0, 0.8}}, {}, 4}};
  world.entities = {box};
  const std::vector<MirrorFace> faces = faces_of(world);
  ASSERT_EQ(faces.size(), 6u);
  for (const MirrorFace& face : faces) {
    EXPECT_LT(height_over(face, {1.0, 2.0, 0.5}), 0.0);
    EXPECT_EQ(face.material, 4);
  }
  const Vector3d above(1.0, 2.0, 3.0);
  const auto top = std::max_element(faces.begin(), faces.end(), [](const auto& a, const auto& b) {
    return a.normal.z() < b.normal.z();
  });
  EXPECT_NEAR(height_over(*top, above), 2.1, 1e-12);
  EXPECT_LT((mirrored(*top, above) - Vector3d(1.0, 2.0, -1.2)).norm(), 1e-12);
  EXPECT_TRUE(contains(*top, {1.9, 2.2, 0.9}));
  EXPECT_FALSE(contains(*top, {1.9, 1.7, 0.9}));
}

TEST(MirrorFaces, NarrowOnesFloorsThatAreNotAskedForAndWhatMovesAreNone) {
  World world;
  Entity plate{.world_from_entity = upright({}, 1.0)};
  plate.parts = {{"plate", Box{{2.0, 0.3, 2.0}}, {}, 0}};
  world.entities = {plate};
  EXPECT_EQ(faces_of(world).size(), 2u) << "its sides and its top are 30 cm wide";
  world.entities[0].kind = EntityKind::door;
  EXPECT_TRUE(faces_of(world).empty());
  world.entities[0].kind = EntityKind::floor;
  EXPECT_EQ(faces_of(world).size(), 2u);
  EXPECT_TRUE(mirror_faces(world, {.smallest = 0.33, .floor = false}).empty());
}

TEST(MirrorFaces, ANotchInAnOutlineIsNoPartOfIt) {
  World world;
  Entity stage;
  stage.parts = {{"stage", Extrusion{{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}, 0.0, 1.0}, {}, 0}};
  world.entities = {stage};
  const std::vector<MirrorFace> faces = faces_of(world);
  ASSERT_EQ(faces.size(), 7u);
  EXPECT_NEAR(faces[0].normal.z(), 1.0, 1e-12);
  EXPECT_TRUE(contains(faces[0], {0.5, 2.0, 1.0}));
  EXPECT_FALSE(contains(faces[0], {2.0, 2.0, 1.0}));
  EXPECT_NEAR(faces[1].normal.z(), -1.0, 1e-12);
  EXPECT_FALSE(contains(faces[1], {2.0, 2.0, 0.0}));
}

// The smallest value of a convex function of points on faces, each given by two numbers in [0, 1]:
// grids of five values each, ever finer around the best one.
struct Shortest {
  double length = 1e9;
  std::vector<double> at;
};
Shortest shortest(std::size_t numbers,
                  const std::function<double(const std::vector<double>&)>& length) {
  Shortest best{.at = std::vector<double>(numbers, 0.5)};
  for (double width = 0.5; width > 1e-5; width *= 0.7) {
    const std::vector<double> middle = best.at;
    std::vector<int> index(numbers, 0);
    for (;;) {
      std::vector<double> at(numbers);
      for (std::size_t i = 0; i < numbers; ++i) {
        at[i] = std::clamp(middle[i] + width * (index[i] - 2) / 2.0, 0.0, 1.0);
      }
      const double here = length(at);
      if (here < best.length) best = {here, at};
      std::size_t i = 0;
      while (i < numbers && ++index[i] == 5) index[i++] = 0;
      if (i == numbers) break;
    }
  }
  return best;
}

Vector3d on_face(const MirrorFace& face, double u, double v) {
  const Eigen::Vector2d p = face.box.min() + Eigen::Vector2d(u, v).cwiseProduct(face.box.sizes());
  return face.offset * face.normal + p.x() * face.across + p.y() * face.along;
}

// Fermat: of all ways by a point of a mirror, the wave takes the shortest. Where that lies on the
// face's border, there is none.
TEST(ImagePaths, AreTheShortestOfAllWaysByTheirMirrors) {
  World room = small_room(6.0, 4.0);
  room.entities.push_back(block("screen", {3.0, 2.0}, {0.1, 1.0}));
  const std::vector<MirrorFace> faces = faces_of(room);
  Rng rng(3);
  int once = 0, twice = 0, none = 0, missed = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const auto place = [&] {
      return Vector3d(rng.uniform(0.2, 5.8), rng.uniform(0.2, 3.8), rng.uniform(0.2, 2.3));
    };
    const Vector3d antenna = place(), tag = place();
    for (const MirrorImage& image : images_of(tag, faces, 2, 50.0)) {
      const MirrorFace& first = faces[static_cast<std::size_t>(image.faces[0])];
      const MirrorFace& second = faces[static_cast<std::size_t>(image.faces[1])];
      if (height_over(first, antenna) <= 0.0) continue;
      if (image.mirrors == 2 && height_over(second, antenna) <= 0.0) continue;
      const std::optional<RadioPath> path = path_by(image, faces, antenna, tag);
      const bool is_twice = image.mirrors == 2;
      if (is_twice && twice >= 12 && path) continue;  // slow
      if (!path && none >= 12 && (is_twice || missed >= 12)) continue;
      const Shortest best = shortest(is_twice ? 4 : 2, [&](const std::vector<double>& at) {
        const Vector3d last = on_face(first, at[0], at[1]);
        if (!is_twice) return (antenna - last).norm() + (last - tag).norm();
        const Vector3d before = on_face(second, at[2], at[3]);
        return (antenna - before).norm() + (before - last).norm() + (last - tag).norm();
      });
      const bool is_inside = std::all_of(best.at.begin(), best.at.end(),
                                         [](double u) { return u > 1e-3 && u < 1.0 - 1e-3; });
      if (!path) {
        EXPECT_FALSE(is_inside);
        ++(is_twice ? none : missed);
        continue;
      }
      EXPECT_NEAR(path->length, best.length, 1e-5);
      const auto last = static_cast<std::size_t>(image.mirrors);
      EXPECT_LT((path->points[last] - on_face(first, best.at[0], best.at[1])).norm(), 0.02);
      EXPECT_EQ(path->end(), tag);
      ++(is_twice ? twice : once);
    }
  }
  EXPECT_GT(once, 20);
  EXPECT_GE(twice, 12);
  EXPECT_GE(none, 12);
  EXPECT_GE(missed, 5) << "of the screen";
}

TEST(ImagePaths, AreTheSameThereAndBack) {
  World room = small_room(6.0, 4.0);
  add_floor(room);
  const std::vector<MirrorFace> faces = faces_of(room);
  const Vector3d a(1.0, 1.0, 0.6), b(4.5, 2.5, 1.4);
  const auto lengths = [&](const Vector3d& from, const Vector3d& to) {
    std::vector<double> result;
    for (const MirrorImage& image : images_of(to, faces, 2, 50.0)) {
      if (const auto path = path_by(image, faces, from, to)) result.push_back(path->length);
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  const std::vector<double> there = lengths(a, b);
  EXPECT_GE(there.size(), 5u + 8u) << "four walls and the floor, and pairs of them";
  EXPECT_THAT(there, ::testing::Pointwise(::testing::DoubleNear(1e-12), lengths(b, a)));
}

TEST(ImagePaths, TheFaceThatATagSticksOnIsNoMirrorOfIt) {
  const std::vector<MirrorFace> faces = faces_of(small_room(6.0, 4.0));
  const Vector3d tag(3.0, 0.01, 1.3);
  for (const MirrorImage& image : images_of(tag, faces, 1, 50.0)) {
    EXPECT_GT((image.places[0] - tag).norm(), 0.1);
  }
  EXPECT_EQ(images_of({3.0, 0.06, 1.3}, faces, 1, 50.0).size(),
            images_of(tag, faces, 1, 50.0).size() + 1);
}

}  // namespace
}  // namespace mapbed
