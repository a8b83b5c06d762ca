#pragma once

#include <string>

namespace mapbed {

struct RecordedLog;

// Logs of the Mobile Robot Programming Toolkit (MRPT), as its icp-slam and rbpf-slam read them: for
// each scan an action, how odometry moved since the scan before (none: it did not), and a frame
// with the scan. Objects are written as versions that every MRPT since 1.0 reads.
//
// Stamps are kept to 0.1 us, ranges as floats. A beam that failed or saw nothing is marked as no
// measurement. As MRPT's scans lie symmetrically about their sensor, a scan that does not is told
// with the sensor turned.
std::string rawlog_bytes(const RecordedLog& log);
void write_rawlog(const std::string& path, const RecordedLog& log);

}  // namespace mapbed
