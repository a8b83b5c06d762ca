#pragma once

#include <string>
#include <vector>

#include "bench/pages/reported_results.h"

namespace mapbed {

// A picture of a result, as far as its file is there.
struct Picture {
  std::string path;   // below the result's folder: "figures/error.svg"
  std::string title;  // "Error over noise", "map"
  std::string run;    // of a single run: "people 3, raw"
};

std::string caption_of(const Picture& picture);  // "map, people 3, raw"

// The scenario's own plots, in its order, then those of single runs as people sort them.
std::vector<Picture> figures_of(const ReportedResults& reported);

// Of a picture's file.
std::string content_of(const ReportedResults& reported, const Picture& picture);

// The pictures of a result as parts of its page; empty where it has none.
std::string figures_html(const ReportedResults& reported);
std::string maps_html(const ReportedResults& reported);
// One viewer in which the run is chosen; what runs have in common stands in it once. Throws
// InputError.
std::string replays_html(const ReportedResults& reported);

}  // namespace mapbed
