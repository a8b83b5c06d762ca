#include "sim/scene/ray_caster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <embree3/rtcore.h>

#include "core/check.h"
#include "sim/scene/surfaces.h"

namespace mapbed {
namespace {

// Embree's geometries, numbered alike in the still and the moving scene so that a hit names its
// kind. Opaque and glass stand in geometries of their own, told apart by the ray's mask.
enum GeometryId : unsigned {
  kTriangles = 0,       // + 1: glass
  kStillSolids = 2,     // + 1: glass
  kMovingSolids = 4,    // + 1: glass
  kFirstInstance = 16,  // moving meshes
};
constexpr std::array<unsigned, 2> kMasks = {1, 2};  // opaque, glass
constexpr std::size_t kPacket = 16;

using Solids = std::vector<Solid>;

struct MovingMesh {
  PlacedPart placed;
  Triangles triangles;  // in the part's frame
  RTCScene scene;
  RTCGeometry instance;
};

// A moving part's place: in the solids (opaque, glass) or the meshes.
struct Slot {
  bool solid;
  bool glass;
  std::size_t index;
};

// Embree hands the context back to our callback, which finds the rays in double precision there.
struct Query {
  RTCIntersectContext context;
  const Ray* rays;

  explicit Query(std::span<const Ray> packet) : rays(packet.data()) {
    rtcInitIntersectContext(&context);
    if (run_alike(packet)) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }

  // Neighbours in a fan go down the tree together; others are faster each by itself.
  static bool run_alike(std::span<const Ray> packet) {
    constexpr double kAlike = 0.9;  // cosine of the angle to the first one
    return std::all_of(packet.begin(), packet.end(), [&](const Ray& ray) {
      return ray.direction.dot(packet.front().direction) > kAlike;
    });
  }
};

void bounds_of_solid(const RTCBoundsFunctionArguments* args) {
  const Solid& solid = (*static_cast<const Solids*>(args->geometryUserPtr))[args->primID];
  RTCBounds& b = *args->bounds_o;
  if (!solid.placed().visible) {
    b = {1.0F, 1.0F, 1.0F, 0.0F, -1.0F, -1.0F, -1.0F, 0.0F};  // inside out: not in the tree
    return;
  }
  // 0.1 mm wider, to be safe from rounding to float.
  const Eigen::Vector3d half = solid.half_extent() + Eigen::Vector3d::Constant(1e-4);
  const Eigen::Vector3f low = (solid.center() - half).cast<float>();
  const Eigen::Vector3f high = (solid.center() + half).cast<float>();
  b = {low.x(), low.y(), low.z(), 0.0F, high.x(), high.y(), high.z(), 0.0F};
}

void intersect_solid(const RTCIntersectFunctionNArguments* args) {
  const Solid& solid = (*static_cast<const Solids*>(args->geometryUserPtr))[args->primID];
  const Query& query = *reinterpret_cast<const Query*>(args->context);
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    Ray ray = query.rays[RTCRayN_id(rays, args->N, i)];
    ray.max_range = std::min<double>(ray.max_range, RTCRayN_tfar(rays, args->N, i));
    const std::optional<Crossing> crossing = solid.first_crossing(ray);
    if (!crossing) continue;
    RTCRayN_tfar(rays, args->N, i) = static_cast<float>(crossing->range);
    RTCHitN_geomID(hits, args->N, i) = args->geomID;
    RTCHitN_primID(hits, args->N, i) = args->primID;
    RTCHitN_instID(hits, args->N, i, 0) = RTC_INVALID_GEOMETRY_ID;
  }
}

void attach(RTCScene scene, RTCGeometry geometry, unsigned id, unsigned mask) {
  rtcSetGeometryMask(geometry, mask);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
}

void attach_triangles(RTCDevice device, RTCScene scene, const Triangles& triangles, unsigned id,
                      unsigned mask) {
  const std::size_t count = triangles.planes.size();
  if (count == 0) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
  std::copy(triangles.corners.begin(), triangles.corners.end(), corners);
  for (unsigned i = 0; i < 3 * count; ++i) indices[i] = i;
  attach(scene, geometry, id, mask);
  rtcReleaseGeometry(geometry);  // the scene holds it
}

RTCGeometry attach_solids(RTCDevice device, RTCScene scene, Solids& solids, unsigned id,
                          unsigned mask) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(solids.size()));
  rtcSetGeometryUserData(geometry, &solids);
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* args) { bounds_of_solid(args); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_solid);
  attach(scene, geometry, id, mask);
  rtcReleaseGeometry(geometry);
  return geometry;
}

void set_transform(RTCGeometry instance, const Pose3& world_from_part) {
  const Eigen::Matrix3f turn = world_from_part.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f shift = world_from_part.position.cast<float>();
  std::array<float, 12> columns;
  std::copy_n(turn.data(), 9, columns.begin());
  std::copy_n(shift.data(), 3, columns.begin() + 9);
  rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
}

