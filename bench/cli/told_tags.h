#pragma once

#include <string>
#include <vector>

#include "algorithms/grid/occupancy_map.h"
#include "algorithms/remark.h"
#include "algorithms/tag_belief.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// Where tags are, from a file (tags_file.h), for a robot on a map. Throws InputError where the file
// is none, or all of its tags lie off the map.
std::vector<TagBelief> tags_on_map(const std::string& path, const OccupancyMap& map);

// Throws InputError where the log has no round of an RFID reader.
void check_has_rounds(const std::string& log_path, const SensorLog& log);

// What the user should know of tags and of who answers in the log: tags of the file that nobody
// hears, answers of tags that the file does not know.
std::vector<Remark> remarks_on_tags(const std::string& path, const std::vector<TagBelief>& tags,
                                    const SensorLog& log);

}  // namespace mapbed
