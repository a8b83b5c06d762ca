#include "sim/validation/laser_specification.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kOneSurface = 0.9;  // cosine between normals of one surface
constexpr double kTails = 7.0;       // standard deviations; 3e-12 lies beyond

double normal_below(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

// A way in which the beam can come back.
struct Answer {
  double probability = 1.0;
  double range = 0.0;  // [m]
  double light = 0.0;  // fraction * reflectivity * cos(incidence)
};

struct Lit {  // a surface under the spot
  double range, light;
};

// The sub-ray's place in the spot, -1 to 1, and its fraction of the light.
struct SubRay {
  double offset, fraction;
};

std::vector<SubRay> sub_rays_of(int count) {
  std::vector<SubRay> rays;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double offset = (2.0 * i + 1.0) / count - 1.0;
    rays.push_back({offset, std::sqrt(1.0 - offset * offset)});
    sum += rays.back().fraction;
  }
  for (SubRay& ray : rays) ray.fraction /= sum;
  return rays;
}

bool is_one_surface(const Meeting& a, const Meeting& b) {
  return a.surface == b.surface && a.normal.dot(b.normal) > kOneSurface;
}

double reflectivity(const Meeting& met, const World& world) {
  const auto material = static_cast<std::size_t>(material_index(world, met.material));
  return world.materials[material].reflectivity;
}

// Echoes nearer than `melting` are one, at the mean by received power light / range^2; which of
// those is read is drawn by that power too.
std::vector<Answer> mixed(std::vector<Lit> lit, double melting) {
  std::sort(lit.begin(), lit.end(), [](const Lit& a, const Lit& b) { return a.range < b.range; });
  std::vector<Answer> groups;
  double all = 0.0;
  double before = -std::numeric_limits<double>::infinity();
  for (const Lit& l : lit) {
    const double power = l.light / (l.range * l.range);
    all += power;
    if (l.range - before >= melting) groups.push_back({0.0, 0.0, 0.0});
    Answer& group = groups.back();
    group.range = (group.range * group.probability + l.range * power) / (group.probability + power);
    group.probability += power;
    group.light += l.light;
    before = l.range;
  }
  for (Answer& group : groups) group.probability /= all;
  return groups;
}

double melting_of(const LaserNoise& noise) {
  constexpr double kSame = 0.02;  // [m] one surface that several sub-rays see stays one
  if (noise.mixed_pixels == MixedPixels::weighted) return std::numeric_limits<double>::infinity();
  if (noise.mixed_pixels == MixedPixels::either) return kSame;
  return std::max(kSame, noise.pulse_length);
}

class Specification {
 public:
  Specification(const LaserTarget& target, const LaserModel& laser, const SpotModel& spot)
      : target_(target),
        laser_(laser),
        spot_(spot),
        sub_rays_(sub_rays_of(spot.sub_rays)),
        fractions_(reading_index(laser.max_range, laser) + 1, 0.0),
        cell_fractions_(fractions_.size(), 0.0) {
    CHECK(laser.noise.step > 0.0 && laser.noise.mixed_pixels != MixedPixels::off);
  }

  // The laser at (0, y) in `weight` of all cases.
  void add_place(double y, double weight) {
    for (const Answer& answer : answers_at(y)) add(answer, weight * answer.probability);
  }

  ReadingFractions result() {
    // What is uniform up to a range has the same fraction of every cell before it.
    double sum = 0.0;
    for (std::size_t k = fractions_.size(); k-- > 0;) {
      sum += cell_fractions_[k];
      fractions_[std::max<std::size_t>(k, 1)] += k == 0 ? sum / 2.0 : sum;  // 0 is not read
    }
    return std::move(fractions_);
  }

 private:
  std::vector<Answer> answers_at(double y) const {
    std::vector<std::vector<Meeting>> met;
    for (const SubRay& ray : sub_rays_) {
      const double bearing = ray.offset * laser_.divergence / 2.0;
      met.push_back(meetings(target_, {0.0, y + ray.offset * laser_.aperture / 2.0},
                             {std::cos(bearing), std::sin(bearing)}));
    }
    const auto& axis = met[met.size() / 2];
    CHECK(!axis.empty() && !met.front().empty() && !met.back().empty());
    const bool one_surface =
        is_one_surface(axis[0], met.front()[0]) && is_one_surface(axis[0], met.back()[0]);
    if (axis[0].material == "glass") return answers_of_glass(axis);
    std::vector<Lit> lit;
    for (std::size_t i = 0; i < met.size(); ++i) {
      if (one_surface && spot_.axis_alone && i != met.size() / 2) continue;
      const double fraction = one_surface && spot_.axis_alone ? 1.0 : sub_rays_[i].fraction;
      const Meeting& m = met[i].front();
      lit.push_back({m.range, fraction * reflectivity(m, world_) * m.cos_incidence});
    }
    return mixed(std::move(lit), melting_of(laser_.noise));
  }

