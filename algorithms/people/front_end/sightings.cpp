#include "algorithms/people/front_end/sightings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/check.h"

namespace mapbed {
namespace {

bool may_be_a_pair(const LegFeature& a, const LegFeature& b, SeenBefore a_before,
                   SeenBefore b_before, double widest) {
  const bool one_is_of_the_place = (a_before == SeenBefore::same) != (b_before == SeenBefore::same);
  return !one_is_of_the_place && !a.is_wide && !b.is_wide &&
         (a.position - b.position).norm() <= widest;
}

double sigma_at(double sigma, const LegFeature& feature) {
  return std::hypot(sigma, feature.spacing / std::sqrt(12.0));
}

Sighting single(const LegFeature& feature, SeenBefore before, const PlaceBefore& place,
                const Pose2& local_from_robot, const SightingOptions& options) {
  const double sigma = feature.is_wide ? options.pair_sigma : options.single_sigma;
  return {local_from_robot * feature.position,
          sigma_at(sigma, feature),
          feature.quality,
          before,
          place,
          {}};
}

// Both legs stood there already, or one of them, and the other's place was not seen to be free.
PlaceBefore both(const PlaceBefore& a, const PlaceBefore& b) {
  const ScanBits free = a.free | b.free;
  const ScanBits same = (a.same & b.same) | ((a.same | b.same) & ~free);
  return {free & ~same, same, a.rides_along && b.rides_along};
}

}  // namespace

std::vector<Sighting> sightings_of(const std::vector<LegFeature>& features,
                                   const std::vector<PlaceBefore>& places, const PastScans& past,
                                   const Pose2& local_from_robot, const SightingOptions& options) {
  CHECK(features.size() == places.size());
  std::vector<SeenBefore> before;
  for (const PlaceBefore& place : places) before.push_back(past.verdict(place));
  const auto nearest_to = [&](std::size_t i) {
    std::optional<std::size_t> nearest;
    double least = HUGE_VAL;
    for (std::size_t j = 0; j < features.size(); ++j) {
      const double away = (features[i].position - features[j].position).norm();
      if (j == i || away >= least) continue;
      if (!may_be_a_pair(features[i], features[j], before[i], before[j], options.widest_stride)) {
        continue;
      }
      nearest = j;
      least = away;
    }
    return nearest;
  };
  std::vector<std::optional<std::size_t>> nearest;
  for (std::size_t i = 0; i < features.size(); ++i) nearest.push_back(nearest_to(i));
  std::vector<Sighting> sightings;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const bool is_pair = nearest[i] && nearest[*nearest[i]] == i;
    if (is_pair && *nearest[i] < i) continue;  // it stands there already
    Sighting sighting = single(features[i], before[i], places[i], local_from_robot, options);
    sighting.features = {i};
    if (is_pair) {
      const LegFeature& other = features[*nearest[i]];
      sighting.position =
          local_from_robot * Eigen::Vector2d(0.5 * (features[i].position + other.position));
      sighting.sigma = sigma_at(options.pair_sigma, other);
      sighting.quality = std::max(sighting.quality, other.quality);
      sighting.place = both(places[i], places[*nearest[i]]);
      sighting.before = past.verdict(sighting.place);
      sighting.features.push_back(*nearest[i]);
    }
    sightings.push_back(std::move(sighting));
  }
  return sightings;
}

}  // namespace mapbed
