#include "bench/experiments/rfid_reads/strength_score.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "bench/experiments/rfid_reads/place_search.h"
#include "core/geometry/angle.h"
#include "core/statistics/moments.h"

namespace mapbed {
namespace {

struct Parts {
  std::vector<StrengthReading> training;
  std::vector<StrengthCell> rest;
};

Parts divided(const std::vector<StrengthCell>& cells, const std::function<bool(int)>& is_training,
              const std::function<bool(int)>& is_rest) {
  Parts parts;
  for (const StrengthCell& cell : cells) {
    if (is_training(cell.place)) parts.training.push_back(cell.reading);
    if (is_rest(cell.place)) parts.rest.push_back(cell);
  }
  return parts;
}

double mean_at(const StrengthMap& map, const StrengthCell& cell) {
  return map.mean(cell.reading.antenna, cell.reading.tag, cell.reading.place);
}

struct Sigmas {
  double of_reads = 0.0;  // [dB]
  double of_cells = 0.0;  // [dB]
};

Sigmas sigmas_of(const StrengthMap& map, const std::vector<StrengthCell>& cells) {
  double squares = 0.0, reads = 0.0;
  Moments of_cells;
  for (const StrengthCell& cell : cells) {
    const double mean = mean_at(map, cell);
    squares += cell.squares_about(mean);
    reads += cell.reads;
    of_cells.add((cell.reading.strength - mean) * (cell.reading.strength - mean));
  }
  return {std::sqrt(squares / reads), std::sqrt(of_cells.mean())};
}

Eigen::AlignedBox3d box_of(const std::vector<Eigen::Vector3d>& places, double margin) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& place : places) box.extend(place);
  box.extend(box.max() + Eigen::Vector3d::Constant(margin));
  box.extend(box.min() - Eigen::Vector3d::Constant(margin));
  return box;
}

}  // namespace

StrengthScore held_out_score(const std::vector<StrengthCell>& cells, const PlacedReads& reads,
                             const std::vector<int>& folds, const StrengthMapOptions& options,
                             const PlaceSearchOptions& search_options) {
  const int tags = static_cast<int>(reads.tags.size());
  const Eigen::AlignedBox3d box = box_of(reads.places, search_options.margin);
  const auto fold_of = [&](int place) { return folds[static_cast<std::size_t>(place)]; };
  const int fold_count = 1 + *std::max_element(folds.begin(), folds.end());
  StrengthScore score;
  double log_likelihood = 0.0, all_reads = 0.0;
  Moments squares, baseline_squares;
  for (int fold = 0; fold < fold_count; ++fold) {
    const int next = (fold + 1) % fold_count;
    const Parts inner = divided(
        cells, [&](int place) { return fold_of(place) != fold && fold_of(place) != next; },
        [&](int place) { return fold_of(place) == next; });
    const Parts parts = divided(
        cells, [&](int place) { return fold_of(place) != fold; },
        [&](int place) { return fold_of(place) == fold; });
    const Sigmas sigmas =
        sigmas_of(strength_map(inner.training, reads.antennas, tags, options), inner.rest);
    const StrengthMap map = strength_map(parts.training, reads.antennas, tags, options);
    const StrengthMap baseline = strength_map(parts.training, reads.antennas, tags,
                                              {.predictor = StrengthPredictor::antenna_and_tag});
    const PlaceSearch search(map, sigmas.of_cells, box, search_options.step, reads.antennas);
    const auto found = [&](const std::vector<StrengthReading>& readings) {
      return options.predictor == StrengthPredictor::nearest_place
                 ? most_alike(readings, parts.training)
                 : search.place_of(readings);
    };
    std::map<int, std::vector<StrengthReading>> of_block;
    std::map<std::pair<int, int>, std::vector<StrengthReading>> of_tag;
    for (const StrengthCell& cell : parts.rest) {
      const double mean = mean_at(map, cell);
      score.predictions.push_back({cell, mean});
      const double variance = sigmas.of_reads * sigmas.of_reads;
      log_likelihood -= 0.5 * cell.squares_about(mean) / variance +
                        0.5 * cell.reads * std::log(2.0 * kPi * variance);
      all_reads += cell.reads;
      squares.add(std::pow(cell.reading.strength - mean, 2));
      baseline_squares.add(std::pow(cell.reading.strength - mean_at(baseline, cell), 2));
      of_block[cell.place].push_back(cell.reading);
      of_tag[{cell.place, cell.reading.tag}].push_back(cell.reading);
    }
    for (const auto& [place, readings] : of_block) {
      score.blocks.push_back({readings.front().place, found(readings)});
    }
    for (const auto& [key, readings] : of_tag) {
      score.tags.push_back({readings.front().place, found(readings)});
    }
  }
  score.log_likelihood = log_likelihood / all_reads;
  score.squares = squares.mean();
  score.baseline_squares = baseline_squares.mean();
  return score;
}

}  // namespace mapbed
