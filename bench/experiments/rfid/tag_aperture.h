#pragma once

#include <map>
#include <string>
#include <vector>

#include "algorithms/rfid/synthetic_aperture.h"
#include "algorithms/tag_belief.h"
#include "bench/experiments/rfid/posed_rounds.h"
#include "core/config/option.h"

namespace mapbed {

struct TagApertureOptions {
  double spacing = 0.05;      // [m] between reads
  double step = 0.04;         // [m] of the search
  double about = 1.0;         // [m] that is searched about the most likely position
  double low = 0.3;           // [m] least height of a tag over the floor
  double high = 2.0;          // [m] largest
  double reads_within = 3.0;  // [m] of it: reads from farther away are reflections more often
  int most_reads = 200;       // that are nearest
};

template <class Visitor>
void visit_fields(TagApertureOptions& o, Visitor&& visit) {
  visit("spacing", o.spacing, Unit::meter, between(0.001, 1.0), "between reads of one antenna");
  visit("step", o.step, Unit::meter, between(0.01, 1.0), "of the search");
  visit("about", o.about, Unit::meter, between(0.0, 20.0),
        "that is searched about the most likely position");
  visit("low", o.low, Unit::meter, between(0.0, 100.0), "least height of a tag");
  visit("high", o.high, Unit::meter, between(0.0, 100.0), "largest height of a tag");
  visit("reads_within", o.reads_within, Unit::meter, between(0.1, 100.0),
        "of that position: those from farther away are reflections more often");
  visit("most_reads", o.most_reads, between(1, 1'000'000), "that are used, the nearest ones");
}

// Where the phases of each tag's answers agree best, about where it is believed to be.
std::map<std::string, Eigen::Vector2d> by_phases(const std::vector<TagBelief>& beliefs,
                                                 const std::vector<PosedRound>& rounds,
                                                 const TagApertureOptions& options);

}  // namespace mapbed
