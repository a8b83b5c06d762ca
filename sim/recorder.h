#pragma once

#include "core/config/option.h"
#include "core/driver.h"
#include "core/random.h"
#include "sim/recording.h"
#include "sim/simulation.h"

namespace mapbed {

struct RecorderOptions {
  double longest = 3600.0;     // [s] then the recording ends whether the driver is done or not
  double stuck_after = 300.0;  // [s] then a robot that stands and does not rest is stuck; 0: never
  double first_stamp = 0.0;    // [s] stamp of the start
  // Noise of what the driver is told; one that only looks at the simulation needs none.
  bool tells_driver = false;
};

template <class Visitor>
void visit_fields(RecorderOptions& o, Visitor&& visit) {
  visit("longest", o.longest, Unit::second, between(0.001, 1e6), "the recording ends after this");
  visit("stuck_after", o.stuck_after, Unit::second, between(0.0, 1e6),
        "the recording ends where the robot has stood for so long without resting; 0: it goes on");
  visit("first_stamp", o.first_stamp, Unit::second, kNotNegative, "stamp of the start");
  visit("tells_driver", o.tells_driver, "the driver gets the measurements, with noise");
}

// Drives until the driver is done, the robot is stuck or the longest time is over. Every laser
// sweeps at its own rate; odometry is read at every sweep's stamp, and at its own rate besides.
// RFID antennas have their rounds in turn, without odometry: they change nothing of the other
// readings. `rng` draws the noise of what the driver is told, the same that with_noise(readings,
// robot, rng) draws.
RecordingEnd record(Simulation& simulation, Driver& driver, const RecorderOptions& options,
                    const Rng& rng, const RecordingSink& sink);

// The same in memory.
Recording record(Simulation& simulation, Driver& driver, const RecorderOptions& options,
                 const Rng& rng);

}  // namespace mapbed
