#pragma once

#include <string>

#include "core/log/log_file.h"

// CARMEN logs, one message a line:
//
//   FLASER n r… x y theta odom_x odom_y odom_theta ipc_stamp host logger_stamp      RLASER likewise
//   ROBOTLASER1 type start fov step max accuracy remission_mode n r… m remission… laser_x laser_y
//     laser_theta robot_x robot_y robot_theta tv rv forward_safety side_safety turn_axis
//     ipc_stamp host logger_stamp             ROBOTLASER2, ROBOTLASER3, … of the other lasers
//   RAWLASER1 type … remission… ipc_stamp host logger_stamp     used where no other laser line is
//   ODOM x y theta tv rv acceleration ipc_stamp host logger_stamp
//   TRUEPOS true_x true_y true_theta odom_x odom_y odom_theta ipc_stamp host logger_stamp
//   PARAM name value…
//
// A laser line gives an Odometry and a LaserScan of the same stamp. FLASER's first pose is ignored:
// in corrected logs it is not what the robot measured. Lines of two lasers that say the very same
// odometry, stamp included, give it once. '#' begins a comment. Messages of other kinds are skipped
// and counted. A stamp of 0 among later ones is no stamp: the line takes the other stamp that it
// has, else that of the line before.
//
// What CARMEN's lines have no place for stands in lines of our own, which other readers skip:
//
//   LASERMOUNT laser z pitch roll beam_period ipc_stamp host logger_stamp
//   RFIDMOUNT antenna x y theta z pitch roll ipc_stamp host logger_stamp
//   RFID antenna frequency n tag rssi phase… ipc_stamp host logger_stamp
//
// LASERMOUNT is of the laser that ROBOTLASER<laser> is of, for its scans that follow; all 0 until
// the first one. RFID is one inventory round of an antenna of an RFID reader, whose mount stands in
// the RFIDMOUNT line before: frequency [Hz], 0 where it is not known; tags by names of one word,
// RSSI [dBm] and phase [rad], "nan" where they are not known.

namespace mapbed {

struct LogDialect;
LogDialect carmen_dialect();

// The same as text: ROBOTLASER lines, which keep geometry, velocities and remissions; RAWLASER
// lines for a log without odometry. A scan without odometry of its own stamp repeats the last one.
// Numbers have as many digits as it takes to read the same values back. LASERMOUNT lines stand
// where a scan's height, tilt or beam period is another one than before.
std::string carmen_text(const RecordedLog& log);

// What programs of before 2008 read: FLASER and RLASER lines, the lasers' geometry in PARAM lines.
// Throws InputError where a laser's geometry changes or does not lie symmetrically.
std::string old_carmen_text(const RecordedLog& log);

// Writes such a text, gzipped if the path ends in .gz.
enum class CarmenDialect { flaser, robotlaser };
void write_carmen_log(const std::string& path, const RecordedLog& log,
                      CarmenDialect dialect = CarmenDialect::robotlaser);

}  // namespace mapbed
