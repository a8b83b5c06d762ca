#pragma once

namespace mapbed {

// A stretch of a log, both ends included.
struct TimeInterval {
  double from = 0.0;  // [s] stamps of the log
  double to = 0.0;    // [s]
  friend bool operator==(const TimeInterval&, const TimeInterval&) = default;
};

}  // namespace mapbed
