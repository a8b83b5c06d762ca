#pragma once

#include <string_view>

// The files below page/, built into the program.

namespace mapbed {

std::string_view page_style();     // page.css
std::string_view page_script();    // page.js
std::string_view replay_script();  // replay.js

}  // namespace mapbed
