#include "algorithms/rfid/rfid_weights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kSquare = 0.3;       // [m] positions so near each other are one
constexpr double kBeyondRange = 2.0;  // [m] where silence still says something
constexpr double kLeastRatio = 1e-100;
constexpr int kMostTries = 10'000;  // at a place from which the antenna may have heard the tag

Eigen::Vector2d heaviest_of(const TagBelief& belief) {
  const auto heaviest = std::max_element(belief.weights.begin(), belief.weights.end());
  return belief.positions[static_cast<std::size_t>(heaviest - belief.weights.begin())];
}

// The largest probability of an answer that the table has.
double best_of(const DetectionTable& table) {
  float best = table.detected_far();
  const auto step = static_cast<float>(DetectionTable::kCell);
  const auto reach = static_cast<float>(table.reach());
  for (float y = -reach; y <= reach; y += step) {
    for (float x = -reach; x <= reach; x += step) best = std::max(best, table.detected(x, y));
  }
  return static_cast<double>(best);
}

}  // namespace

RfidWeights::RfidWeights(int antenna, const AntennaModel& model, const std::vector<TagBelief>& tags,
                         const OccupancyMap& map, const RfidWeightOptions& options)
    : antenna_(antenna), table_(model), best_(best_of(table_)), options_(options) {
  if (options.rssi && !table_.knows_rssi()) {
    throw InputError({}, "this RFID model has not learned how strong answers are",
                     "take a model of kind 'smooth', or leave rssi out");
  }
  std::vector<Eigen::Vector2d> middles;
  for (const TagBelief& tag : tags) {
    tag_of_name_[tag.tag] = tags_.size();
    tags_.push_back(tag_of(tag));
    middles.push_back(heaviest_of(tag));
  }
  answered_.assign(tags_.size(), false);
  if (options.non_detections) {
    visibility_ = std::make_unique<TagVisibility>(map, middles, range_of(model) + kBeyondRange);
  }
}

// Positions in squares count together; the heaviest of these are kept.
RfidWeights::Tag RfidWeights::tag_of(const TagBelief& belief) const {
  struct Square {
    double weight = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  };
  std::map<std::pair<int, int>, Square> by_place;
  for (std::size_t i = 0; i < belief.positions.size(); ++i) {
    const Eigen::Vector2d at = belief.positions[i] / kSquare;
    Square& square =
        by_place[{static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))}];
    square.weight += belief.weights[i];
    square.sum += belief.weights[i] * belief.positions[i];
  }
  std::vector<Square> squares;
  for (const auto& [place, square] : by_place) squares.push_back(square);
  std::stable_sort(squares.begin(), squares.end(),
                   [](const Square& a, const Square& b) { return a.weight > b.weight; });
  squares.resize(std::min(squares.size(), static_cast<std::size_t>(options_.positions)));
  double kept = 0.0;
  for (const Square& square : squares) kept += square.weight;
  Tag tag;
  for (const Square& square : squares) {
    if (square.weight <= 0.0) continue;
    const Eigen::Vector2d mean = square.sum / square.weight;
    tag.x.push_back(static_cast<float>(mean.x()));
    tag.y.push_back(static_cast<float>(mean.y()));
    tag.weights.push_back(static_cast<float>(square.weight / kept));
  }
  return tag;
}

bool RfidWeights::take(const Measurement& measurement, std::span<const float>) {
  const auto* round = std::get_if<RfidDetections>(&measurement);
  if (round == nullptr || round->antenna != antenna_) return false;
  robot_from_antenna_ = round->robot_from_antenna.planar;
  answers_.clear();
  std::fill(answered_.begin(), answered_.end(), false);
  for (const RfidRead& read : round->reads) {
    const auto found = tag_of_name_.find(read.tag);
    if (found == tag_of_name_.end()) continue;
    const bool has_rssi = options_.rssi && read.has_rssi();
    answers_.push_back({found->second, static_cast<float>(has_rssi ? read.rssi : 0.0), has_rssi});
    answered_[found->second] = true;
  }
  return !answers_.empty() || options_.non_detections;
}

