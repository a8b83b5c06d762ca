#pragma once

#include <string>
#include <vector>

#include "core/config/settings.h"
#include "core/log/log_file.h"

// A recorded log by name: a YAML file that says where a log comes from, what its bytes are, and
// what the log itself does not say of its sensors.
//
//   about: Intel Research Lab, Seattle, recorded by Dirk Haehnel
//   file: intel/intel_rawodom.clf.gz     under the folder MAPBED_DATA, or beside this file
//   sha256: 0f…                          of the file as it is stored
//   source: …                            who recorded it, and where it was published
//   licence: …
//   fetch: …                             how to get the file
//   robot: …
//   laser: …
//   pieces: [ … ]                        where it was rebuilt: from which public files
//   log: {robot_from_laser: [0.78, 0, 0]}   options of log_options.h that differ

namespace mapbed {

struct LogDescription {
  std::string yaml_path;
  std::string about;
  std::string file;
  std::string sha256;
  std::string source;
  std::string licence;
  std::string fetch;
  std::string robot;
  std::string laser;
  std::vector<std::string> pieces;
  LogOptions options;
};

// Throws InputError for a file that is none, or lacks any of the fields above but pieces and log.
LogDescription load_log_description(const std::string& yaml_path);

// Where the log is: $MAPBED_DATA/<file>, or <file> beside the YAML file. Throws InputError where it
// is in neither place, with the way to get it, or where its checksum is another one.
std::string find_log(const LogDescription& description);

// A log by the path of the log itself or, where that ends in .yaml, of its description, whose
// options `settings` can still override.
RecordedLog open_log(const std::string& path, const Settings& settings = {});

}  // namespace mapbed
