#include "bench/experiments/end_points.h"
#include "bench/experiments/experiment.h"
#include "bench/experiments/false_loops/false_loops.h"
#include "bench/experiments/known_poses.h"
#include "bench/experiments/laser_readings.h"
#include "bench/experiments/learned_people.h"
#include "bench/experiments/localization.h"
#include "bench/experiments/log_faults.h"
#include "bench/experiments/matching_basin.h"
#include "bench/experiments/motion_models.h"
#include "bench/experiments/odds_vs_counting.h"
#include "bench/experiments/rfid/rfid_localization.h"
#include "bench/experiments/rfid/rfid_sensor_model.h"
#include "bench/experiments/rfid/tag_mapping.h"
#include "bench/experiments/rfid_reads/rfid_phase.h"
#include "bench/experiments/rfid_reads/rfid_reads.h"
#include "bench/experiments/slam.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> table{
      slam_experiment(),           odds_vs_counting_experiment(),  known_poses_experiment(),
      end_points_experiment(),     matching_basin_experiment(),    motion_models_experiment(),
      laser_readings_experiment(), log_faults_experiment(),        learned_people_experiment(),
      false_loops_experiment(),    localization_experiment(),      rfid_sensor_model_experiment(),
      tag_mapping_experiment(),    rfid_localization_experiment(), rfid_reads_experiment(),
      rfid_phase_experiment(),
  };
  return table;
}

std::string text_of(Experiment::Needs needs) {
  switch (needs) {
    case Experiment::Needs::nothing:
      return "nothing";
    case Experiment::Needs::log:
      return "a log";
    case Experiment::Needs::truth:
      return "a log with the true path";
    case Experiment::Needs::world:
      return "a log with its world";
  }
  return {};
}

const Experiment& experiment_by_name(const std::string& name, const SourceLocation& place) {
  std::vector<std::string> names;
  for (const Experiment& experiment : experiments()) {
    if (experiment.name == name) return experiment;
    names.push_back(experiment.name);
  }
  throw InputError(place, "unknown experiment '" + name + "'", suggestion(name, names));
}

}  // namespace mapbed
