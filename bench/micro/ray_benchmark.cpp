// Rays per second into 100,000 triangles through the whole scene: robust mode, 30 moving things,
// exact range, entity, part, material and normal returned. Target: 5 million on one core.

#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/geometry/angle.h"
#include "core/random.h"
#include "sim/scene/scene.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

Entity thing(Geometry geometry, const Pose3& pose) {
  return {.name = "thing",
          .world_from_entity = pose,
          .parts = {{.name = "thing", .geometry = std::move(geometry)}}};
}

// A cave of 100,000 triangles: a bumpy sphere seen from inside.
TriangleMesh cave(Rng& rng) {
  constexpr std::uint32_t kRows = 200, kColumns = 250;
  TriangleMesh mesh;
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const double up = kPi * (row + 0.5) / (kRows + 1) - kPi / 2;
      const double round = 2 * kPi * column / kColumns;
      const double r = 15.0 + rng.uniform(-0.3, 0.3) + 3.0 * std::sin(5 * round) * std::cos(up);
      mesh.vertices.emplace_back(r * std::cos(up) * std::cos(round),
                                 r * std::cos(up) * std::sin(round), r * std::sin(up));
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const std::uint32_t a = row * kColumns + column;
      const std::uint32_t b = row * kColumns + (column + 1) % kColumns;
      mesh.triangles.push_back({a, a + kColumns, b});
      mesh.triangles.push_back({b, a + kColumns, b + kColumns});
    }
  }
  return mesh;
}

Scene cave_with_people(Rng& rng) {
  World world;
  world.entities = {thing(cave(rng), {})};
  Scene scene(world);
  for (int i = 0; i < 30; ++i) {
    const Pose2 place{rng.uniform(-10, 10), rng.uniform(-10, 10), 0.0};
    scene.add(thing(Cylinder{0.07, 0.8}, upright(place)));
  }
  scene.update();
  return scene;
}

// Fans of 180 beams, as a laser sends them.
std::vector<Ray> fans(std::size_t count, Rng& rng) {
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const Eigen::Vector3d origin(rng.uniform(-5, 5), rng.uniform(-5, 5), 0.3);
    const double heading = rng.uniform(-kPi, kPi);
    for (int beam = 0; beam < 180; ++beam) {
      const double bearing = heading + radians(beam);
      rays.push_back({origin, {std::cos(bearing), std::sin(bearing), 0.0}});
    }
  }
  return rays;
}

std::vector<Ray> any_rays(std::size_t count, Rng& rng) {
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const Eigen::Vector3d way(rng.normal(), rng.normal(), rng.normal());
    rays.push_back({{rng.uniform(-5, 5), rng.uniform(-5, 5), 0.3}, way.normalized()});
  }
  return rays;
}

enum Order { in_fans, anyhow };

void BM_CastManyAtOnce(benchmark::State& state) {
  Rng rng(1);
  const Scene scene = cave_with_people(rng);
  const std::vector<Ray> rays =
      state.range(0) == in_fans ? fans(18'000, rng) : any_rays(18'000, rng);
  std::vector<Hit> hits(rays.size());
  for (auto _ : state) {
    scene.cast(rays, hits);
    benchmark::DoNotOptimize(hits.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}
BENCHMARK(BM_CastManyAtOnce)->ArgName("anyhow")->Arg(in_fans)->Arg(anyhow);

void BM_CastOneByOne(benchmark::State& state) {
  Rng rng(1);
  const Scene scene = cave_with_people(rng);
  const std::vector<Ray> rays =
      state.range(0) == in_fans ? fans(18'000, rng) : any_rays(18'000, rng);
  for (auto _ : state) {
    for (const Ray& ray : rays) benchmark::DoNotOptimize(scene.cast(ray));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}
BENCHMARK(BM_CastOneByOne)->ArgName("anyhow")->Arg(in_fans)->Arg(anyhow);

// What it costs to move 45 parts, as 15 people have, and to make it count.
void BM_MoveFifteenPeople(benchmark::State& state) {
  Rng rng(1);
  Scene scene(build_world("museum"));
  std::vector<int> people;
  for (int i = 0; i < 15; ++i) {
    Entity person =
        thing(Cylinder{0.07, 0.8}, upright({rng.uniform(1, 29), rng.uniform(1, 44), 0}));
    person.parts.resize(3, person.parts[0]);
    people.push_back(scene.add(person));
  }
  for (auto _ : state) {
    for (const int person : people) {
      const Eigen::Vector3d& p = scene.entity(person).world_from_entity.position;
      scene.move(person, upright({p.x(), p.y(), rng.uniform(-kPi, kPi)}));
    }
    scene.update();
  }
}
BENCHMARK(BM_MoveFifteenPeople)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mapbed
