#include "algorithms/rfid/tag_mapper.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "algorithms/particles/resampling.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr float kSaysNothing = 0.01F;   // of ln p
constexpr double kLeastSpacing = 0.04;  // [m]
constexpr double kSamePlace = 0.15;     // [m] from where the same things are seen

double side_of_square(const LearnedRfid& model, const TagMapperOptions& options) {
  if (options.side > 0.0) return options.side;
  double range = 0.0;
  for (const AntennaModel& antenna : model) range = std::max(range, range_of(antenna));
  return 2.0 * (range + options.margin);
}

}  // namespace

TagMapper::TagMapper(const LearnedRfid& model, const TagMapperOptions& options, const Rng& rng,
                     std::shared_ptr<const OccupancyMap> map)
    : options_(options), rng_(rng), map_(std::move(map)) {
  for (const AntennaModel& antenna : model) tables_.emplace_back(antenna);
  const bool knows = std::all_of(tables_.begin(), tables_.end(),
                                 [](const DetectionTable& table) { return table.knows_rssi(); });
  if (options.rssi && !knows) {
    throw InputError({}, "this RFID model has not learned how strong answers are",
                     "take a model of kind 'smooth', or leave rssi out");
  }
  side_ = side_of_square(model, options);
}

TagMapper::Tag TagMapper::make_tag(const std::string& name, const Eigen::Vector2d& robot) const {
  Tag tag;
  Rng rng = rng_.stream(name);
  const auto count = static_cast<std::size_t>(options_.positions);
  for (std::size_t i = 0; i < count; ++i) {
    tag.x.push_back(static_cast<float>(robot.x() + side_ * (rng.uniform() - 0.5)));
    tag.y.push_back(static_cast<float>(robot.y() + side_ * (rng.uniform() - 0.5)));
  }
  tag.log_weights.assign(count, 0.0);
  tag.spacing = side_ / std::sqrt(static_cast<double>(count));
  take_note_of_extent(tag);
  return tag;
}

void TagMapper::take_note_of_extent(Tag& tag) {
  const auto [left, right] = std::minmax_element(tag.x.begin(), tag.x.end());
  const auto [low, high] = std::minmax_element(tag.y.begin(), tag.y.end());
  const Eigen::Vector2d min(static_cast<double>(*left), static_cast<double>(*low));
  const Eigen::Vector2d max(static_cast<double>(*right), static_cast<double>(*high));
  tag.middle = 0.5 * (min + max);
  tag.extent = 0.5 * (max - min).norm();
}

// Resampling with a kernel as wide as the gaps between positions, which halve with it.
void TagMapper::redraw_if_few(const std::string& name, Tag& tag) const {
  if (options_.redraw_below <= 0.0) return;
  const std::vector<double> weights = normalized(tag.log_weights);
  const auto count = static_cast<double>(weights.size());
  if (effective_number(weights) >= options_.redraw_below * count) return;
  Rng rng = rng_.stream(name, 1 + tag.redrawn++);
  Tag drawn;
  for (const std::size_t i : resampled(weights, weights.size(), rng)) {
    drawn.x.push_back(tag.x[i] + static_cast<float>(rng.normal(0.0, 0.5 * tag.spacing)));
    drawn.y.push_back(tag.y[i] + static_cast<float>(rng.normal(0.0, 0.5 * tag.spacing)));
  }
  tag.x = std::move(drawn.x);
  tag.y = std::move(drawn.y);
  tag.log_weights.assign(tag.x.size(), 0.0);
  tag.spacing = std::max(kLeastSpacing, 0.5 * tag.spacing);
  take_note_of_extent(tag);
}

// How much a reading counts: the k-th one from about the same place 1/k - so that all of them
// together grow as their number's logarithm - where places that are near fade alike.
double TagMapper::news(Tag& tag, int antenna, const Eigen::Vector2d& place) const {
  if (options_.news_distance <= 0.0) return 1.0;
  const auto [newest, is_first] = tag.newest.try_emplace(antenna, place);
  double& pooled = tag.pooled[antenna];
  if (is_first || (place - newest->second).norm() >= options_.news_distance) {
    newest->second = place;
    pooled = 0.0;
  }
  pooled += 1.0;
  return 1.0 / pooled;
}

// Antennas that are near each other share it.
std::shared_ptr<const LineOfSight> TagMapper::sight_from(const Eigen::Vector2d& place) {
  if (map_ == nullptr) return nullptr;
  if (sight_ == nullptr || (sight_->from() - place).norm() > kSamePlace) {
    double reach = 0.0;
    for (const DetectionTable& table : tables_) reach = std::max(reach, table.reach());
    sight_ = std::make_shared<LineOfSight>(*map_, place, reach);
  }
  return sight_;
}

