#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Reads of tags at places that were measured: how strong are answers from places held out, and
// where are the tags that answer so?
Experiment rfid_reads_experiment();

}  // namespace mapbed
