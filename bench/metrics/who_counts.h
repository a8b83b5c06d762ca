#pragma once

#include <vector>

#include "bench/metrics/tracking_frame.h"
#include "core/sensor/laser_scan.h"
#include "sim/truth/truth.h"

namespace mapbed {

// Whom a tracker of people who move is asked to find.
struct WhoCountsOptions {
  double range = 8.0;            // [m] from the robot, within which he is to be found
  int least_beams = 2;           // of a scan on him, for that
  double longest_absence = 3.0;  // [s] out of view, after which he is somebody new
  double least_move = 0.3;       // [m] from where he came into view: more than swaying
};

// Everybody at the moment of a scan. Who is too far away, or hidden, does not count; he is there
// all the same, so that a track which follows him is no false one.
std::vector<TrueObject> people_at(const LaserScan& scan, const StampedStates& states,
                                  const Truth& truth, const WhoCountsOptions& options);

// Of frames in which people count while they are in view: numbers by appearance, and those alone
// count who moved since they appeared. Without a look at faces nobody knows again who comes back
// after a while (MOTChallenge gives him a new number, too), nor tells who stands from a column
// before he first went; who stands after that counts.
TrackingFrames by_appearance(TrackingFrames frames, const WhoCountsOptions& options);

}  // namespace mapbed