// One reading of a tag; null: it was silent.
void TagMapper::take(Tag& tag, const PastRound& round, const RfidRead* read, double weight) const {
  const DetectionTable& table = tables_[static_cast<std::size_t>(round.antenna)];
  const Pose2 antenna_from_map = inverse(round.map_from_antenna);
  const auto c = static_cast<float>(std::cos(antenna_from_map.theta));
  const auto s = static_cast<float>(std::sin(antenna_from_map.theta));
  const auto dx = static_cast<float>(antenna_from_map.x);
  const auto dy = static_cast<float>(antenna_from_map.y);
  const bool strength = read != nullptr && options_.rssi && read->has_rssi();
  const auto rssi = static_cast<float>(strength ? read->rssi : 0.0);
  const auto far = table.log_missed(1e9F, 0.0F);
  for (std::size_t i = 0; i < tag.x.size(); ++i) {
    const float x = c * tag.x[i] - s * tag.y[i] + dx;
    const float y = s * tag.x[i] + c * tag.y[i] + dy;
    float value = read != nullptr ? table.log_detected(x, y) : table.log_missed(x, y);
    const bool is_hidden = read == nullptr && value < far - kSaysNothing &&
                           round.sight != nullptr && !round.sight->sees(tag.x[i], tag.y[i]);
    if (is_hidden) value = far;
    if (strength) value += table.log_rssi(x, y, rssi);
    tag.log_weights[i] += weight * static_cast<double>(value);
  }
}

bool TagMapper::may_hear(const Tag& tag, int antenna, const Eigen::Vector2d& place) const {
  const double reach = tables_[static_cast<std::size_t>(antenna)].silence_reach();
  return (place - tag.middle).norm() <= reach + tag.extent;
}

// Where all positions are beyond reach, silence tells them not apart.
void TagMapper::take_silence(Tag& tag, const PastRound& round) const {
  const Eigen::Vector2d place = round.map_from_antenna.position();
  if (!may_hear(tag, round.antenna, place)) return;
  take(tag, round, nullptr, news(tag, round.antenna, place));
}

void TagMapper::add(const RfidDetections& round, const Pose2& map_from_robot) {
  if (round.antenna < 0 || static_cast<std::size_t>(round.antenna) >= tables_.size()) {
    throw InputError({},
                     fmt::format("antenna {} answers, and the RFID model knows {}",
                                 round.antenna + 1, tables_.size()),
                     "learn a model of this robot's antennas");
  }
  PastRound now{round.antenna, map_from_robot * round.robot_from_antenna.planar, nullptr};
  const Eigen::Vector2d place = now.map_from_antenna.position();
  if (options_.non_detections) now.sight = sight_from(place);
  std::set<std::string_view> answered;
  for (const RfidRead& read : round.reads) {
    answered.insert(read.tag);
    auto found = tags_.find(read.tag);
    if (found == tags_.end()) {
      found = tags_.emplace(read.tag, make_tag(read.tag, map_from_robot.position())).first;
      for (const PastRound& past : past_) take_silence(found->second, past);
    }
    Tag& tag = found->second;
    ++tag.detections;
    take(tag, now, &read, news(tag, round.antenna, place));
    redraw_if_few(read.tag, tag);
  }
  if (!options_.non_detections) return;
  for (auto& [name, tag] : tags_) {
    if (!answered.contains(name)) take_silence(tag, now);
  }
  past_.push_back(now);
}

TagBelief TagMapper::belief(std::string_view name) const {
  const auto found = tags_.find(name);
  if (found == tags_.end()) return {std::string(name), {}, {}};
  const Tag& tag = found->second;
  TagBelief belief{std::string(name), {}, {}};
  const double most = *std::max_element(tag.log_weights.begin(), tag.log_weights.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < tag.x.size(); ++i) {
    belief.positions.emplace_back(tag.x[i], tag.y[i]);
    belief.weights.push_back(std::exp(tag.log_weights[i] - most));
    sum += belief.weights.back();
  }
  for (double& weight : belief.weights) weight /= sum;
  return belief;
}

std::vector<TagBelief> TagMapper::beliefs() const {
  std::vector<TagBelief> beliefs;
  for (const auto& [name, tag] : tags_) beliefs.push_back(belief(name));
  return beliefs;
}

int TagMapper::detections(std::string_view name) const {
  const auto found = tags_.find(name);
  return found == tags_.end() ? 0 : found->second.detections;
}

}  // namespace mapbed
