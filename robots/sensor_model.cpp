#include "robots/sensor_model.h"

#include <cmath>
#include <map>
#include <string>

#include "core/config/config_node.h"
#include "core/config/quantity.h"
#include "core/config/suggestion.h"
#include "core/data_path.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kMostRays = 1e8;     // [1/s] that are cast: minutes for each second of the drive
constexpr double kOneInstant = 0.01;  // [s] that a sweep may take which is stamped in its middle

void check(const LaserModel& laser, const SourceLocation& place) {
  if (laser.beams * laser.bearing_step > 2.0 * kPi + 1e-4) {
    throw InputError(place, "the beams cover more than a full turn", "lower beams or bearing_step");
  }
  const double rays = laser.scan_rate * laser.beams * laser.sub_rays;
  if (rays > kMostRays) {
    throw InputError(place,
                     "the laser sends " + quantity_text(rays, Unit::none) + " rays a second, of " +
                         quantity_text(kMostRays, Unit::none) + " at most",
                     "lower beams, sub_rays or scan_rate");
  }
  if (laser.min_range >= laser.max_range) {
    throw InputError(place, "min_range is not below max_range", "nothing would be seen");
  }
  if (laser.noise.far_range < laser.noise.near_range) {
    throw InputError(place, "noise.far_range is below noise.near_range",
                     "the error grows from near_range to far_range");
  }
  if (laser.mirror_rate > 0.0 && laser.scan_rate * laser.interlace > laser.mirror_rate) {
    throw InputError(place, "sweeps come faster than the mirror turns",
                     "lower scan_rate, or raise mirror_rate (0: all beams at once)");
  }
  if (laser.stamp == SweepStamp::middle && laser.beam_period() > 0.0 &&
      laser.sweep_time() > kOneInstant) {
    throw InputError(place,
                     "a sweep of " + std::to_string(std::lround(1e3 * laser.sweep_time())) +
                         " ms is stamped in its middle, and its beams are taken from the stamp on",
                     "take stamp: first_beam, or raise mirror_rate");
  }
}

void check(const RfidModel& rfid, const SourceLocation& place) {
  if (rfid.noise.ghosts > 0.1 * rfid.slots) {
    throw InputError(place, "there are more ghosts than slots for them",
                     "lower noise.ghosts, or raise slots");
  }
}

template <class Model>
SensorModel model_in(const ConfigNode& file) {
  Model model;
  if (const ConfigNode* source = file.find("source")) model.source = source->text();
  read_options(file, options_of(model));
  return model;
}

// What a sensor file's `kind` may be.
const std::map<std::string, SensorModel (*)(const ConfigNode&)> kKinds = {
    {"laser", model_in<LaserModel>},
    {"rfid", model_in<RfidModel>},
};

SensorModel model_by_kind(const ConfigNode& file) {
  const ConfigNode* kind = file.find("kind");
  if (kind == nullptr) return model_in<LaserModel>(file);
  const auto found = kKinds.find(kind->text());
  if (found != kKinds.end()) return found->second(file);
  std::vector<std::string> names;
  for (const auto& [name, read] : kKinds) names.push_back(name);
  throw InputError(kind->place(), "unknown kind " + in_quotes(kind->text()) + " of a sensor",
                   suggestion(kind->text(), names));
}

}  // namespace

std::string sensor_file(const std::string& name_or_path) {
  return find_data_file("sensor", "robots/sensors", name_or_path).string();
}

SensorModel load_sensor(const std::string& name_or_path) {
  const ConfigNode file = load_config(sensor_file(name_or_path));
  const SensorModel model = model_by_kind(file);
  check_sensor(model, file.place());
  file.check_all_used("the sensor");
  return model;
}

LaserModel load_laser(const std::string& name_or_path) {
  const SensorModel model = load_sensor(name_or_path);
  const auto* laser = std::get_if<LaserModel>(&model);
  if (laser == nullptr) throw InputError("sensor " + in_quotes(name_or_path) + " is not a laser");
  return *laser;
}

std::vector<std::string> sensor_names() {
  return data_names("robots/sensors");
}

void check_sensor(const SensorModel& model, const SourceLocation& place) {
  std::visit([&](const auto& m) { check(m, place); }, model);
}

}  // namespace mapbed
