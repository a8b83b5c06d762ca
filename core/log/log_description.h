#pragma once

#include <string>
#include <vector>

#include "core/config/settings.h"
#include "core/file/input_file.h"
#include "core/log/log_file.h"

// A recorded log by name: a YAML file that says where a log comes from, what its bytes are, and
// what the log itself does not say of its sensors.
//
//   about: Intel Research Lab, Seattle, recorded by Dirk Haehnel
//   file: intel/intel_rawodom.clf.gz     under the folder MAPBED_DATA, or beside this file
//   sha256: 0f…                          of the file as it is stored
//   source: …                            who recorded it, and where it was published
//   licence: …
//   fetch: …                             how to get the file; for `mapbed fetch`: public_log.h
//   robot: …
//   laser: …
//   pieces: [ … ]                        where it was rebuilt: from which public files
//   log: {robot_from_laser: [0.78, 0, 0]}   options of log_options.h that differ
//   relations:      where people measured how the robot moved between stamps (Kümmerle et al. 2009)
//     file: intel/intel.relations.gz
//     sha256: 1c…
//     odometry: {file: …, sha256: …}   poses that reach the stamps between scans; none: linearly
//   reference: {file: …, sha256: …}    where nobody did: a path found by another program

namespace mapbed {

struct StoredFile {
  std::string file;    // below the data folder; empty: there is none
  std::string sha256;  // of the file as it is stored
};

struct LogDescription {
  std::string yaml_path;
  std::string about;
  StoredFile log;
  std::string source;
  std::string licence;
  std::string fetch;
  std::string robot;
  std::string laser;
  std::vector<std::string> pieces;
  LogOptions options;
  StoredFile relations;
  StoredFile relations_odometry;
  StoredFile reference;
};

// Throws InputError for a file that is none, or lacks any of the fields above but pieces, log,
// relations and reference.
LogDescription load_log_description(const std::string& yaml_path);

// Its files: the log, then what there is of relations, their odometry, and the reference.
std::vector<const StoredFile*> stored_files(const LogDescription& description);

// Whether `mapbed fetch` can make all of them.
bool can_be_fetched(const LogDescription& description);

// Whether the file at this path, of this SHA-256, is the one that is described: by its bytes or,
// where it was packed by another program, by what it unpacks to.
bool is_described(const InputFile& file, const LogDescription& description,
                  const StoredFile& stored);

// Where a file of the description is: $MAPBED_DATA/<file>, or <file> beside the YAML file. Throws
// InputError where it is in neither place, with the way to get it, or where it is another one.
InputFile find_stored(const LogDescription& description, const StoredFile& stored,
                      HashedFiles& files);

// Whether all its files are in one of these places; says nothing of their checksums.
bool is_here(const LogDescription& description);

// A log by the path of the log itself or, where that ends in .yaml, of its description, whose
// options `settings` can still override.
RecordedLog open_log(const std::string& path, const Settings& settings = {});

}  // namespace mapbed
