#include "bench/experiments/rfid_reads/strength_map.h"

#include <cmath>
#include <map>
#include <utility>

#include "core/statistics/moments.h"

namespace mapbed {
namespace {

// Of an antenna at a place, in the mean of the tags that it read there, each less its own.
struct MeasuredPlace {
  Eigen::Vector3d place;
  double strength = 0.0;  // [dBm]
};

std::vector<double> means_of_antennas(std::span<const StrengthReading> readings, int antennas) {
  std::vector<Moments> moments(static_cast<std::size_t>(antennas));
  for (const StrengthReading& reading : readings) {
    moments[static_cast<std::size_t>(reading.antenna)].add(reading.strength);
  }
  std::vector<double> means;
  for (const Moments& of_antenna : moments) means.push_back(of_antenna.mean());
  return means;
}

// What a tag is stronger than its antennas' means.
std::vector<double> means_of_tags(std::span<const StrengthReading> readings,
                                  const std::vector<double>& antennas, int tags) {
  std::vector<Moments> moments(static_cast<std::size_t>(tags));
  for (const StrengthReading& reading : readings) {
    moments[static_cast<std::size_t>(reading.tag)].add(
        reading.strength - antennas[static_cast<std::size_t>(reading.antenna)]);
  }
  std::vector<double> means;
  for (const Moments& of_tag : moments) means.push_back(of_tag.count() > 0 ? of_tag.mean() : 0.0);
  return means;
}

std::vector<std::vector<MeasuredPlace>> measured_places(std::span<const StrengthReading> readings,
                                                        const std::vector<double>& tags,
                                                        std::size_t antennas) {
  std::vector<std::map<std::vector<double>, Moments>> sums(antennas);
  for (const StrengthReading& reading : readings) {
    const std::vector<double> key(reading.place.begin(), reading.place.end());
    sums[static_cast<std::size_t>(reading.antenna)][key].add(
        reading.strength - tags[static_cast<std::size_t>(reading.tag)]);
  }
  std::vector<std::vector<MeasuredPlace>> places(antennas);
  for (std::size_t antenna = 0; antenna < antennas; ++antenna) {
    for (const auto& [key, moments] : sums[antenna]) {
      places[antenna].push_back({{key[0], key[1], key[2]}, moments.mean()});
    }
  }
  return places;
}

double at_nearest(const std::vector<MeasuredPlace>& places, const Eigen::Vector3d& at) {
  const MeasuredPlace* nearest = &places.front();
  for (const MeasuredPlace& place : places) {
    if ((place.place - at).squaredNorm() < (nearest->place - at).squaredNorm()) nearest = &place;
  }
  return nearest->strength;
}

// Where nothing is near, the antenna's mean, which weighs as a place 3 sigma away.
double by_distance(const std::vector<MeasuredPlace>& places, double mean, double sigma,
                   const Eigen::Vector3d& at) {
  double weights = std::exp(-4.5), sum = weights * mean;
  for (const MeasuredPlace& place : places) {
    const double weight = std::exp(-0.5 * (place.place - at).squaredNorm() / (sigma * sigma));
    weights += weight;
    sum += weight * place.strength;
  }
  return sum / weights;
}

}  // namespace

StrengthMap strength_map(std::span<const StrengthReading> readings, int antennas, int tags,
                         const StrengthMapOptions& options) {
  StrengthMap map;
  if (options.predictor == StrengthPredictor::link_budget) {
    map.model = fitted_strength(readings, antennas, tags, options.fit);
    map.tags = map.model.tags;
    map.threshold = map.model.threshold;
    map.of_place = [model = map.model](int antenna, const Eigen::Vector3d& place) {
      return link_budget(model, antenna, place);
    };
    return map;
  }
  auto means = means_of_antennas(readings, antennas);
  map.tags.assign(static_cast<std::size_t>(tags), 0.0);
  if (options.predictor != StrengthPredictor::antenna) {
    map.tags = means_of_tags(readings, means, tags);
  }
  if (options.predictor == StrengthPredictor::antenna ||
      options.predictor == StrengthPredictor::antenna_and_tag) {
    map.of_place = [means = std::move(means)](int antenna, const Eigen::Vector3d&) {
      return means[static_cast<std::size_t>(antenna)];
    };
    return map;
  }
  auto places = measured_places(readings, map.tags, means.size());
  if (options.predictor == StrengthPredictor::nearest_place) {
    map.of_place = [places = std::move(places)](int antenna, const Eigen::Vector3d& at) {
      return at_nearest(places[static_cast<std::size_t>(antenna)], at);
    };
  } else {
    map.of_place = [places = std::move(places), means = std::move(means), near = options.near](
                       int antenna, const Eigen::Vector3d& at) {
      const auto index = static_cast<std::size_t>(antenna);
      return by_distance(places[index], means[index], near, at);
    };
  }
  return map;
}

}  // namespace mapbed
