#pragma once

#include <string_view>

namespace mapbed {

// Whether a text has the lines of a trajectory (core/geometry/tum_file.h), by the first that is no
// comment: pose lines have four or eight numbers; the lines of every log have more, or begin with
// a word.
bool holds_pose_lines(std::string_view text);

}  // namespace mapbed
