#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/localization/particle_weights.h"
#include "algorithms/rfid/detection_table.h"
#include "algorithms/rfid/tag_visibility.h"
#include "algorithms/tag_belief.h"
#include "core/config/option.h"

namespace mapbed {

struct RfidWeightOptions {
  bool non_detections = true;  // tags that do not answer count, too
  bool rssi = false;           // and how strong answers are
  int positions = 20;          // of each tag's belief that are looked at, at most
};

template <class Visitor>
void visit_fields(RfidWeightOptions& o, Visitor&& visit) {
  visit("non_detections", o.non_detections, "tags that do not answer count, too");
  visit("rssi", o.rssi, "how strong answers are counts, too");
  visit("positions", o.positions, between(1, 10'000),
        "of each tag's belief that are looked at, at most");
}

// What the inventory rounds of one antenna say of particles, given where tags may be:
//
//   p(z | l) = sum over x of p(z | x, l) p(x | z_1:t, r_1:t)      (7.2)
//
// for each tag that answers and, where these count, for each that does not though the antenna has
// it in sight. Tags that nobody mapped say nothing. Rounds from one place repeat themselves: what
// fades there goes on fading.
class RfidWeights : public ParticleWeights {
 public:
  // The model of that antenna. Throws InputError where `options` ask for what it did not learn.
  RfidWeights(int antenna, const AntennaModel& model, const std::vector<TagBelief>& tags,
              const OccupancyMap& map, const RfidWeightOptions& options);

  bool take(const Measurement& measurement, std::span<const float> beam_weights) override;
  void add_log_weights(std::span<const Pose2> map_from_robot,
                       std::span<double> log_weights) const override;
  std::optional<Pose2> propose(Rng& rng) const override;
  std::optional<double> log_odds_of_map(const Pose2& map_from_robot) const override;

 private:
  // Where a tag may be, by few positions.
  struct Tag {
    std::vector<float> x, y;     // [m]
    std::vector<float> weights;  // they sum to 1
  };
  struct Answer {
    std::size_t tag = 0;
    float rssi = 0.0F;
    bool has_rssi = false;
  };

  Tag tag_of(const TagBelief& belief) const;
  double log_weight(const Pose2& map_from_robot) const;

  int antenna_;
  DetectionTable table_;
  double best_ = 0.0;  // largest probability of an answer
  RfidWeightOptions options_;
  std::vector<Tag> tags_;
  std::map<std::string, std::size_t, std::less<>> tag_of_name_;
  std::unique_ptr<const TagVisibility> visibility_;  // null where silence does not count

  Pose2 robot_from_antenna_;  // of the round that was taken
  std::vector<Answer> answers_;
  std::vector<bool> answered_;  // by tag
};

}  // namespace mapbed
