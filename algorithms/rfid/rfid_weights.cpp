#include "algorithms/rfid/rfid_weights.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr int kMostTries = 10'000;  // at a place from which the antenna may have heard the tag

// The largest probability of an answer that the table has.
double best_of(const DetectionTable& table) {
  float best = table.log_detected(1e9F, 0.0F);
  const auto step = static_cast<float>(DetectionTable::kCell);
  const auto reach = static_cast<float>(table.reach());
  for (float y = -reach; y <= reach; y += step) {
    for (float x = -reach; x <= reach; x += step) best = std::max(best, table.log_detected(x, y));
  }
  return std::exp(static_cast<double>(best));
}

}  // namespace

RfidWeights::RfidWeights(int antenna, const AntennaModel& model, const std::vector<TagBelief>& tags,
                         const RfidWeightOptions& options)
    : antenna_(antenna), table_(model), best_(best_of(table_)), options_(options) {
  if (options.rssi && !table_.knows_rssi()) {
    throw InputError({}, "this RFID model has not learned how strong answers are",
                     "take a model of kind 'smooth', or leave rssi out");
  }
  for (const TagBelief& tag : tags) {
    tag_of_name_[tag.tag] = tags_.size();
    tags_.push_back(tag_of(tag));
  }
  answered_.assign(tags_.size(), false);
}

// Positions at equal steps of the summed weights: heavy ones come more often.
RfidWeights::Tag RfidWeights::tag_of(const TagBelief& belief) const {
  Tag tag;
  tag.middle = Eigen::Vector2d::Zero();
  const auto wanted = static_cast<std::size_t>(options_.positions);
  const std::size_t count = std::min(wanted, belief.positions.size() == 1 ? 1 : wanted);
  double sum = 0.0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < belief.positions.size() && next < count; ++i) {
    sum += belief.weights[i];
    const bool is_last = i + 1 == belief.positions.size();
    while (next < count &&
           (is_last || sum * static_cast<double>(count) > static_cast<double>(next) + 0.5)) {
      tag.x.push_back(static_cast<float>(belief.positions[i].x()));
      tag.y.push_back(static_cast<float>(belief.positions[i].y()));
      tag.middle += belief.positions[i] / static_cast<double>(count);
      ++next;
    }
  }
  for (std::size_t i = 0; i < tag.x.size(); ++i) {
    const Eigen::Vector2d at(static_cast<double>(tag.x[i]), static_cast<double>(tag.y[i]));
    tag.extent = std::max(tag.extent, (at - tag.middle).norm());
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

double RfidWeights::log_likelihood(const Tag& tag, const Pose2& antenna_from_map,
                                   const Answer* answer) const {
  const auto c = static_cast<float>(std::cos(antenna_from_map.theta));
  const auto s = static_cast<float>(std::sin(antenna_from_map.theta));
  const auto dx = static_cast<float>(antenna_from_map.x);
  const auto dy = static_cast<float>(antenna_from_map.y);
  double sum = 0.0;
  for (std::size_t i = 0; i < tag.x.size(); ++i) {
    const float x = c * tag.x[i] - s * tag.y[i] + dx;
    const float y = s * tag.x[i] + c * tag.y[i] + dy;
    float value = answer != nullptr ? table_.log_detected(x, y) : table_.log_missed(x, y);
    if (answer != nullptr && answer->has_rssi) value += table_.log_rssi(x, y, answer->rssi);
    sum += static_cast<double>(std::exp(value));
  }
  return std::log(sum / static_cast<double>(tag.x.size()) + 1e-12);
}

// Against a place far from all tags, where only what is heard anyhow is heard.
double RfidWeights::log_weight(const Pose2& map_from_robot) const {
  const Pose2 map_from_antenna = map_from_robot * robot_from_antenna_;
  const Pose2 antenna_from_map = inverse(map_from_antenna);
  const double heard_far = static_cast<double>(table_.log_detected(1e9F, 0.0F));
  const double missed_far = static_cast<double>(table_.log_missed(1e9F, 0.0F));
  double sum = 0.0;
  for (const Answer& answer : answers_) {
    sum += log_likelihood(tags_[answer.tag], antenna_from_map, &answer) - heard_far;
  }
  if (!options_.non_detections) return sum;
  const Eigen::Vector2d place = map_from_antenna.position();
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    const Tag& tag = tags_[i];
    const double distance = table_.reach() + tag.extent;
    if (answered_[i] || (place - tag.middle).squaredNorm() > distance * distance) continue;
    sum += log_likelihood(tag, antenna_from_map, nullptr) - missed_far;
  }
  return sum;
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
  const std::size_t at = rng.index(tag.x.size());
  const Eigen::Vector2d place(static_cast<double>(tag.x[at]), static_cast<double>(tag.y[at]));
  for (int i = 0; i < kMostTries; ++i) {
    const Eigen::Vector2d tag_in_antenna(rng.uniform(-table_.reach(), table_.reach()),
                                         rng.uniform(-table_.reach(), table_.reach()));
    const double p = std::exp(static_cast<double>(table_.log_detected(
        static_cast<float>(tag_in_antenna.x()), static_cast<float>(tag_in_antenna.y()))));
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