  // The pane as a mirror, or what stands behind it.
  std::vector<Answer> answers_of_glass(const std::vector<Meeting>& axis) const {
    CHECK(axis.size() > 1);
    const Material& glass =
        world_.materials[static_cast<std::size_t>(material_index(world_, "glass"))];
    const double p = hit_probability(glass, std::acos(std::min(1.0, axis[0].cos_incidence)));
    const double behind = reflectivity(axis[1], world_) * axis[1].cos_incidence;
    return {{p, axis[0].range, 1.0}, {1.0 - p, axis[1].range, behind}};
  }

  void add(const Answer& answer, double weight) {
    const LaserNoise& noise = laser_.noise;
    const double limit = noise.dark_range * std::sqrt(answer.light / 0.1);
    const double seen = noise.dark_range > 0.0
                            ? normal_below(std::log(limit / answer.range) / noise.dark_softness)
                            : 1.0;
    const double random = weight * noise.random_probability;
    const double missed = (weight - random) * noise.miss_probability;
    const double left = weight - random - missed;
    const double tiny = left * noise.short_probability;
    const double plain = left - tiny;

    add_uniform(laser_.max_range, random + tiny * (1.0 - seen));
    add_uniform(std::min(answer.range, laser_.max_range), tiny * seen);
    fractions_.back() += missed + plain * (1.0 - seen);
    add_normal(answer.range, plain * seen);
  }

  void add_uniform(double end, double weight) {
    const double step = laser_.noise.step;
    const auto last = static_cast<std::size_t>(end / step + 0.5);  // the cell in which it ends
    if (last == 0) {
      fractions_[1] += weight;
      return;
    }
    // Cell k reaches from (k - 1/2) to (k + 1/2) steps, cell 0 from 0.
    const std::size_t full = std::min(last, fractions_.size()) - 1;
    cell_fractions_[full] += weight * step / end;
    const std::size_t at = std::min(last, fractions_.size() - 1);
    fractions_[at] += weight * (end - (static_cast<double>(last) - 0.5) * step) / end;
  }

  void add_normal(double range, double weight) {
    const LaserNoise& noise = laser_.noise;
    double grown = (range - noise.near_range) / (noise.far_range - noise.near_range);
    if (noise.far_range <= noise.near_range) grown = range > noise.near_range ? 1.0 : 0.0;
    grown = std::clamp(grown, 0.0, 1.0);
    const double sigma = noise.sigma_near + grown * (noise.sigma_far - noise.sigma_near);
    const double mean = range + noise.bias;
    const auto cell = [&](double r) { return std::lround(r / noise.step); };
    double below = 0.0;
    for (long k = cell(mean - kTails * sigma); k <= cell(mean + kTails * sigma); ++k) {
      const double border = (static_cast<double>(k) + 0.5) * noise.step;
      const double now = sigma > 0.0 ? normal_below((border - mean) / sigma) : 1.0;
      fractions_[reading_index(static_cast<double>(k) * noise.step, laser_)] +=
          weight * (now - below);
      below = now;
    }
  }

  const LaserTarget& target_;
  const LaserModel& laser_;
  SpotModel spot_;
  World world_;  // for its materials
  std::vector<SubRay> sub_rays_;
  ReadingFractions fractions_;
  std::vector<double> cell_fractions_;  // [k]: fraction of every cell up to k, the first one half
};

}  // namespace

SpotModel spot_model_of(const LaserModel& laser) {
  const bool is_line = laser.aperture <= 0.0 && laser.divergence <= 0.0;
  return {.sub_rays = is_line ? 1 : laser.sub_rays | 1};
}

ReadingFractions specified_fractions(const LaserTarget& target, const LaserModel& laser,
                                     const SpotModel& spot, int places) {
  Specification specification(target, laser, spot);
  const int count = target.half_width > 0.0 ? places : 1;
  for (int i = 0; i < count; ++i) {
    specification.add_place(((2.0 * i + 1.0) / count - 1.0) * target.half_width, 1.0 / count);
  }
  return specification.result();
}

std::size_t reading_index(double reading, const LaserModel& laser) {
  const auto last = static_cast<long>(std::lround(laser.max_range / laser.noise.step));
  return static_cast<std::size_t>(std::clamp(std::lround(reading / laser.noise.step), 1L, last));
}

}  // namespace mapbed
