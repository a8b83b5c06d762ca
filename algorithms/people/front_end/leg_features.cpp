#include "algorithms/people/front_end/leg_features.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mapbed {
namespace {

constexpr std::size_t kMaxFailed = 3;  // beams in a row, beyond which nothing is known
constexpr double kUnknownSide = 0.6;   // quality where a side is out of view, or beams failed there
constexpr double kHiddenSide = 0.5;    // or hidden
constexpr double kFewBeams = 0.8;      // or it is one beam alone
constexpr double kTwoAsOne = 0.7;      // or it is wider than a leg
constexpr double kSparse =
    0.2;  // [m] of beams: what is beside something nearer may be a wall's last
constexpr double kOffTheLine = 0.25;     // [m] from a wall seen aslant, at least
constexpr double kQuarterPi = 0.785398;  // mean depth of a disc's hits behind its front: 1 - pi / 4

// Hits that follow each other, by their place in the eye's order.
struct Segment {
  std::size_t first = 0;
  std::size_t last = 0;
};

enum class Beside { farther, nearer, unknown };

// One laser's readings in the order of bearings.
class Profile {
 public:
  Profile(const LaserScan& scan, const ScanView::Eye& eye) : scan_(scan), eye_(eye) {}

  std::size_t size() const { return eye_.size(); }
  double range(std::size_t i) const { return scan_.ranges[eye_.beam(i)]; }
  bool has_reading(std::size_t i) const { return range(i) > 0.0; }
  bool is_hit(std::size_t i) const { return scan_.is_hit(eye_.beam(i)); }
  double bearing(std::size_t i) const { return eye_.bearings[i]; }

  // The next reading to the left (+1) or right (-1).
  std::optional<std::size_t> next(std::size_t i, int side) const {
    for (std::size_t k = 1; k <= kMaxFailed + 1; ++k) {
      if (side < 0 ? i < k : i + k >= size()) return {};
      const std::size_t j = side < 0 ? i - k : i + k;
      if (has_reading(j)) return j;
    }
    return {};
  }

  std::vector<Segment> segments(double jump) const {
    std::vector<Segment> result;
    for (std::size_t i = 0; i < size(); ++i) {
      if (!is_hit(i)) continue;
      const std::optional<std::size_t> before = next(i, -1);
      const bool goes_on = !result.empty() && before && *before == result.back().last &&
                           std::abs(range(i) - range(*before)) <= jump;
      if (goes_on) {
        result.back().last = i;
      } else {
        result.push_back({i, i});
      }
    }
    return result;
  }

 private:
  const LaserScan& scan_;
  const ScanView::Eye& eye_;
};

Beside beside(const Profile& profile, std::size_t edge, int side,
              const LegFeatureOptions& options) {
  const std::optional<std::size_t> next = profile.next(edge, side);
  if (!next) return Beside::unknown;
  const double by = profile.range(*next) - profile.range(edge);
  if (!profile.is_hit(*next) || by >= options.in_front) return Beside::farther;
  return by < 0.0 ? Beside::nearer : Beside::unknown;
}

// Whether it lies where a wall would that leads through what is beside it: 1 / r is linear there.
bool is_on_a_line(const Profile& profile, const Segment& segment) {
  const std::optional<std::size_t> a = profile.next(segment.first, -1);
  const std::optional<std::size_t> b = profile.next(segment.last, +1);
  if (!a || !b || !profile.is_hit(*a) || !profile.is_hit(*b)) return false;
  const std::size_t middle = (segment.first + segment.last) / 2;
  const double along =
      (profile.bearing(middle) - profile.bearing(*a)) / (profile.bearing(*b) - profile.bearing(*a));
  const double inverse = (1.0 - along) / profile.range(*a) + along / profile.range(*b);
  return std::abs(profile.range(middle) - 1.0 / inverse) < kOffTheLine;
}

// How much what is beside it looks as if a leg stood there; 0: not at all.
double quality_beside(const Profile& profile, const Segment& segment, double spacing,
                      const LegFeatureOptions& options) {
  const Beside right = beside(profile, segment.first, -1, options);
  const Beside left = beside(profile, segment.last, +1, options);
  if (right == Beside::nearer && left == Beside::nearer) return 0.0;
  if (right == Beside::nearer || left == Beside::nearer) {
    if (spacing > kSparse || is_on_a_line(profile, segment)) return 0.0;
  }
  const auto of_side = [](Beside side) {
    if (side == Beside::farther) return 1.0;
    return side == Beside::nearer ? kHiddenSide : kUnknownSide;
  };
  return of_side(right) * of_side(left);
}

std::optional<LegFeature> feature_of(const Profile& profile, const ScanView::Eye& eye,
                                     const Segment& segment, const LegFeatureOptions& options) {
  double mean = 0.0;
  for (std::size_t i = segment.first; i <= segment.last; ++i) {
    if (profile.is_hit(i)) mean += profile.range(i);
  }
  std::size_t hits = 0;
  for (std::size_t i = segment.first; i <= segment.last; ++i) hits += profile.is_hit(i) ? 1 : 0;
  mean /= static_cast<double>(hits);
  const double angle = profile.bearing(segment.last) - profile.bearing(segment.first);
  const double across = 2.0 * mean * std::sin(std::min(angle, 3.0) / 2.0);
  const double along = profile.range(segment.last) - profile.range(segment.first);
  LegFeature feature;
  feature.width = std::hypot(across, along);
  feature.spacing = mean * eye.step;
  const bool fits = feature.width <= options.widest_pair &&
                    feature.width + 2.0 * feature.spacing >= options.least_width &&
                    mean <= options.max_range && feature.spacing <= options.widest_spacing;
  if (!fits) return {};
  feature.quality = quality_beside(profile, segment, feature.spacing, options);
  if (feature.quality <= 0.0) return {};
  feature.is_wide = feature.width > options.widest_leg;
  if (feature.is_wide) feature.quality *= kTwoAsOne;
  if (hits == 1) feature.quality *= kFewBeams;
  feature.range = mean + kQuarterPi * options.radius;
  const double bearing = 0.5 * (profile.bearing(segment.first) + profile.bearing(segment.last));
  feature.position =
      eye.origin + feature.range * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
  feature.first = std::min(eye.beam(segment.first), eye.beam(segment.last));
  feature.last = std::max(eye.beam(segment.first), eye.beam(segment.last));
  return feature;
}

}  // namespace

std::vector<LegFeature> leg_features(const ScanView& view, const LegFeatureOptions& options) {
  std::vector<LegFeature> features;
  for (const ScanView::Eye& eye : view.eyes()) {
    const Profile profile(view.scan(), eye);
    for (const Segment& segment : profile.segments(options.jump)) {
      if (auto feature = feature_of(profile, eye, segment, options)) features.push_back(*feature);
    }
  }
  return features;
}

}  // namespace mapbed
