#pragma once

#include <string>

namespace mapbed {

// A world file with every key, what each means and what may stand there, as comments.
std::string world_file_form();

}  // namespace mapbed
