#include "bench/experiments/rfid_reads/phase_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/geometry/angle.h"
#include "core/statistics/moments.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

using Phasor = std::complex<double>;

Phasor direction_of(const Phasor& value) {
  const double size = std::abs(value);
  return size > 0.0 ? value / size : Phasor(0.0);
}

// A cell's mean without its way.
Phasor left_of(const PhaseCell& cell, const PhaseShifts& shifts, PhaseWay way, int turns) {
  if (way == PhaseWay::nothing) return cell.reading.mean;
  return cell.reading.mean * std::polar(1.0, -expected_phase(cell.reading, shifts.of(cell), turns));
}

// Each place counts once in its channel, however many reads there are.
std::map<int, Phasor> sums_of_channels(const std::vector<PhaseCell>& cells,
                                       const std::vector<Phasor>& left) {
  std::map<int, Phasor> sums;
  for (std::size_t i = 0; i < cells.size(); ++i) sums[cells[i].reading.channel] += left[i];
  return sums;
}

double cosine(const Phasor& a, const Phasor& b) {
  return (a * std::conj(b)).real();
}

// Of reads, with their channel's mean; `without_itself`: of the channel's other places.
double agreement_of(const std::vector<PhaseCell>& cells, const std::vector<Phasor>& left,
                    bool without_itself) {
  const std::map<int, Phasor> sums = sums_of_channels(cells, left);
  double sum = 0.0, reads = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Phasor channel = sums.at(cells[i].reading.channel);
    if (without_itself) channel -= left[i];
    sum += cells[i].reading.reads * cosine(left[i], direction_of(channel));
    reads += cells[i].reading.reads;
  }
  return sum / reads;
}

double median_between_folds(const std::vector<PhaseShifts>& found, std::size_t tags) {
  std::vector<double> distances;
  for (std::size_t a = 0; a < found.size(); ++a) {
    for (std::size_t b = a + 1; b < found.size(); ++b) {
      for (std::size_t tag = 0; tag < tags; ++tag) {
        distances.push_back((found[a].tags[tag] - found[b].tags[tag]).norm());
      }
    }
  }
  return median_of(std::move(distances));
}

double log_uniform() {
  return -std::log(2.0 * kPi);
}

}  // namespace

PhaseScore held_out_score(const std::vector<PhaseCell>& cells, int antennas, int tags,
                          const std::vector<int>& folds, const PhaseShiftOptions& options,
                          PhaseWay way, int turns) {
  const int fold_count = 1 + *std::max_element(folds.begin(), folds.end());
  PhaseScore score;
  Moments training, kappas, shifts_found;
  std::vector<PhaseShifts> found;
  double gain = 0.0, agreement = 0.0, reads = 0.0;
  for (int fold = 0; fold < fold_count; ++fold) {
    std::vector<PhaseCell> learned, held_out;
    for (const PhaseCell& cell : cells) {
      const bool is_held_out = folds[static_cast<std::size_t>(cell.place)] == fold;
      (is_held_out ? held_out : learned).push_back(cell);
    }
    const PhaseShifts shifts = fitted_shifts(learned, antennas, tags, options, turns);
    std::vector<Phasor> left;
    for (const PhaseCell& cell : learned) left.push_back(left_of(cell, shifts, way, turns));
    training.add(agreement_of(learned, left, false));
    const double kappa = kappa_of(agreement_of(learned, left, true));
    kappas.add(kappa);
    const std::map<int, Phasor> channels = sums_of_channels(learned, left);
    for (const PhaseCell& cell : held_out) {
      reads += cell.reading.reads;
      const auto channel = channels.find(cell.reading.channel);
      if (channel == channels.end()) continue;  // nothing is known of it: uniform
      const double mean_cosine =
          cosine(left_of(cell, shifts, way, turns), direction_of(channel->second));
      agreement += cell.reading.reads * mean_cosine;
      gain += cell.reading.reads * (log_von_mises(mean_cosine, kappa) - log_uniform());
    }
    for (const Eigen::Vector3d& shift : shifts.tags) shifts_found.add(shift.norm());
    found.push_back(shifts);
  }
  score.gain = gain / reads;
  score.agreement = agreement / reads;
  score.training_agreement = training.mean();
  score.kappa = kappas.mean();
  score.tag_shift = shifts_found.mean();
  score.repeated = options.tags ? median_between_folds(found, static_cast<std::size_t>(tags))
                                : std::numeric_limits<double>::quiet_NaN();
  return score;
}

double neighbours_agree(const std::vector<PhaseCell>& cells, PhaseWay way, int turns) {
  constexpr double kNeighbours = 1.01;  // [m]
  std::map<int, std::vector<std::pair<Eigen::Vector3d, Phasor>>> by_channel;
  for (const PhaseCell& cell : cells) {
    const Phasor left =
        way == PhaseWay::nothing
            ? cell.reading.mean
            : cell.reading.mean *
                  std::polar(1.0, -expected_phase(cell.reading, Eigen::Vector3d::Zero(), turns));
    by_channel[cell.reading.channel].emplace_back(cell.reading.place, direction_of(left));
  }
  Moments cosines;
  for (const auto& [channel, places] : by_channel) {
    for (std::size_t a = 0; a < places.size(); ++a) {
      for (std::size_t b = a + 1; b < places.size(); ++b) {
        if ((places[a].first - places[b].first).norm() > kNeighbours) continue;
        cosines.add(cosine(places[a].second, places[b].second));
      }
    }
  }
  return cosines.mean();
}

double ceiling_of(const std::vector<PhaseCell>& cells) {
  double sum = 0.0, reads = 0.0;
  for (const PhaseCell& cell : cells) {
    sum += cell.reading.reads * std::abs(cell.reading.mean);
    reads += cell.reading.reads;
  }
  const double mean = sum / reads;
  return log_von_mises(mean, kappa_of(mean)) - log_uniform();
}

}  // namespace mapbed
