#pragma once

#include <cmath>
#include <vector>

#include "algorithms/rfid/antenna_model.h"

namespace mapbed {

// An antenna's model as a table over its own plane, for loops over thousands of places: what a
// round says of a tag at a place, by the nearest cell.
class DetectionTable {
 public:
  static constexpr double kCell = 0.1;  // [m]

  explicit DetectionTable(const AntennaModel& antenna);

  // ln p(z | x, r), of a tag at (x, y) [m] in the antenna's frame.
  float log_detected(float x, float y) const { return detected_[cell(x, y)]; }
  float log_missed(float x, float y) const { return missed_[cell(x, y)]; }
  // p(z | x, r) of an answer.
  float detected(float x, float y) const { return probabilities_[cell(x, y)]; }
  float detected_far() const { return probabilities_.back(); }
  // The same of an answer of this strength [dBm], given that it came; 0 where strengths were not
  // learned.
  float log_rssi(float x, float y, float rssi) const {
    if (rssi_.empty()) return 0.0F;
    const float off = (rssi - rssi_[cell(x, y)]) * per_sigma_;
    return -0.5F * off * off;
  }

  bool knows_rssi() const { return !rssi_.empty(); }
  double reach() const { return reach_; }  // [m] from here on all places are alike
  // [m] beyond it silence says next to nothing: fewer than one round in twenty is answered anyhow.
  double silence_reach() const { return silence_reach_; }

 private:
  // The last one for all that is farther away.
  std::size_t cell(float x, float y) const {
    const float column = (x + half_) * kPerCell, row = (y + half_) * kPerCell;
    const auto side = static_cast<float>(side_);
    if (!(column >= 0.0F && row >= 0.0F && column < side && row < side))
      return detected_.size() - 1;
    return static_cast<std::size_t>(row) * side_ + static_cast<std::size_t>(column);
  }

  static constexpr float kPerCell = static_cast<float>(1.0 / kCell);
  double reach_ = 0.0;
  double silence_reach_ = 0.0;
  float half_ = 0.0F;     // [m] of the table
  std::size_t side_ = 0;  // cells
  std::vector<float> detected_, missed_, probabilities_, rssi_;
  float per_sigma_ = 0.0F;
};

}  // namespace mapbed
