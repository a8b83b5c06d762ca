#include "algorithms/rfid/antenna_model.h"

#include <algorithm>
#include <cmath>

#include "core/statistics/distributions.h"

namespace mapbed {
namespace {

constexpr double kNearest = 0.1;  // [m] nearer than this tags are as near as this

double bearing_from(double direction, const Eigen::Vector2d& tag) {
  return angle_difference(direction, std::atan2(tag.y(), tag.x()));
}

double rate(const PiecewiseAntenna& a, const Eigen::Vector2d& tag) {
  const double distance = tag.norm();
  if (distance <= a.disc_radius) return a.disc_rate;
  const bool ahead = std::abs(bearing_from(a.direction, tag)) <= 0.5 * a.opening;
  return ahead && distance <= a.range ? a.arc_rate : a.elsewhere_rate;
}

double probability(const PiecewiseAntenna& a, const Eigen::Vector2d& tag) {
  const double p = rate(a, tag);
  return (1.0 - a.caution) * p + a.caution * 0.5 * (1.0 + p);
}

int cell_of(const HistogramAntenna& a, double coordinate) {
  return static_cast<int>(std::floor(coordinate / a.cell_size + 0.5 * a.cells));
}

// One answer takes the whole table: for callers that ask for many there is rates_of().
double probability(const HistogramAntenna& a, const Eigen::Vector2d& tag) {
  const int x = cell_of(a, tag.x()), y = cell_of(a, tag.y());
  if (x < 0 || y < 0 || x >= a.cells || y >= a.cells) return a.elsewhere_rate;
  return rates_of(a)[a.index(x, y)];
}

double beam_loss(const SmoothAntenna& a, const Eigen::Vector2d& tag) {
  const double turned = bearing_from(a.direction, tag) / a.beam_width;
  return std::min(12.0 * turned * turned, a.back);
}

double decades(const Eigen::Vector2d& tag) {
  return std::log10(std::max(tag.norm(), kNearest));
}

double probability(const SmoothAntenna& a, const Eigen::Vector2d& tag) {
  const double power = a.level - a.falloff * decades(tag) - beam_loss(a, tag);
  return a.least + (a.most - a.least) * normal_below(power / a.softness);
}

double range(const PiecewiseAntenna& a) {
  return std::max(a.range, a.disc_radius);
}
double range(const HistogramAntenna& a) {
  double farthest = 0.0;
  for (int y = 0; y < a.cells; ++y) {
    for (int x = 0; x < a.cells; ++x) {
      const std::size_t i = a.index(x, y);
      if (a.rounds[i] == 0.0 || a.detections[i] < 0.5 * a.rounds[i]) continue;
      const double half = 0.5 * (a.cells - 1);
      farthest = std::max(farthest, a.cell_size * std::hypot(x - half, y - half));
    }
  }
  return farthest;
}
double range(const SmoothAntenna& a) {
  return std::pow(10.0, a.level / a.falloff);
}

double reach(const PiecewiseAntenna& a) {
  return std::max(a.range, a.disc_radius);
}
double reach(const HistogramAntenna& a) {
  return 0.5 * a.cells * a.cell_size * std::sqrt(2.0);
}
// Where the probit is down to 1 %.
double reach(const SmoothAntenna& a) {
  const double power = a.softness * normal_quantile(0.01);
  return std::pow(10.0, (a.level - power) / a.falloff);
}

}  // namespace

double detection_probability(const AntennaModel& antenna, const Eigen::Vector2d& tag_in_antenna) {
  return std::visit([&](const auto& a) { return probability(a, tag_in_antenna); }, antenna);
}

double range_of(const AntennaModel& antenna) {
  return std::visit([](const auto& a) { return range(a); }, antenna);
}

double reach_of(const AntennaModel& antenna) {
  return std::visit([](const auto& a) { return reach(a); }, antenna);
}

double expected_rssi(const SmoothAntenna& a, const Eigen::Vector2d& tag) {
  return a.rssi - a.rssi_falloff * decades(tag) - a.rssi_beam * beam_loss(a, tag);
}

std::vector<double> rates_of(const HistogramAntenna& a) {
  const auto ring_of = [&](int x, int y) {
    const double half = 0.5 * (a.cells - 1);
    return static_cast<std::size_t>(std::lround(std::hypot(x - half, y - half)));
  };
  std::vector<double> ring_rounds(static_cast<std::size_t>(a.cells) + 1, 0.0);
  std::vector<double> ring_detections = ring_rounds;
  for (int y = 0; y < a.cells; ++y) {
    for (int x = 0; x < a.cells; ++x) {
      ring_rounds[ring_of(x, y)] += a.rounds[a.index(x, y)];
      ring_detections[ring_of(x, y)] += a.detections[a.index(x, y)];
    }
  }
  std::vector<double> rates(a.rounds.size());
  for (int y = 0; y < a.cells; ++y) {
    for (int x = 0; x < a.cells; ++x) {
      const std::size_t ring = ring_of(x, y);
      // A ring that nobody looked into is taken to be as everything beyond.
      const double of_ring = (ring_detections[ring] + a.prior_rounds * a.elsewhere_rate) /
                             (ring_rounds[ring] + a.prior_rounds);
      const std::size_t i = a.index(x, y);
      rates[i] = (a.detections[i] + a.prior_rounds * of_ring) / (a.rounds[i] + a.prior_rounds);
    }
  }
  return rates;
}

}  // namespace mapbed
