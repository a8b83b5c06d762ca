#pragma once

#include <string>

namespace mapbed {

struct ScenarioPlan;

// config.yaml, beside the results of a scenario and a scenario itself:
//
//   scenario:    # what was planned: words, sweep, metrics, plots, claims
//   settings:    # of all runs, as they were given
//     world: office
//   compare:     # what differs in each variant, with what the command line gave
//     raw: {estimator: odometry}
//   files:       # that the runs were made of
//   runs:        # every option that held in each variant, at the first level of a sweep
//
// Run again, it gives the same results, this file included, wherever it was copied to: paths of
// files that are not the program's are whole ones. What stands under `runs` holds then instead of
// the defaults, which a later program may have changed; but not where the sweep or the command line
// chooses another world, robot, log, … than it is of, nor for several logs of one run.
// config_reader.h reads it.
std::string config_text(const ScenarioPlan& plan);

}  // namespace mapbed
