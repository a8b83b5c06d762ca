#include "algorithms/rfid/calibration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <Eigen/Dense>

#include "algorithms/rfid/simplex_search.h"
#include "core/statistics/distributions.h"
#include "core/statistics/moments.h"

namespace mapbed {
namespace {

constexpr double kSurest = 1e-6;  // no model is surer than this where its rounds are few

struct Counts {
  double rounds = 0.0;
  double detections = 0.0;

  Counts operator-(const Counts& o) const { return {rounds - o.rounds, detections - o.detections}; }
  Counts operator+(const Counts& o) const { return {rounds + o.rounds, detections + o.detections}; }
  double rate() const { return rounds > 0.0 ? detections / rounds : 0.0; }
  // Of greatest likelihood by one rate of their own.
  double log_likelihood() const {
    const double p = std::clamp(rate(), kSurest, 1.0 - kSurest);
    return detections * std::log(p) + (rounds - detections) * std::log(1.0 - p);
  }
};

// What was counted by distance and bearing, summed up so that any sector is two looks away.
class PolarCounts {
 public:
  static constexpr double kRing = 0.1;  // [m]
  static constexpr int kRings = 150;
  static constexpr int kSectors = 144;
  static constexpr double kSector = 2.0 * kPi / kSectors;  // [rad]

  explicit PolarCounts(std::span<const CalibrationReading> readings)
      : sums_(static_cast<std::size_t>((kRings + 1) * (2 * kSectors + 1))) {
    std::vector<Counts> counts(static_cast<std::size_t>(kRings * kSectors));
    for (const CalibrationReading& reading : readings) {
      const Eigen::Vector2d& tag = reading.tag_in_antenna;
      const int ring = std::min(kRings - 1, static_cast<int>(tag.norm() / kRing));
      const double turn = std::atan2(tag.y(), tag.x()) + kPi;
      const int sector = std::min(kSectors - 1, static_cast<int>(turn / kSector));
      Counts& count = counts[static_cast<std::size_t>(ring * kSectors + sector)];
      count.rounds += 1.0;
      count.detections += reading.detected ? 1.0 : 0.0;
    }
    for (int ring = 0; ring < kRings; ++ring) {
      for (int s = 0; s < 2 * kSectors; ++s) {
        sum(ring + 1, s + 1) = counts[static_cast<std::size_t>(ring * kSectors + s % kSectors)] +
                               sum(ring, s + 1) + sum(ring + 1, s) - sum(ring, s);
      }
    }
  }

  // Rings [0, rings), all around.
  Counts disc(int rings) const { return at(rings, kSectors) - at(rings, 0); }
  // Rings [first, last), `width` sectors from `sector` on, which counts from straight behind.
  Counts arc(int first, int last, int sector, int width) const {
    if (last <= first) return {};
    const int begin = (sector % kSectors + kSectors) % kSectors;
    return at(last, begin + width) - at(last, begin) -
           (at(first, begin + width) - at(first, begin));
  }

 private:
  Counts& sum(int ring, int sector) {
    return sums_[static_cast<std::size_t>(ring * (2 * kSectors + 1) + sector)];
  }
  const Counts& at(int ring, int sector) const {
    return sums_[static_cast<std::size_t>(ring * (2 * kSectors + 1) + sector)];
  }
  std::vector<Counts> sums_;  // of all rings and sectors below; twice round
};

struct Shape {
  int disc = 10;  // rings
  int range = 60;
  int sector = 53;  // where the arc begins
  int width = 38;   // sectors

