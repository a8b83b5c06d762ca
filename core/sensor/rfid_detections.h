#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/sensor/mount.h"

namespace mapbed {

// A tag that answered.
struct RfidRead {
  static constexpr double kNotTold = std::numeric_limits<double>::quiet_NaN();

  std::string tag;          // what it is called: "tag_017", or its EPC in hexadecimal; no blanks
  double rssi = kNotTold;   // [dBm] of its answer
  double phase = kNotTold;  // [rad] of its answer against the reader's carrier, in [0, 2 pi)

  bool has_rssi() const { return !std::isnan(rssi); }
  bool has_phase() const { return !std::isnan(phase); }
};

// One inventory round of one antenna of an RFID reader: who answered. Rounds without an answer are
// measurements, too.
struct RfidDetections {
  double time = 0.0;  // [s] the log's own stamp
  int antenna = 0;    // of the robot's antennas, from 0
  Mount robot_from_antenna;
  double frequency = 0.0;       // [Hz] of the carrier; 0: not told
  std::vector<RfidRead> reads;  // each tag once
};

}  // namespace mapbed