// Against a place far from all tags, where only what is heard anyhow is heard.
double RfidWeights::log_weight(const Pose2& map_from_robot) const {
  const Pose2 map_from_antenna = map_from_robot * robot_from_antenna_;
  const Pose2 antenna_from_map = inverse(map_from_antenna);
  const auto c = static_cast<float>(std::cos(antenna_from_map.theta));
  const auto s = static_cast<float>(std::sin(antenna_from_map.theta));
  const auto dx = static_cast<float>(antenna_from_map.x);
  const auto dy = static_cast<float>(antenna_from_map.y);
  // (7.2), of `what` at each position in the antenna's frame.
  const auto summed = [&](const Tag& tag, auto&& what) {
    double sum = 0.0;
    for (std::size_t i = 0; i < tag.x.size(); ++i) {
      const float x = c * tag.x[i] - s * tag.y[i] + dx;
      const float y = s * tag.x[i] + c * tag.y[i] + dy;
      sum += static_cast<double>(tag.weights[i] * what(x, y));
    }
    return sum;
  };
  double ratio = 1.0;
  for (const Answer& answer : answers_) {
    ratio *= summed(tags_[answer.tag], [&](float x, float y) {
      const float detected = table_.detected(x, y);
      return answer.has_rssi ? detected * std::exp(table_.log_rssi(x, y, answer.rssi)) : detected;
    });
    ratio /= static_cast<double>(table_.detected_far());
    ratio = std::max(ratio, kLeastRatio);
  }
  if (visibility_ == nullptr) return std::log(ratio);
  const double missed_far = 1.0 - static_cast<double>(table_.detected_far());
  for (const std::uint32_t i : visibility_->from(map_from_antenna.position())) {
    if (answered_[i]) continue;
    const double detected =
        summed(tags_[i], [&](float x, float y) { return table_.detected(x, y); });
    ratio *= (1.0 - detected) / missed_far;
  }
  return std::log(std::max(ratio, kLeastRatio));
}

void RfidWeights::add_log_weights(std::span<const Pose2> map_from_robot,
                                  std::span<double> log_weights) const {
  for (std::size_t i = 0; i < map_from_robot.size(); ++i) {
    log_weights[i] += log_weight(map_from_robot[i]);
  }
}

// About one of the tags that answered, by how likely the antenna hears it from there.
std::optional<Pose2> RfidWeights::propose(Rng& rng) const {
  if (answers_.empty()) return {};
  const Tag& tag = tags_[answers_[rng.index(answers_.size())].tag];
  float left = static_cast<float>(rng.uniform());
  std::size_t at = 0;
  while (at + 1 < tag.weights.size() && left >= tag.weights[at]) left -= tag.weights[at++];
  const Eigen::Vector2d place(static_cast<double>(tag.x[at]), static_cast<double>(tag.y[at]));
  for (int i = 0; i < kMostTries; ++i) {
    const Eigen::Vector2d tag_in_antenna(rng.uniform(-table_.reach(), table_.reach()),
                                         rng.uniform(-table_.reach(), table_.reach()));
    const double p = static_cast<double>(table_.detected(static_cast<float>(tag_in_antenna.x()),
                                                         static_cast<float>(tag_in_antenna.y())));
    if (rng.uniform() * best_ > p) continue;
    const double heading = rng.uniform(-kPi, kPi);
    const Pose2 turned{0.0, 0.0, heading};
    const Eigen::Vector2d antenna = place - turned * tag_in_antenna;
    return Pose2{antenna.x(), antenna.y(), heading} * inverse(robot_from_antenna_);
  }
  return {};
}

std::optional<double> RfidWeights::log_odds_of_map(const Pose2& map_from_robot) const {
  return log_weight(map_from_robot);
}

}  // namespace mapbed
