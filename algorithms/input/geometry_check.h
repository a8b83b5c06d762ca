#pragma once

#include <vector>

#include "algorithms/remark.h"
#include "core/log/log_file.h"

namespace mapbed {

// Where a log leaves several bearings of a laser possible, its scans and odometry choose; where
// they cannot, the first guess stays and a remark says so.
//
// Compares a hundred pairs of scans, see scan_agreement.h: a few milliseconds, however long the
// log.
std::vector<Remark> choose_geometry(RecordedLog& log);

// What a log states is never changed, but a remark tells where scans clearly contradict it: beams
// that run the other way round (the laser hangs upside down), a laser that looks backwards, a step
// that is twice too large or too small.
std::vector<Remark> remarks_on_geometry(const SensorLog& log);

}  // namespace mapbed
