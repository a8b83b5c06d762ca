#include "core/statistics/bootstrap.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/random.h"

namespace mapbed {
namespace {

constexpr std::size_t kResamples = 2000;
constexpr std::uint64_t kSeed = 2012;

}  // namespace

Interval bootstrap_interval(std::span<const double> values) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (values.size() < 2) return {kNone, kNone};
  Rng rng = Rng(kSeed).stream("bootstrap");
  std::vector<double> means(kResamples);
  for (double& mean : means) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[rng.index(values.size())];
    mean = sum / static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  return {means[kResamples / 40], means[kResamples - 1 - kResamples / 40]};
}

}  // namespace mapbed
