#pragma once

#include <vector>

#include "core/driver.h"
#include "core/log/sensor_log.h"
#include "core/random.h"
#include "sim/sensors/ideal_scan.h"
#include "sim/simulation.h"
#include "sim/truth.h"

namespace mapbed {

// A drive without noise, and what was true during it. Noise is drawn afterwards, as often and as
// strong as wanted: the world is rendered once.
struct Recording {
  std::vector<IdealOdometry> odometry;  // by time
  std::vector<IdealScan> scans;         // by time
  Truth truth;
  bool is_complete = false;  // the driver was done; false: the longest time was over
};

struct RecorderOptions {
  double longest = 3600.0;   // [s] then the recording ends whether the driver is done or not
  double first_stamp = 0.0;  // [s] stamp of the start
  // Noise of what the driver is told; one that only looks at the simulation needs none.
  bool tells_driver = false;
};

template <class Visitor>
void visit_fields(RecorderOptions& o, Visitor&& visit) {
  visit("longest", o.longest, Unit::second, kPositive, "the recording ends after this");
  visit("first_stamp", o.first_stamp, Unit::second, kNotNegative, "stamp of the start");
  visit("tells_driver", o.tells_driver, "the driver gets the measurements, with noise");
}

// Drives until the driver is done. Every laser sweeps at its own rate; odometry is read at every
// sweep's stamp, and at its own rate besides. `rng` draws the noise of what the driver is told, the
// same that with_noise(recording, robot, rng) draws.
Recording record(Simulation& simulation, Driver& driver, const RecorderOptions& options,
                 const Rng& rng);

// The log that the robot would have written.
SensorLog with_noise(const Recording& recording, const Robot& robot, const Rng& rng);

}  // namespace mapbed
