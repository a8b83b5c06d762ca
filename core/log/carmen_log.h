#pragma once

#include <memory>
#include <string>

#include "core/log/log_builder.h"

// CARMEN logs, one message a line:
//
//   FLASER n r… x y theta odom_x odom_y odom_theta ipc_stamp host logger_stamp      RLASER likewise
//   ROBOTLASER1 type start fov step max accuracy remission_mode n r… m remission… laser_x laser_y
//     laser_theta robot_x robot_y robot_theta tv rv forward_safety side_safety turn_axis
//     ipc_stamp host logger_stamp                                               ROBOTLASER2
//     likewise
//   ODOM x y theta tv rv acceleration ipc_stamp host logger_stamp
//   TRUEPOS true_x true_y true_theta odom_x odom_y odom_theta ipc_stamp host logger_stamp
//   PARAM name value…
//
// A laser line gives an Odometry and a LaserScan of the same stamp. FLASER's first pose is ignored:
// in corrected logs it is not what the robot measured. '#' begins a comment. Messages of other
// kinds are skipped and counted. A stamp of 0 among later ones is no stamp: the line takes the
// other stamp that it has, else that of the line before.

namespace mapbed {

std::unique_ptr<LogReader> make_carmen_reader(const std::string& name, const LogOptions& options);

}  // namespace mapbed
