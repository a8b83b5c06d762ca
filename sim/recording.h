#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "sim/sensors/ideal_reading.h"
#include "sim/truth/truth.h"

namespace mapbed {

// How a drive ended.
struct RecordingEnd {
  bool is_complete = false;  // the driver was done; false: the longest time was over, or ...
  std::string stuck;         // ... the robot got stuck: when, where and by what; else empty
};

// A drive without noise, and what was true during it. Noise is drawn afterwards, as often and as
// strong as wanted (sim/noise/sensor_noise.h): the world is rendered once.
struct Recording {
  std::vector<IdealReading> readings;  // by time; odometry of a scan's stamp comes before it
  Truth truth;
  RecordingEnd end;
};

// Who takes a recording as it grows, each kind by time.
struct RecordingSink {
  std::function<void(IdealReading&&)> reading = {};
  std::function<void(StampedStates&&)> states = {};
  std::function<void(BeamTruthOfScan&&)> beams = {};
};

// [bytes] of a recording and its log; maps need memory besides.
inline constexpr std::size_t kMostRecorded = 1'500'000'000;

// Keeps everything in memory: in `recording`, which must outlive the sink. InputError where that
// gets more than `max_bytes`: an hour of a scanner of 180 beams, ten times a second, fits.
RecordingSink sink_into(Recording& recording, std::size_t max_bytes = kMostRecorded);

}  // namespace mapbed
