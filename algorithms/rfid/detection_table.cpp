#include "algorithms/rfid/detection_table.h"

#include <algorithm>
#include <numbers>

namespace mapbed {
namespace {

constexpr double kHeardAtTimes = 0.05;
constexpr double kSurest = 1e-4;  // nothing that was learned is surer

// p(detected) by place; a histogram's rates are worked out once.
class Probabilities {
 public:
  explicit Probabilities(const AntennaModel& antenna) : antenna_(antenna) {
    if (const auto* counted = std::get_if<HistogramAntenna>(&antenna)) rates_ = rates_of(*counted);
  }

  double at(const Eigen::Vector2d& place) const {
    const auto* counted = std::get_if<HistogramAntenna>(&antenna_);
    if (counted == nullptr) return detection_probability(antenna_, place);
    const double half = 0.5 * counted->cells;
    const int x = static_cast<int>(std::floor(place.x() / counted->cell_size + half));
    const int y = static_cast<int>(std::floor(place.y() / counted->cell_size + half));
    const bool inside = x >= 0 && y >= 0 && x < counted->cells && y < counted->cells;
    return inside ? rates_[counted->index(x, y)] : counted->elsewhere_rate;
  }

 private:
  const AntennaModel& antenna_;
  std::vector<double> rates_;
};

}  // namespace

DetectionTable::DetectionTable(const AntennaModel& antenna) : reach_(reach_of(antenna)) {
  const auto half_cells = static_cast<std::size_t>(std::ceil(reach_ / kCell)) + 1;
  side_ = 2 * half_cells;
  half_ = static_cast<float>(static_cast<double>(half_cells) * kCell);
  const auto* smooth = std::get_if<SmoothAntenna>(&antenna);
  const bool has_rssi = smooth != nullptr && smooth->rssi_sigma > 0.0;
  if (has_rssi) per_sigma_ = static_cast<float>(1.0 / smooth->rssi_sigma);
  const Probabilities probabilities(antenna);
  const auto take = [&](const Eigen::Vector2d& place) {
    const double p = std::clamp(probabilities.at(place), kSurest, 1.0 - kSurest);
    probabilities_.push_back(static_cast<float>(p));
    if (p > kHeardAtTimes && place.norm() < 2.0 * reach_) {
      silence_reach_ = std::max(silence_reach_, place.norm());
    }
    detected_.push_back(static_cast<float>(std::log(p)));
    missed_.push_back(static_cast<float>(std::log(1.0 - p)));
    if (has_rssi) rssi_.push_back(static_cast<float>(expected_rssi(*smooth, place)));
  };
  const auto centre = [&](std::size_t i) {
    return (static_cast<double>(i) + 0.5 - static_cast<double>(half_cells)) * kCell;
  };
  for (std::size_t y = 0; y < side_; ++y) {
    for (std::size_t x = 0; x < side_; ++x) take({centre(x), centre(y)});
  }
  // Far away there is no direction: behind the antenna, where it says least.
  take({-1e3, 0.0});
}

}  // namespace mapbed
