#include "sim/noise/laser_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kStandardRemission = 0.1;  // that dark_range is given for
constexpr std::size_t kMostSubRays = 16;

// All chance of one beam, drawn in a fixed order.
struct Draws {
  explicit Draws(Rng rng) {
    for (double& u : pane) u = rng.uniform();
    which_surface = rng.uniform();
    miss = rng.uniform();
    is_short = rng.uniform();
    is_random = rng.uniform();
    place = rng.uniform();
    darkness = rng.normal();
    error = rng.normal();
  }
  std::array<double, 4> pane;  // for the first, second ... pane on the way
  double which_surface, miss, is_short, is_random, place, darkness, error;
};

// A surface that the beam comes back from.
struct Surface {
  double range;
  double light;  // fraction * reflectivity * cos(incidence)
  double power;  // received: light / range^2
};

struct Surfaces {
  std::array<Surface, kMostSubRays> list;
  std::size_t count = 0;
  double axis_range = kInfinity;  // of the middle sub-ray
};

// One surface a sub-ray: the first that does not let the beam through.
Surfaces surfaces_of(std::span<const Echo> echoes, const LaserNoise& noise, const Draws& draws) {
  Surfaces result;
  std::size_t sub_ray_count = 0;
  std::size_t i = 0;
  double covered = 0.0;
  bool axis_done = false;
  while (i < echoes.size()) {
    const int sub_ray = echoes[i].sub_ray;
    const Echo* taken = nullptr;
    for (std::size_t pane = 0; i < echoes.size() && echoes[i].sub_ray == sub_ray; ++i, ++pane) {
      const double u = draws.pane[std::min(pane, draws.pane.size() - 1)];
      const bool answers = !noise.glass || u < echoes[i].hit_probability;
      if (taken == nullptr && answers) taken = &echoes[i];
    }
    const double fraction = taken != nullptr ? taken->fraction : echoes[i - 1].fraction;
    covered += fraction;
    const bool is_hit = taken != nullptr && std::isfinite(taken->range);
    if (!axis_done && covered >= 0.5) {
      result.axis_range = is_hit ? taken->range : kInfinity;
      axis_done = true;
    }
    ++sub_ray_count;
    CHECK(sub_ray_count <= kMostSubRays);
    if (!is_hit) continue;
    const double light = fraction * taken->reflectivity * taken->cos_incidence;
    const double range = std::max(1e-3, static_cast<double>(taken->range));
    result.list[result.count++] = {range, light, light / (range * range)};
  }
  std::sort(result.list.begin(), result.list.begin() + static_cast<std::ptrdiff_t>(result.count),
            [](const Surface& a, const Surface& b) { return a.range < b.range; });
  return result;
}

// Neighbouring surfaces merged into one, power-weighted.
Surface merged(std::span<const Surface> surfaces) {
  if (surfaces.size() == 1) return surfaces.front();
  Surface sum{0.0, 0.0, 0.0};
  for (const Surface& s : surfaces) {
    sum.range += s.power * s.range;
    sum.light += s.light;
    sum.power += s.power;
  }
  sum.range = sum.power > 0.0 ? sum.range / sum.power : surfaces.front().range;
  return sum;
}

// Draws one of the groups into which gaps of `merging` or more divide the surfaces.
Surface drawn_group(std::span<const Surface> surfaces, double merging, double u) {
  double total = 0.0;
  for (const Surface& s : surfaces) total += s.power;
  double below = u * total;
  std::size_t first = 0;
  for (std::size_t i = 1; i <= surfaces.size(); ++i) {
    if (i < surfaces.size() && surfaces[i].range - surfaces[i - 1].range < merging) continue;
    const Surface group = merged(surfaces.subspan(first, i - first));
    if (below < group.power || i == surfaces.size()) return group;
    below -= group.power;
    first = i;
  }
  return surfaces.back();
}

