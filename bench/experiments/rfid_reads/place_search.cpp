#include "bench/experiments/rfid_reads/place_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace mapbed {

PlaceSearch::PlaceSearch(const StrengthMap& map, double sigma, const Eigen::AlignedBox3d& box,
                         double step, int antennas)
    : tags_(map.tags.size()), sigma_(sigma) {
  const Eigen::Vector3i steps = (box.sizes() / step).array().round().cast<int>();
  for (int x = 0; x <= steps.x(); ++x) {
    for (int y = 0; y <= steps.y(); ++y) {
      for (int z = 0; z <= steps.z(); ++z) {
        lattice_.push_back(box.min() + step * Eigen::Vector3d(x, y, z));
      }
    }
  }
  for (int antenna = 0; antenna < antennas; ++antenna) {
    std::vector<double> of_place;
    for (const Eigen::Vector3d& place : lattice_) of_place.push_back(map.of_place(antenna, place));
    for (const double of_tag : map.tags) {
      std::vector<double>& means = means_.emplace_back();
      means.reserve(lattice_.size());
      for (const double strength : of_place) {
        means.push_back(mean_of_read(map.threshold, strength + of_tag));
      }
    }
  }
}

Eigen::Vector3d PlaceSearch::place_of(std::span<const StrengthReading> readings) const {
  constexpr double kWidth = 2.0;  // [sigma] Huber's, beyond which a reading pulls no harder
  std::vector<double> cost(lattice_.size(), 0.0);
  for (const StrengthReading& reading : readings) {
    const std::vector<double>& means = means_[static_cast<std::size_t>(reading.antenna) * tags_ +
                                              static_cast<std::size_t>(reading.tag)];
    for (std::size_t i = 0; i < cost.size(); ++i) {
      const double off = std::abs(reading.strength - means[i]) / sigma_;
      cost[i] += off <= kWidth ? 0.5 * off * off : kWidth * (off - 0.5 * kWidth);
    }
  }
  const double least = *std::min_element(cost.begin(), cost.end());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0.0;
  for (std::size_t i = 0; i < cost.size(); ++i) {
    const double weight = std::exp(least - cost[i]);
    weights += weight;
    sum += weight * lattice_[i];
  }
  return sum / weights;
}

Eigen::Vector3d most_alike(std::span<const StrengthReading> readings,
                           std::span<const StrengthReading> measured, double missing) {
  using Key = std::pair<int, int>;
  std::map<Key, double> wanted;
  for (const StrengthReading& reading : readings) {
    wanted[{reading.antenna, reading.tag}] = reading.strength;
  }
  struct Likeness {
    Eigen::Vector3d place;
    double squares = 0.0;
    std::size_t common = 0, others = 0;
  };
  std::map<std::vector<double>, Likeness> places;
  // Tags that are not asked for say nothing.
  const auto is_asked = [&](int tag) {
    return std::any_of(readings.begin(), readings.end(),
                       [tag](const StrengthReading& reading) { return reading.tag == tag; });
  };
  for (const StrengthReading& reading : measured) {
    Likeness& place = places[{reading.place.begin(), reading.place.end()}];
    place.place = reading.place;
    const auto found = wanted.find({reading.antenna, reading.tag});
    if (found != wanted.end()) {
      place.squares += (reading.strength - found->second) * (reading.strength - found->second);
      ++place.common;
    } else if (is_asked(reading.tag)) {
      ++place.others;
    }
  }
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [key, place] : places) {
    const std::size_t lacking = wanted.size() - place.common + place.others;
    const double all = static_cast<double>(place.common + lacking);
    const double value = (place.squares + missing * missing * static_cast<double>(lacking)) / all;
    if (value >= least) continue;
    least = value;
    best = place.place;
  }
  return best;
}

}  // namespace mapbed
