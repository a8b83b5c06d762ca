#include "robots/specification.h"

#include <fmt/format.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

std::string millimetres(double meters) {
  return fmt::format("{:.3g} mm", 1000.0 * meters);
}

// "10 mm", "5 mm to 8 m, then up to 10 mm at 20 m", "0.3 % of the range to 10 m"
std::string sigma_text(const LaserNoise& noise) {
  if (noise.sigma_near == noise.sigma_far) return millimetres(noise.sigma_near);
  if (noise.sigma_near == 0.0 && noise.near_range == 0.0) {
    return fmt::format("{:.2g} % of the range to {:.3g} m",
                       100.0 * noise.sigma_far / noise.far_range, noise.far_range);
  }
  return fmt::format("{} to {:.3g} m, then up to {} at {:.3g} m", millimetres(noise.sigma_near),
                     noise.near_range, millimetres(noise.sigma_far), noise.far_range);
}

// "devices differ by 15 mm + 0.5 %"; empty where they do not
std::string device_text(const LaserNoise& noise) {
  std::string text;
  if (noise.bias_spread > 0.0) text = millimetres(noise.bias_spread);
  if (noise.scale_spread > 0.0) {
    text += fmt::format("{}{:.3g} %", text.empty() ? "" : " + ", 100.0 * noise.scale_spread);
  }
  return text.empty() ? "" : ", devices differ by " + text;
}

std::string text_of(const LaserModel& laser) {
  const double fan = degrees((laser.beams - 1) * laser.bearing_step);
  return fmt::format(
      "{:.3g} to {:.4g} m, {:.4g} deg in {} beams of {:.4g} deg, {:.3g} Hz, sigma {}{}, "
      "steps of {}",
      laser.min_range, laser.max_range, fan, laser.beams, degrees(laser.bearing_step),
      laser.scan_rate, sigma_text(laser.noise), device_text(laser.noise),
      millimetres(laser.noise.step));
}

std::string text_of(const RfidModel& rfid) {
  return fmt::format(
      "{:.4g} MHz, {:.3g} dBm ahead, {:.3g} deg wide, {:.3g} dB less behind, {:.3g} Hz, {} slots, "
      "tags answer from {:.3g} dBm on",
      rfid.frequency / 1e6, rfid.eirp, degrees(rfid.beam_width), rfid.front_to_back,
      rfid.round_rate, rfid.slots, rfid.threshold);
}

std::string size_text(const RobotFootprint& footprint) {
  if (footprint.radius > 0.0) return fmt::format("{:.3g} m across", 2.0 * footprint.radius);
  return fmt::format("{:.3g} x {:.3g} m", footprint.length, footprint.width);
}

std::string drive_text(const DriveModel& drive) {
  return fmt::format("{}, {:.3g} m/s, {:.3g} deg/s", name_of(drive.kind), drive.max_speed,
                     degrees(drive.max_turn_speed));
}

}  // namespace

std::string specification(const SensorModel& sensor) {
  return std::visit([](const auto& model) { return text_of(model); }, sensor);
}

std::string specification(const Robot& robot) {
  std::string text = fmt::format("{}, {:.3g} m high, {:.3g} kg, {}", size_text(robot.footprint),
                                 robot.height, robot.mass, drive_text(robot.drive));
  for (const MountedSensor& sensor : robot.sensors) {
    text += fmt::format(", {} {}", sensor.name, sensor.file);
  }
  return text;
}

}  // namespace mapbed