Surface seen_surface(const Surfaces& all, const LaserNoise& noise, double u) {
  const std::span<const Surface> list(all.list.data(), all.count);
  switch (noise.mixed_pixels) {
    case MixedPixels::weighted:
      return merged(list);
    case MixedPixels::either:
      return drawn_group(list, 0.02, u);  // one surface seen by several sub-rays stays one
    case MixedPixels::pulse:
      return drawn_group(list, std::max(0.02, noise.pulse_length), u);
    case MixedPixels::off:
      break;
  }
  Surface axis = merged(list);
  axis.range = all.axis_range;
  return axis;
}

bool is_too_dark(const Surface& surface, const LaserNoise& noise, double normal_draw) {
  if (noise.dark_range <= 0.0) return false;
  if (surface.light <= 0.0) return true;
  const double limit = noise.dark_range * std::sqrt(surface.light / kStandardRemission);
  return std::log(limit / surface.range) < noise.dark_softness * normal_draw;
}

double reading(std::span<const Echo> echoes, const LaserModel& model, const DeviceError& device,
               const Draws& draws) {
  const LaserNoise& noise = model.noise;
  if (draws.is_random < noise.random_probability) return draws.place * model.max_range;
  if (draws.miss < noise.miss_probability) return model.max_range;

  const Surfaces surfaces = surfaces_of(echoes, noise, draws);
  double range = kInfinity;
  if (surfaces.count > 0) {
    const Surface seen = seen_surface(surfaces, noise, draws.which_surface);
    if (std::isfinite(seen.range) && !is_too_dark(seen, noise, draws.darkness)) range = seen.range;
  }
  if (draws.is_short < noise.short_probability) {
    return draws.place * std::min(range, model.max_range);
  }
  if (!std::isfinite(range)) return model.max_range;
  return device.scale * range + noise.bias + range_sigma(noise, range) * draws.error + device.bias;
}

double quantised(double range, double step) {
  return step > 0.0 ? std::round(range / step) * step : range;
}

}  // namespace

DeviceError device_error(const LaserNoise& noise, int laser, const Rng& rng) {
  Rng device = rng.stream("laser device", static_cast<std::uint64_t>(laser));
  const double bias = noise.bias_spread * device.normal();
  return {bias, 1.0 + noise.scale_spread * device.normal()};
}

double range_sigma(const LaserNoise& noise, double range) {
  if (range <= noise.near_range) return noise.sigma_near;
  if (range >= noise.far_range) return noise.sigma_far;
  const double fraction = (range - noise.near_range) / (noise.far_range - noise.near_range);
  return noise.sigma_near + fraction * (noise.sigma_far - noise.sigma_near);
}

LaserScan with_noise(const IdealScan& ideal, const MountedLaser& laser, const Rng& rng) {
  const LaserModel& model = laser.model;
  CHECK(ideal.beam_count() == static_cast<std::size_t>(model.beams));
  LaserScan scan;
  scan.time = ideal.time;
  scan.laser = ideal.laser;
  scan.robot_from_laser = laser.robot_from_laser;
  scan.first_bearing = model.first_bearing;
  scan.bearing_step = model.bearing_step;
  scan.beam_period = model.beam_period();
  scan.max_range = model.max_range;
  scan.ranges.resize(ideal.beam_count());  // 0: failed

  const double smallest = std::max(model.noise.step, 1e-3);  // 0 would mean: the beam failed
  const DeviceError device = device_error(model.noise, ideal.laser, rng);
  const Rng sweep = rng.stream("laser", static_cast<std::uint64_t>(ideal.laser), ideal.sweep);
  for (std::size_t k = 0; k < scan.ranges.size(); ++k) {
    const Draws draws(sweep.stream("beam", k));
    const double read = reading(ideal.beam(k), model, device, draws);
    const bool is_lost = read >= model.max_range;  // which need not be a multiple of the step
    const double sent = is_lost ? model.max_range : quantised(read, model.noise.step);
    const double range = std::max(sent, smallest);
    if (range < model.min_range) continue;
    scan.ranges[k] = std::min(range, model.max_range);
  }
  return scan;
}

}  // namespace mapbed
