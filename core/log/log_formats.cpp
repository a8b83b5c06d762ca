#include "core/log/log_formats.h"

#include <vector>

#include "core/config/suggestion.h"
#include "core/log/bags/bag_writer.h"
#include "core/log/dialects/carmen_log.h"
#include "core/log/dialects/rawlog.h"

namespace mapbed {

std::span<const LogFormat> log_formats() {
  static const LogFormat table[] = {
      {"carmen", ".log", "CARMEN: ROBOTLASER and ODOM lines",
       [](const std::string& path, const RecordedLog& log) { write_carmen_log(path, log); }, false,
       true},
      {"carmen_flaser", ".log", "CARMEN of before 2008: FLASER, RLASER and ODOM lines",
       [](const std::string& path, const RecordedLog& log) {
         write_carmen_log(path, log, CarmenDialect::flaser);
       },
       false, true},
      {"rawlog", ".rawlog", "MRPT: an action and a sensory frame for each scan", write_rawlog},
      {"ros1", ".bag", "bag of ROS 1: LaserScan, Odometry, tf", write_rosbag1},
      {"ros2", "", "bag of ROS 2, a folder: the same, in SQLite", write_rosbag2, true},
      {"mcap", ".mcap", "MCAP: the same, as ROS 2 and Foxglove read it", write_mcap},
  };
  return table;
}

const LogFormat& log_format_by_name(const std::string& name, const SourceLocation& place) {
  std::vector<std::string> names;
  for (const LogFormat& format : log_formats()) {
    if (format.name == name) return format;
    names.emplace_back(format.name);
  }
  throw InputError(place, "unknown format of logs " + in_quotes(name), suggestion(name, names));
}

const LogFormat& log_format_of_path(const std::string& path) {
  if (path.ends_with(".db3"))
    throw InputError({path}, "is one file of a bag of ROS 2, which is a folder",
                     "write it by --format ros2 into a folder");
  for (const LogFormat& format : log_formats())
    if (!format.is_folder && path.ends_with(format.extension)) return format;
  return log_formats().front();
}

}  // namespace mapbed
