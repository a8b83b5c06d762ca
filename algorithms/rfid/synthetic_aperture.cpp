#include "algorithms/rfid/synthetic_aperture.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// Of each channel, reads at least `spacing` apart.
std::vector<PhaseRead> thinned(std::span<const PhaseRead> reads, double spacing) {
  std::vector<PhaseRead> kept;
  std::map<int, Eigen::Vector3d> last;
  for (const PhaseRead& read : reads) {
    const auto [place, is_first] = last.try_emplace(read.channel, read.antenna);
    if (!is_first && (place->second - read.antenna).norm() < spacing) continue;
    place->second = read.antenna;
    kept.push_back(read);
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [](const PhaseRead& a, const PhaseRead& b) { return a.channel < b.channel; });
  return kept;
}

// Reads by channel, one after the other.
double agreement(std::span<const PhaseRead> sorted, const Eigen::Vector3d& place) {
  double sum = 0.0;
  std::complex<double> of_channel = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i > 0 && sorted[i].channel != sorted[i - 1].channel) {
      sum += std::abs(of_channel);
      of_channel = 0.0;
    }
    const PhaseRead& read = sorted[i];
    const double there_and_back = 4.0 * kPi * (place - read.antenna).norm() / read.wavelength;
    of_channel += std::polar(1.0, read.phase - there_and_back);
  }
  sum += std::abs(of_channel);
  return sum / static_cast<double>(sorted.size());
}

std::vector<double> lattice(double low, double high, double step) {
  const int gaps = std::max(0, static_cast<int>(std::ceil((high - low) / step)));
  std::vector<double> values;
  for (int i = 0; i <= gaps; ++i) {
    values.push_back(gaps == 0 ? low : low + (high - low) * i / gaps);
  }
  return values;
}

// Antennas are at about one height, so that heights tell little: steps of them are twice as large.
void search(std::span<const PhaseRead> reads, const Eigen::AlignedBox3d& box, double step,
            ApertureAnswer& best) {
  for (const double z : lattice(box.min().z(), box.max().z(), 2.0 * step)) {
    for (const double y : lattice(box.min().y(), box.max().y(), step)) {
      for (const double x : lattice(box.min().x(), box.max().x(), step)) {
        const double value = agreement(reads, {x, y, z});
        if (value <= best.agreement) continue;
        best.agreement = value;
        best.position = {x, y, z};
      }
    }
  }
}

}  // namespace

double phase_agreement(std::span<const PhaseRead> reads, const Eigen::Vector3d& place) {
  if (reads.empty()) return 0.0;
  return agreement(thinned(reads, 0.0), place);
}

ApertureAnswer focused(std::span<const PhaseRead> reads, const Eigen::AlignedBox3d& box,
                       const ApertureOptions& options) {
  ApertureAnswer answer;
  const std::vector<PhaseRead> used = thinned(reads, options.spacing);
  answer.reads = static_cast<int>(used.size());
  if (used.empty() || box.isEmpty()) return answer;
  answer.position = box.center();
  search(used, box, options.step, answer);
  const Eigen::Vector3d about = Eigen::Vector3d::Constant(options.step);
  Eigen::AlignedBox3d near(answer.position - about, answer.position + about);
  search(used, near.intersection(box), 0.1 * options.step, answer);
  return answer;
}

}  // namespace mapbed