Hit hit_on(const PlacedPart& placed, const Crossing& crossing) {
  return {crossing.range, placed.entity, placed.part, placed.material, crossing.normal};
}

float upper(double range) {
  return std::nextafter(static_cast<float>(range), std::numeric_limits<float>::infinity());
}

}  // namespace

struct RayCaster::State {
  RTCDevice device;
  RTCScene still;
  RTCScene moving;
  std::vector<PlacedPart> owners;  // of the still triangles; without their geometry
  std::array<Triangles, 2> still_triangles;
  std::array<Solids, 2> still_solids;
  std::array<Solids, 2> moving_solids;
  std::array<RTCGeometry, 2> moving_geometries;
  std::vector<MovingMesh> meshes;
  std::vector<Slot> slots;

  State() {
    // One thread builds: the tree, and with it which of two equally near parts is hit, must not
    // depend on how many there are.
    device = rtcNewDevice("threads=1,start_threads=0");
    CHECK(device != nullptr);
    still = rtcNewScene(device);
    rtcSetSceneFlags(still, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(still, RTC_BUILD_QUALITY_HIGH);
    moving = rtcNewScene(device);
    rtcSetSceneFlags(moving,
                     static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC));
    rtcSetSceneBuildQuality(moving, RTC_BUILD_QUALITY_LOW);
    for (unsigned glass : {0u, 1u}) {
      moving_geometries[glass] =
          attach_solids(device, moving, moving_solids[glass], kMovingSolids + glass, kMasks[glass]);
    }
    rtcCommitScene(moving);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    rtcReleaseScene(moving);
    rtcReleaseScene(still);
    for (const MovingMesh& mesh : meshes) rtcReleaseScene(mesh.scene);
    rtcReleaseDevice(device);
  }

  // The hit that Embree found, made exact.
  Hit exact(const Ray& ray, float range, unsigned geometry, unsigned primitive,
            unsigned instance) const {
    if (geometry == RTC_INVALID_GEOMETRY_ID) return {};
    Hit hit;
    if (instance != RTC_INVALID_GEOMETRY_ID) {
      const MovingMesh& mesh = meshes[instance - kFirstInstance];
      hit = exact_on_mesh(mesh, ray, range, primitive);
    } else if (geometry >= kStillSolids) {
      const auto& solids = geometry >= kMovingSolids ? moving_solids : still_solids;
      const Solid& solid = solids[geometry & 1][primitive];
      const std::optional<Crossing> crossing = solid.first_crossing(ray);
      if (crossing) hit = hit_on(solid.placed(), *crossing);
    } else {
      const Triangles& triangles = still_triangles[geometry];
      hit = hit_on(owners[static_cast<std::size_t>(triangles.owners[primitive])],
                   crossing_with(triangles.planes[primitive], ray, range));
    }
    return hit.range >= ray.min_range && hit.range <= ray.max_range ? hit : Hit{};
  }

  static Hit exact_on_mesh(const MovingMesh& mesh, const Ray& ray, float range,
                           unsigned primitive) {
    const Pose3 part_from_world = inverse(mesh.placed.world_from_part);
    Ray in_part = ray;
    in_part.origin = part_from_world * ray.origin;
    in_part.direction = part_from_world.rotation * ray.direction;
    Crossing crossing = crossing_with(mesh.triangles.planes[primitive], in_part, range);
    crossing.normal = mesh.placed.world_from_part.rotation * crossing.normal;
    return hit_on(mesh.placed, crossing);
  }
};

RayCaster::RayCaster(const std::vector<PlacedPart>& still) : state_(std::make_unique<State>()) {
  State& s = *state_;
  for (const PlacedPart& placed : still) {
    // Of what stands still, boxes are faster as triangles, and the planes make them as exact.
    if (std::holds_alternative<Cylinder>(placed.geometry)) {
      s.still_solids[placed.glass].emplace_back(placed);
      continue;
    }
    s.still_triangles[placed.glass].add(mesh_of(placed.geometry), placed.world_from_part,
                                        static_cast<int>(s.owners.size()));
    s.owners.push_back(placed);
    s.owners.back().geometry = Box{};  // the triangles are all that is needed
  }
  for (unsigned glass : {0u, 1u}) {
    attach_triangles(s.device, s.still, s.still_triangles[glass], kTriangles + glass,
                     kMasks[glass]);
    attach_solids(s.device, s.still, s.still_solids[glass], kStillSolids + glass, kMasks[glass]);
  }
  rtcCommitScene(s.still);
  CHECK(rtcGetDeviceError(s.device) == RTC_ERROR_NONE);
}

RayCaster::~RayCaster() = default;

