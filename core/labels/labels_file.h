#pragma once

#include <string>
#include <string_view>

#include "core/labels/beam_labels.h"

// Labels of beams as text, gzipped where the name ends in .gz; a line for each scan:
//
//   # MAPBED LABELS 1
//   time laser n p1 p2 ... pn
//
// where time is the scan's own stamp [s], laser its number as in the log (0 front, 1 rear), n the
// number of its beams, and p in whole percent how likely what the beam met belongs to the place and
// does not move; '-' for a beam that met nothing. '#' begins a comment.

namespace mapbed {

void write_labels(const std::string& path, const BeamLabels& labels_of_lasers);

// Throw InputError, with the line, for anything else.
BeamLabels load_labels(const std::string& path);
BeamLabels parse_labels(const std::string& name, std::string_view text);

}  // namespace mapbed
