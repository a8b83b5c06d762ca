#pragma once

#include <string>
#include <vector>

#include "algorithms/motion/motion_model.h"
#include "core/config/settings.h"
#include "core/file/input_file.h"

namespace mapbed {

// Section 5.3: the parameters of a motion model learned from motions whose true ones are known, or
// taken from a reference.
struct MotionSample {
  Pose2 measured;   // by odometry, or by scan matching
  Pose2 reference;  // how the robot moved meanwhile
};

// Mean ln p(reference | measured) under the model's Gaussian (gaussian_after), normalisation
// included. Not for an empty list.
double mean_log_likelihood(const std::vector<MotionSample>& samples,
                           const MotionModelOptions& model);

// The biases by regression, and with them the sigmas of greatest likelihood: a pattern search from
// `start` over their logarithms, finer and finer. Finds a local maximum. A sigma that the samples
// give no reason for ends at its least value (0.1 mm, 0.1 mrad).
MotionModelOptions learned_motion_model(const std::vector<MotionSample>& samples,
                                        const MotionModelOptions& start = {});

// Whether errors are as large as a model says. A calibrated one has 1 and 0.95.
struct Calibration {
  // Mean normalised estimation error squared, e^T P e / 3: e error, P information of the motion.
  double nees = 0.0;
  double coverage = 0.0;  // fraction of the samples within the model's 95 % ellipsoid
};
Calibration calibration_of(const std::vector<MotionSample>& samples,
                           const MotionModelOptions& model);

// The autocorrelation: how much of one motion's error the next one repeats, the correlation of
// successive errors, each in units of the model's sigma. 0 for independent ones; samples in order
// of time, two at least.
double autocorrelation_of(const std::vector<MotionSample>& samples,
                          const MotionModelOptions& model);

// A parameter file, by its name in algorithms/motion/motion_models or by its path. Throws
// InputError.
MotionModelOptions load_motion_model(const std::string& name_or_path);

InputFile motion_model_file(const std::string& name_or_path);  // throws InputError

// Settings of a filter, with its error models by name taken from their files: what stands there as
// `odometry_errors: pioneer_odometry` becomes a setting of each parameter. Throws InputError.
Settings with_learned_models(const Settings& settings);

InputFiles learned_model_files(const Settings& settings);  // that are named so

}  // namespace mapbed
