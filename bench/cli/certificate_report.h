#pragma once

#include <string>

#include "algorithms/pose_graph/certificate.h"

namespace mapbed {

// One line without its end: what is certified of which problem, and how closely.
std::string certificate_text(const Certificate& certificate);

}  // namespace mapbed