  bool operator==(const Shape&) const = default;
};

struct Parts {
  Counts disc, arc, elsewhere;
  double log_likelihood() const {
    return disc.log_likelihood() + arc.log_likelihood() + elsewhere.log_likelihood();
  }
};

Parts parts_of(const PolarCounts& counts, const Shape& shape) {
  Parts parts;
  parts.disc = counts.disc(shape.disc);
  parts.arc = counts.arc(shape.disc, shape.range, shape.sector, shape.width);
  parts.elsewhere = counts.disc(PolarCounts::kRings) - parts.disc - parts.arc;
  return parts;
}

// The best arc for a disc and a range, then the best of these for the arc, until neither changes.
Shape best_shape(const PolarCounts& counts) {
  Shape best;
  double most = parts_of(counts, best).log_likelihood();
  const auto consider = [&](const Shape& shape) {
    const double value = parts_of(counts, shape).log_likelihood();
    if (value <= most) return;
    most = value;
    best = shape;
  };
  for (Shape before{.disc = -1}; !(before == best);) {
    before = best;
    Shape shape = best;
    for (shape.width = 2; shape.width < PolarCounts::kSectors; ++shape.width) {
      for (shape.sector = 0; shape.sector < PolarCounts::kSectors; ++shape.sector) consider(shape);
    }
    shape = best;
    for (shape.range = 1; shape.range < PolarCounts::kRings; ++shape.range) {
      for (shape.disc = 0; shape.disc <= shape.range; ++shape.disc) consider(shape);
    }
  }
  return best;
}

// Rounds with the tag in about the same place.
struct Heap {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  // [m] their mean
  Counts counts;
};

std::vector<Heap> heaps_of(std::span<const CalibrationReading> readings) {
  constexpr double kSide = 0.05;  // [m] and, by bearing, [rad]
  std::map<std::pair<int, int>, Heap> heaps;
  for (const CalibrationReading& reading : readings) {
    const Eigen::Vector2d& tag = reading.tag_in_antenna;
    const int ring = static_cast<int>(tag.norm() / kSide);
    Heap& heap = heaps[{ring, static_cast<int>(std::floor(std::atan2(tag.y(), tag.x()) / kSide))}];
    heap.place += tag;
    heap.counts.rounds += 1.0;
    heap.counts.detections += reading.detected ? 1.0 : 0.0;
  }
  std::vector<Heap> result;
  for (auto& [key, heap] : heaps) {
    heap.place /= heap.counts.rounds;
    result.push_back(heap);
  }
  return result;
}

double logistic(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

// Any numbers stand for parameters that make sense. Power over softness is what counts, so that the
// scale of decibels is free: it is the one by which power falls off as in free space.
SmoothAntenna antenna_of(const std::vector<double>& p) {
  SmoothAntenna a;
  a.falloff = 20.0;
  a.direction = p[0];
  a.beam_width = std::exp(p[1]);
  a.back = std::exp(p[2]);
  a.level = p[3];
  a.softness = std::exp(p[4]);
  a.most = logistic(p[5]);
  a.least = 0.2 * logistic(p[6]);
  return a;
}

double negative_log_likelihood(const SmoothAntenna& antenna, const std::vector<Heap>& heaps) {
  double sum = 0.0;
  for (const Heap& heap : heaps) {
    const double p = std::clamp(detection_probability(antenna, heap.place), kSurest, 1.0 - kSurest);
    sum -= heap.counts.detections * std::log(p) +
           (heap.counts.rounds - heap.counts.detections) * std::log(1.0 - p);
  }
  return sum;
}

// rssi - rssi_falloff log10(d) - rssi_beam A(bearing), linear in its three parameters.
void fit_rssi(std::span<const CalibrationReading> readings, SmoothAntenna& antenna) {
  antenna.rssi_sigma = 0.0;
  std::vector<const CalibrationReading*> told;
  for (const CalibrationReading& reading : readings) {
    if (reading.detected && reading.rssi) told.push_back(&reading);
  }
  if (told.size() < 10) return;
  SmoothAntenna falloff = antenna, beam = antenna;
  falloff.rssi = beam.rssi = 0.0;
  beam.rssi_falloff = falloff.rssi_beam = 0.0;
  falloff.rssi_falloff = beam.rssi_beam = 1.0;
  Eigen::MatrixX3d columns(static_cast<Eigen::Index>(told.size()), 3);
  Eigen::VectorXd values(columns.rows());
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const CalibrationReading& reading = *told[static_cast<std::size_t>(i)];
    columns.row(i) << 1.0, expected_rssi(falloff, reading.tag_in_antenna),
        expected_rssi(beam, reading.tag_in_antenna);
    values(i) = *reading.rssi;
  }
  const Eigen::Vector3d solved = columns.colPivHouseholderQr().solve(values);
  antenna.rssi = solved(0);
  antenna.rssi_falloff = solved(1);
  antenna.rssi_beam = solved(2);
  const double squares = (values - columns * solved).squaredNorm();
  antenna.rssi_sigma = std::sqrt(squares / static_cast<double>(columns.rows() - 3));
}

}  // namespace

HistogramAntenna counted_histogram(std::span<const CalibrationReading> readings,
                                   const HistogramOptions& options) {
  HistogramAntenna antenna;
  antenna.cell_size = options.cell_size;
  antenna.cells = 2 * static_cast<int>(std::ceil(options.reach / options.cell_size));
  const auto cells =
      static_cast<std::size_t>(antenna.cells) * static_cast<std::size_t>(antenna.cells);
  antenna.rounds.assign(cells, 0.0);
  antenna.detections.assign(cells, 0.0);
  Counts beyond;
  for (const CalibrationReading& reading : readings) {
    const Eigen::Vector2d at = reading.tag_in_antenna / antenna.cell_size;
    const int x = static_cast<int>(std::floor(at.x() + 0.5 * antenna.cells));
    const int y = static_cast<int>(std::floor(at.y() + 0.5 * antenna.cells));
    const double heard = reading.detected ? 1.0 : 0.0;
    if (x < 0 || y < 0 || x >= antenna.cells || y >= antenna.cells) {
      beyond = beyond + Counts{1.0, heard};
      continue;
    }
    antenna.rounds[antenna.index(x, y)] += 1.0;
    antenna.detections[antenna.index(x, y)] += heard;
  }
  // As if one more round in a hundred had been answered: nobody turns long enough out there.
  antenna.elsewhere_rate = (beyond.detections + 1.0) / (beyond.rounds + 100.0);
  return antenna;
}

PiecewiseAntenna fitted_piecewise(std::span<const CalibrationReading> readings) {
  const PolarCounts counts(readings);
  const Shape shape = best_shape(counts);
  const Parts parts = parts_of(counts, shape);
  PiecewiseAntenna antenna;
  antenna.direction =
      normalized_angle((shape.sector + 0.5 * shape.width) * PolarCounts::kSector - kPi);
  antenna.opening = shape.width * PolarCounts::kSector;
  antenna.range = shape.range * PolarCounts::kRing;
  antenna.disc_radius = shape.disc * PolarCounts::kRing;
  antenna.arc_rate = parts.arc.rate();
  antenna.disc_rate = parts.disc.rate();
  antenna.elsewhere_rate = parts.elsewhere.rate();
  return antenna;
}

SmoothAntenna fitted_smooth(std::span<const CalibrationReading> readings) {
  const std::vector<Heap> heaps = heaps_of(readings);
  const auto cost = [&](const std::vector<double>& p) {
    return negative_log_likelihood(antenna_of(p), heaps);
  };
  const SmoothAntenna usual;
  const std::vector<double> start{0.0,         std::log(usual.beam_width), std::log(usual.back),
                                  usual.level, std::log(usual.softness),   3.0,
                                  -3.0};
  const std::vector<double> step{0.2, 0.3, 0.3, 3.0, 0.5, 1.0, 1.0};
  SmoothAntenna antenna = antenna_of(minimized(cost, start, step));
  fit_rssi(readings, antenna);
  return antenna;
}

double mean_log_likelihood(const AntennaModel& antenna,
                           std::span<const CalibrationReading> readings) {
  Moments moments;
  const auto take = [&](double p, bool detected) {
    p = std::clamp(p, kSurest, 1.0 - kSurest);
    moments.add(std::log(detected ? p : 1.0 - p));
  };
  for (const CalibrationReading& reading : readings) {
    take(detection_probability(antenna, reading.tag_in_antenna), reading.detected);
  }
  return moments.mean();
}

double mean_log_likelihood_of_rssi(const SmoothAntenna& antenna,
                                   std::span<const CalibrationReading> readings) {
  Moments moments;
  if (antenna.rssi_sigma <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  const double normalizer = std::log(antenna.rssi_sigma * std::sqrt(2.0 * kPi));
  for (const CalibrationReading& reading : readings) {
    if (!reading.detected || !reading.rssi) continue;
    const double off =
        (*reading.rssi - expected_rssi(antenna, reading.tag_in_antenna)) / antenna.rssi_sigma;
    moments.add(-0.5 * off * off - normalizer);
  }
  return moments.mean();
}

}  // namespace mapbed
