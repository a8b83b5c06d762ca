#include "sim/noise/sensor_noise.h"

#include "core/check.h"
#include "sim/noise/laser_noise.h"

namespace mapbed {
namespace {

template <class... Readers>
struct Overloaded : Readers... {
  using Readers::operator()...;
};

}  // namespace

SensorNoise::SensorNoise(const Robot& robot, const Rng& rng)
    : lasers_(lasers_of(robot)), odometry_(robot.odometry, rng), rng_(rng) {}

Measurement SensorNoise::read(const IdealReading& ideal) {
  const Overloaded readers{
      [&](const IdealOdometry& odometry) -> Measurement { return odometry_.read(odometry); },
      [&](const IdealScan& scan) -> Measurement {
        CHECK(scan.laser >= 0 && static_cast<std::size_t>(scan.laser) < lasers_.size());
        return with_noise(scan, lasers_[static_cast<std::size_t>(scan.laser)], rng_);
      }};
  return std::visit(readers, ideal);
}

SensorLog with_noise(std::span<const IdealReading> readings, const Robot& robot, const Rng& rng) {
  SensorNoise noise(robot, rng);
  SensorLog log;
  log.reserve(readings.size());
  for (const IdealReading& reading : readings) log.push_back(noise.read(reading));
  return log;
}

}  // namespace mapbed
