#pragma once

#include <span>
#include <vector>

#include "core/log/sensor_log.h"
#include "core/random.h"
#include "robots/robot.h"
#include "sim/noise/odometry_noise.h"
#include "sim/noise/rfid_noise.h"
#include "sim/sensors/ideal_reading.h"

namespace mapbed {

// What a robot's sensors read, one reading after the other. Every kind of sensor draws from streams
// of its own, so that none changes what another reads.
class SensorNoise {
 public:
  SensorNoise(const Robot& robot, const Rng& rng);

  Measurement read(const IdealReading& ideal);  // in order of time

 private:
  std::vector<MountedLaser> lasers_;
  OdometryReader odometry_;
  RfidReader rfid_;
  Rng rng_;
};

// The log that the robot would have written.
SensorLog with_noise(std::span<const IdealReading> readings, const Robot& robot, const Rng& rng);

// What is behind each read of an RFID tag in that log, in its order.
std::vector<TruthRead> true_reads(std::span<const IdealReading> readings, const Robot& robot,
                                  const Rng& rng);

}  // namespace mapbed
