#pragma once

#include "algorithms/methods.h"

namespace mapbed {

// `localization`: Monte Carlo localisation in a map that is given, by scans, by RFID tags that are
// given too, or by both.
Method localization_method();

}  // namespace mapbed