int RayCaster::add(const PlacedPart& part) {
  State& s = *state_;
  if (is_analytic(part.geometry)) {
    Solids& solids = s.moving_solids[part.glass];
    s.slots.push_back({true, part.glass, solids.size()});
    solids.emplace_back(part);
  } else {
    s.slots.push_back({false, part.glass, s.meshes.size()});
    MovingMesh mesh{part, {}, rtcNewScene(s.device), nullptr};
    mesh.triangles.add(mesh_of(part.geometry), Pose3{}, 0);
    rtcSetSceneFlags(mesh.scene, RTC_SCENE_FLAG_ROBUST);
    attach_triangles(s.device, mesh.scene, mesh.triangles, 0, kMasks[part.glass]);
    rtcCommitScene(mesh.scene);
    mesh.instance = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(mesh.instance, mesh.scene);
    set_transform(mesh.instance, part.world_from_part);
    attach(s.moving, mesh.instance, kFirstInstance + static_cast<unsigned>(s.meshes.size()),
           kMasks[part.glass]);
    rtcReleaseGeometry(mesh.instance);
    s.meshes.push_back(std::move(mesh));
  }
  return static_cast<int>(s.slots.size()) - 1;
}

void RayCaster::place(int moving, const Pose3& world_from_part, bool visible) {
  State& s = *state_;
  const Slot& slot = s.slots[static_cast<std::size_t>(moving)];
  if (slot.solid) {
    s.moving_solids[slot.glass][slot.index].place(world_from_part, visible);
    return;
  }
  MovingMesh& mesh = s.meshes[slot.index];
  mesh.placed.world_from_part = world_from_part;
  mesh.placed.visible = visible;
  set_transform(mesh.instance, world_from_part);
  visible ? rtcEnableGeometry(mesh.instance) : rtcDisableGeometry(mesh.instance);
  rtcCommitGeometry(mesh.instance);
}

void RayCaster::update() {
  State& s = *state_;
  for (unsigned glass : {0u, 1u}) {
    RTCGeometry geometry = s.moving_geometries[glass];
    rtcSetGeometryUserPrimitiveCount(geometry,
                                     static_cast<unsigned>(s.moving_solids[glass].size()));
    rtcCommitGeometry(geometry);
  }
  rtcCommitScene(s.moving);
  CHECK(rtcGetDeviceError(s.device) == RTC_ERROR_NONE);
}

Hit RayCaster::cast(const Ray& ray) const {
  Query query(std::span(&ray, 1));
  RTCRayHit rh;
  rh.ray = {static_cast<float>(ray.origin.x()),
            static_cast<float>(ray.origin.y()),
            static_cast<float>(ray.origin.z()),
            static_cast<float>(ray.min_range),
            static_cast<float>(ray.direction.x()),
            static_cast<float>(ray.direction.y()),
            static_cast<float>(ray.direction.z()),
            0.0F,
            upper(ray.max_range),
            ray.through_glass ? kMasks[0] : ~0u,
            0,
            0};
  rh.hit.geomID = rh.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(state_->still, &query.context, &rh);
  if (!state_->slots.empty()) rtcIntersect1(state_->moving, &query.context, &rh);
  return state_->exact(ray, rh.ray.tfar, rh.hit.geomID, rh.hit.primID, rh.hit.instID[0]);
}

void RayCaster::cast(std::span<const Ray> rays, std::span<Hit> hits) const {
  CHECK(rays.size() == hits.size());
  for (std::size_t first = 0; first < rays.size(); first += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - first);
    Query query(rays.subspan(first, count));
    RTCRayHit16 rh;
    alignas(64) std::array<int, kPacket> valid{};
    for (std::size_t i = 0; i < count; ++i) {
      const Ray& ray = rays[first + i];
      valid[i] = -1;
      rh.ray.org_x[i] = static_cast<float>(ray.origin.x());
      rh.ray.org_y[i] = static_cast<float>(ray.origin.y());
      rh.ray.org_z[i] = static_cast<float>(ray.origin.z());
      rh.ray.dir_x[i] = static_cast<float>(ray.direction.x());
      rh.ray.dir_y[i] = static_cast<float>(ray.direction.y());
      rh.ray.dir_z[i] = static_cast<float>(ray.direction.z());
      rh.ray.tnear[i] = static_cast<float>(ray.min_range);
      rh.ray.tfar[i] = upper(ray.max_range);
      rh.ray.time[i] = 0.0F;
      rh.ray.mask[i] = ray.through_glass ? kMasks[0] : ~0u;
      rh.ray.id[i] = static_cast<unsigned>(i);
      rh.ray.flags[i] = 0;
      rh.hit.geomID[i] = rh.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid.data(), state_->still, &query.context, &rh);
    if (!state_->slots.empty()) {
      rtcIntersect16(valid.data(), state_->moving, &query.context, &rh);
    }
    for (std::size_t i = 0; i < count; ++i) {
      hits[first + i] = state_->exact(rays[first + i], rh.ray.tfar[i], rh.hit.geomID[i],
                                      rh.hit.primID[i], rh.hit.instID[0][i]);
    }
  }
}

}  // namespace mapbed
