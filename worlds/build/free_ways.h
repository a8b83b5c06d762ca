#pragma once

#include <vector>

#include <Eigen/Core>

#include "worlds/geometry/footprint.h"
#include "worlds/world.h"

namespace mapbed {

// A straight way that must stay free.
struct FreeWay {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
  double clearance = 0.3;  // [m] to either side
};

// Of the world's paths, crowd routes and standing places, and where its door leaves turn.
std::vector<FreeWay> free_ways(const World& world);

// Adds furniture where there is room for it.
class Furnisher {
 public:
  explicit Furnisher(World& world);  // paths, crowd and walls stand already

  void keep_free(const FreeWay& way);  // besides those of the world

  // Unless it would come closer than `gap` [m] to something or into a free way.
  bool place(Entity entity, double gap = 0.01);

 private:
  struct Taken {
    Footprint footprint;
    Eigen::AlignedBox2d box;
  };
  bool is_free(const Footprint& footprint, double gap) const;
  void take(const Entity& entity, int id);

  World& world_;
  std::vector<FreeWay> ways_;
  std::vector<Taken> taken_;
};

// Throw InputError where a path or a crowd route runs too close to something (doors open), with the
// path, the thing and the place, or where a path has less than two points.
void check_path(const World& world, const NamedPath& path);
void check_route(const World& world, const CrowdRoute& route);
void check_ways(const World& world);  // all of them

}  // namespace mapbed
