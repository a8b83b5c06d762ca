#pragma once

#include <string>

#include "core/labels/beam_labels.h"
#include "core/labels/tracks.h"

namespace mapbed {

// How many there are, how long they are followed, and how many of them seem to be one that was lost
// and found again under another number.
std::string text_of_tracks(const Tracks& tracks);

std::string text_of_labels(const BeamLabels& labels);

}  // namespace mapbed
