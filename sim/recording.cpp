#include "sim/recording.h"

#include <utility>

namespace mapbed {

RecordingSink sink_into(Recording& recording) {
  return {.reading = [&](IdealReading&& r) { recording.readings.push_back(std::move(r)); },
          .states = [&](StampedStates&& s) { recording.truth.states.push_back(std::move(s)); },
          .beams = [&](BeamTruthOfScan&& b) { recording.truth.beams.push_back(std::move(b)); }};
}

}  // namespace mapbed
