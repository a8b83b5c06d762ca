#pragma once

#include <optional>
#include <vector>

#include "core/random.h"
#include "sim/actors/crowd_options.h"
#include "sim/actors/gait.h"
#include "sim/actors/itinerary.h"
#include "sim/actors/navigation_map.h"
#include "sim/actors/obstacle.h"
#include "sim/actors/social_force.h"

namespace mapbed {

inline constexpr double kPairGap = 0.75;  // [m] between two who walk together

enum class PersonKind : int { walker, standing, blocker };

// What somebody in a crowd is up to.
struct Person {
  PersonKind kind = PersonKind::walker;
  double speed = 1.0;                               // [m/s] wished
  std::optional<Itinerary> itinerary;               // of walkers who lead, and of blockers
  int leader = -1;                                  // of the one who walks beside
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  // of who stands
  double heading = 0.0;                             // [rad] of who stands
  double blocks_from = 0.0;                         // [s] next or present time
  double blocks_until = 0.0;                        // [s]
  Gait gait{GaitOptions{}, 0.0};
};

struct CrowdMembers {
  std::vector<Person> people;
  std::vector<Walker> bodies;  // as many
};

// Who is about in the beginning: drawn person by person, each from a stream of its own. Throws
// InputError where the world has no routes or places for the people asked for, or where they do not
// fit.
CrowdMembers drawn_crowd(const World& world, const NavigationMap& map, const Obstacle& robot,
                         const CrowdOptions& options, const Rng& rng);

}  // namespace mapbed
