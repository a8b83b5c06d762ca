#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/random.h"
#include "sim/actors/navigation_map.h"
#include "worlds/world.h"

namespace mapbed {

// One walker's way along a route: from point to point, to and fro or round, now and then pausing.
// Says which velocity it would like; gives way only by what the forces do.
class Itinerary {
 public:
  // `next` is the route's point to go to first, `direction` +1 or -1.
  Itinerary(const CrowdRoute& route, const CrowdRules& rules, std::size_t next, int direction,
            Rng rng);

  // Wished velocity [m/s] of somebody there who walks at `speed`.
  Eigen::Vector2d wish(const Eigen::Vector2d& position, double speed, double radius,
                       const NavigationMap& map, double time);
  bool is_pausing(double time) const { return time < pause_until_; }

 private:
  void arrive(double time);
  void turn_back();
  void plan_way(const Eigen::Vector2d& position, double radius, const NavigationMap& map);

  std::vector<Eigen::Vector2d> points_;
  bool closed_;
  double pause_fraction_;
  double mean_pause_;  // [s]
  std::size_t next_;
  int direction_;
  Rng rng_;
  Eigen::Vector2d goal_ = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> corners_;  // of the way to goal_
  std::size_t corner_ = 0;
  double pause_until_ = -1.0;  // [s]
  double next_look_ = 0.0;     // [s] when to see whether the way has become shorter
  int vain_plans_ = 0;         // new plans on this way that did not help
  Eigen::Vector2d anchor_ = Eigen::Vector2d::Zero();  // where it was at anchored_at_
  double anchored_at_ = 0.0;                          // [s]
};

}  // namespace mapbed
