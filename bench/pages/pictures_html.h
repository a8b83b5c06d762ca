#pragma once

#include <string>

#include "bench/results/result_folder.h"

namespace mapbed {

// The pictures of a result as parts of its page; empty where it has none.
std::string figures_html(const ResultFolder& result);
std::string maps_html(const ResultFolder& result);
std::string replays_html(const ResultFolder& result);  // with their controls; throws InputError

}  // namespace mapbed
