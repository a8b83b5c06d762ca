#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/rfid/detection_table.h"
#include "algorithms/rfid/learned_rfid.h"
#include "algorithms/rfid/line_of_sight.h"
#include "algorithms/tag_belief.h"
#include "core/config/option.h"
#include "core/random.h"
#include "core/sensor/rfid_detections.h"

namespace mapbed {

struct TagMapperOptions {
  int positions = 1000;  // that each tag may be at
  double side = 0.0;  // [m] of the square about the robot that they are drawn from; 0: twice as far
                      // as a tag answers in every second round, and a margin
  double margin = 1.0;          // [m] of that
  bool non_detections = false;  // rounds in which a tag does not answer count, too
  bool rssi = false;            // and how strong its answers are
  // Effective number of positions, as a fraction, below which they are drawn anew about those that
  // are left, each time nearer. 0: never, as in section 7.3.
  double redraw_below = 0.0;
  // [m] that an antenna moves until its next reading is a new one: what fades at a place fades
  // there again. Until then readings count as one together. 0: all count, as in (7.1).
  double news_distance = 0.0;
};

template <class Visitor>
void visit_fields(TagMapperOptions& o, Visitor&& visit) {
  visit("positions", o.positions, between(1, 1'000'000), "that each tag may be at");
  visit("side", o.side, Unit::meter, between(0.0, 1000.0),
        "of the square about the robot that they are drawn from; 0: as far as antennas reach");
  visit("margin", o.margin, Unit::meter, between(0.0, 100.0), "beyond their reach");
  visit("non_detections", o.non_detections, "rounds in which a tag does not answer count, too");
  visit("rssi", o.rssi, "how strong its answers are counts, too");
  visit("redraw_below", o.redraw_below, kFraction,
        "effective number of positions, as a fraction, below which they are drawn anew; 0: never");
  visit("news_distance", o.news_distance, Unit::meter, between(0.0, 10.0),
        "that an antenna moves until its next reading is a new one; 0: all count");
}

// The posterior over each tag's place, (7.1), along a known path: positions drawn once, about where
// the robot first heard the tag, and weighted by every reading.
class TagMapper {
 public:
  // Where a map is given, silence says nothing of what is behind walls of it. Throws InputError
  // where `options` ask for what the model did not learn.
  TagMapper(const LearnedRfid& model, const TagMapperOptions& options, const Rng& rng,
            std::shared_ptr<const OccupancyMap> map = nullptr);

  // In order of time. Throws InputError for an antenna that the model does not know.
  void add(const RfidDetections& round, const Pose2& map_from_robot);

  std::vector<TagBelief> beliefs() const;  // by the tags' names
  TagBelief belief(std::string_view tag) const;
  int detections(std::string_view tag) const;  // 0: never heard of

 private:
  struct Tag {
    Eigen::Vector2d middle;   // [m] of the box about all positions
    double extent = 0.0;      // [m] they lie within it
    std::vector<float> x, y;  // [m]
    std::vector<double> log_weights;
    int detections = 0;
    double spacing = 0.0;  // [m] of neighbouring positions
    std::uint64_t redrawn = 0;
    std::map<int, Eigen::Vector2d> newest;  // by antenna: where its last reading that was news was
    std::map<int, double> pooled;           // by antenna: how many readings from about there
  };

  // Of one antenna.
  struct PastRound {
    int antenna = 0;
    Pose2 map_from_antenna;
    std::shared_ptr<const LineOfSight> sight;  // null: no map is given
  };

  Tag make_tag(const std::string& name, const Eigen::Vector2d& robot) const;
  bool may_hear(const Tag& tag, int antenna, const Eigen::Vector2d& place) const;
  void take_silence(Tag& tag, const PastRound& round) const;
  static void take_note_of_extent(Tag& tag);
  void redraw_if_few(const std::string& name, Tag& tag) const;
  double news(Tag& tag, int antenna, const Eigen::Vector2d& place) const;
  std::shared_ptr<const LineOfSight> sight_from(const Eigen::Vector2d& place);
  void take(Tag& tag, const PastRound& round, const RfidRead* read, double weight) const;

  TagMapperOptions options_;
  Rng rng_;
  std::vector<DetectionTable> tables_;
  double side_ = 0.0;
  std::shared_ptr<const OccupancyMap> map_;
  std::shared_ptr<const LineOfSight> sight_;  // the newest one
  std::map<std::string, Tag, std::less<>> tags_;
  std::vector<PastRound> past_;  // of all antennas; none where silence does not count
};

}  // namespace mapbed
