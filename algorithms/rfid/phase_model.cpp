#include "algorithms/rfid/phase_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/rfid/simplex_search.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// ln I0 by its series, or for large arguments by its asymptotic one; good to 1e-7.
double log_bessel_0(double x) {
  if (x < 30.0) {
    double term = 1.0, sum = 1.0;
    for (int k = 1; k < 200 && term > 1e-17 * sum; ++k) {
      term *= 0.25 * x * x / (static_cast<double>(k) * k);
      sum += term;
    }
    return std::log(sum);
  }
  return x - 0.5 * std::log(2.0 * kPi * x) + std::log1p(1.0 / (8.0 * x) + 9.0 / (128.0 * x * x));
}

// I1 / I0, the mean cosine, as the slope of ln I0.
double mean_cosine_of(double kappa) {
  constexpr double kStep = 1e-4;
  return (log_bessel_0(kappa + kStep) - log_bessel_0(std::abs(kappa - kStep))) / (2.0 * kStep);
}

// Readings by channel, as lattices of shifts are searched with them.
class ShiftSearch {
 public:
  ShiftSearch(std::span<const PhaseReading> readings, std::span<const Eigen::Vector3d> reference,
              int turns)
      : turns_(turns), readings_(readings.begin(), readings.end()) {
    std::vector<std::size_t> order(readings.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return readings[a].channel < readings[b].channel;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      readings_[i] = readings[order[i]];
      readings_[i].place += reference[order[i]];
      per_meter_.push_back(2.0 * turns / readings_[i].wavelength);
    }
    for (int i = 0; i < kParts; ++i) {
      circle_.push_back(std::polar(1.0, -2.0 * kPi * (i + 0.5) / kParts));
    }
  }

  double agreement(const Eigen::Vector3d& shift) const {
    return summed([&](std::size_t i) {
      return std::polar(1.0, -expected_phase(readings_[i], shift, turns_));
    });
  }
  // The same to 1 in 1000, by a circle in so many parts.
  double about(const Eigen::Vector3d& shift) const {
    return summed([&](std::size_t i) {
      const double turned = (readings_[i].place + shift).norm() * per_meter_[i];
      const double part = turned - static_cast<double>(static_cast<long>(turned));
      return circle_[static_cast<std::size_t>(part * kParts)];
    });
  }

 private:
  static constexpr int kParts = 4096;

  template <class Turn>
  double summed(const Turn& turn) const {
    double total = 0.0, real = 0.0, imaginary = 0.0;
    for (std::size_t i = 0; i < readings_.size(); ++i) {
      if (i > 0 && readings_[i].channel != readings_[i - 1].channel) {
        total += std::hypot(real, imaginary);
        real = imaginary = 0.0;
      }
      const std::complex<double> by = turn(i);
      const std::complex<double>& mean = readings_[i].mean;
      real += mean.real() * by.real() - mean.imag() * by.imag();
      imaginary += mean.real() * by.imag() + mean.imag() * by.real();
    }
    return total + std::hypot(real, imaginary);
  }

  int turns_ = 1;
  std::vector<PhaseReading> readings_;
  std::vector<double> per_meter_;  // turns of the phase
  std::vector<std::complex<double>> circle_;
};

}  // namespace

double expected_phase(const PhaseReading& reading, const Eigen::Vector3d& shift, int turns) {
  return turns * 4.0 * kPi * (reading.place + shift).norm() / reading.wavelength;
}

std::vector<std::complex<double>> turned_back(std::span<const PhaseReading> readings,
                                              std::span<const Eigen::Vector3d> shifts, int turns) {
  std::vector<std::complex<double>> left;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    left.push_back(readings[i].mean *
                   std::polar(1.0, -expected_phase(readings[i], shifts[i], turns)));
  }
  return left;
}

Eigen::Vector3d best_shift(std::span<const PhaseReading> readings,
                           std::span<const Eigen::Vector3d> reference, double half_side,
                           int turns) {
  if (readings.empty()) return Eigen::Vector3d::Zero();
  const ShiftSearch search(readings, reference, turns);
  const int steps =
      std::max(1, static_cast<int>(std::ceil(14.0 * turns * half_side / readings[0].wavelength)));
  const double step = half_side / steps;
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double most = -std::numeric_limits<double>::infinity();
  for (int x = -steps; x <= steps; ++x) {
    for (int y = -steps; y <= steps; ++y) {
      for (int z = -steps; z <= steps; ++z) {
        const Eigen::Vector3d shift(step * x, step * y, step * z);
        const double value = search.about(shift);
        if (value <= most) continue;
        most = value;
        best = shift;
      }
    }
  }
  const auto cost = [&](const std::vector<double>& at) {
    return -search.agreement({at[0], at[1], at[2]});
  };
  const std::vector<double> fine =
      minimized(cost, {best.x(), best.y(), best.z()}, {0.5 * step, 0.5 * step, 0.5 * step});
  return {fine[0], fine[1], fine[2]};
}

double log_von_mises(double cosine, double kappa) {
  return kappa * cosine - std::log(2.0 * kPi) - log_bessel_0(kappa);
}

double kappa_of(double mean_cosine) {
  if (!(mean_cosine > 0.0)) return 0.0;
  double low = 0.0, high = 500.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (mean_cosine_of(middle) < mean_cosine ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace mapbed
