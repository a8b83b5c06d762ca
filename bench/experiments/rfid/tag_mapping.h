#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Section 7.5.1: a robot that knows its path maps the tags that its antennas hear.
Experiment tag_mapping_experiment();

}  // namespace mapbed
