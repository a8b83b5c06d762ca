#include "bench/experiments/rfid/tag_path.h"

#include "algorithms/input/input_stage.h"
#include "bench/methods/method_run.h"
#include "bench/metrics/trajectory_error.h"
#include "bench/sources/shared_work.h"

namespace mapbed {
namespace {

TagPath aligned(Trajectory map_from_robot, const Trajectory& truth) {
  TagPath path;
  const std::vector<PosePair> pairs = associated(truth, map_from_robot);
  const Pose2 world_from_map = alignment(pairs);
  path.error = absolute_error(pairs, world_from_map).translation.rmse;
  path.world_from_robot = std::move(map_from_robot);
  for (Stamped<Pose2>& pose : path.world_from_robot) pose.pose = world_from_map * pose.pose;
  return path;
}

TagPath found_path(const ChosenMethod& method, const RunInput& input, const LogInput& drive) {
  const SensorLog log = prepared(drive.log, {}).log;
  // By the seed alone: runs that differ in what they make of the path have the same one.
  const MethodRun run = run_method(method, {.as_recorded = drive.log,
                                            .prepared = log,
                                            .rng = Rng(input.seed).stream("path of tags"),
                                            .seed = input.seed,
                                            .goes_on = input.goes_on});
  return aligned(run.estimate.trajectory, drive.truth);
}

}  // namespace

TagPath tag_path(const std::string& estimator, const ChosenMethod& method, const RunInput& input,
                 const LogInput& drive) {
  if (estimator == kTruePath) return {drive.truth, 0.0};
  const auto find = [&] { return found_path(method, input, drive); };
  if (drive.shared == nullptr) return find();
  const std::string key = "path of tags: " + method.name + "\n" + method.complete_yaml;
  return drive.shared->once<TagPath>(key, find);
}

}  // namespace mapbed
