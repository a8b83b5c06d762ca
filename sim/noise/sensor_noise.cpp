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
    : lasers_(lasers_of(robot)), odometry_(robot.odometry, rng), rfid_(robot, rng), rng_(rng) {}

Measurement SensorNoise::read(const IdealReading& ideal) {
  const Overloaded readers{
      [&](const IdealOdometry& odometry) -> Measurement { return odometry_.read(odometry); },
      [&](const IdealScan& scan) -> Measurement {
        CHECK(scan.laser >= 0 && static_cast<std::size_t>(scan.laser) < lasers_.size());
        return with_noise(scan, lasers_[static_cast<std::size_t>(scan.laser)], rng_);
      },
      [&](const IdealRfid& round) -> Measurement { return rfid_.read(round).detections; }};
  return std::visit(readers, ideal);
}

SensorLog with_noise(std::span<const IdealReading> readings, const Robot& robot, const Rng& rng) {
  SensorNoise noise(robot, rng);
  SensorLog log;
  log.reserve(readings.size());
  for (const IdealReading& reading : readings) log.push_back(noise.read(reading));
  return log;
}

std::vector<TruthRead> true_reads(std::span<const IdealReading> readings, const Robot& robot,
                                  const Rng& rng) {
  RfidReader reader(robot, rng);
  std::vector<TruthRead> reads;
  for (const IdealReading& reading : readings) {
    const auto* ideal = std::get_if<IdealRfid>(&reading);
    if (ideal == nullptr) continue;
    const RfidRound round = reader.read(*ideal);
    reads.insert(reads.end(), round.reads.begin(), round.reads.end());
  }
  return reads;
}

}  // namespace mapbed
