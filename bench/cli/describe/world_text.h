#pragma once

#include <string>

namespace mapbed {

struct World;

// How large it is, the paths that a robot can be sent along, where people walk (by the names of
// rooms where there are such), and its doors.
std::string text_of_world(const World& world);

}  // namespace mapbed
