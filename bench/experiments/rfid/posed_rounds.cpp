#include "bench/experiments/rfid/posed_rounds.h"

#include <algorithm>

#include "core/input_error.h"

namespace mapbed {

std::vector<PosedRound> posed_rounds(const SensorLog& log, const Trajectory& map_from_robot) {
  std::vector<PosedRound> rounds;
  for (const Measurement& measurement : log) {
    const auto* round = std::get_if<RfidDetections>(&measurement);
    if (round == nullptr) continue;
    const std::optional<Pose2> pose = pose_at(map_from_robot, round->time);
    if (pose) rounds.push_back({round, *pose});
  }
  return rounds;
}

int antennas_in(const SensorLog& log) {
  int antennas = 0;
  for (const Measurement& measurement : log) {
    const auto* round = std::get_if<RfidDetections>(&measurement);
    if (round != nullptr) antennas = std::max(antennas, round->antenna + 1);
  }
  if (antennas > 0) return antennas;
  throw InputError({}, "the log has no rounds of an RFID reader",
                   "choose a robot with antennas, as pioneer_rfid");
}

}  // namespace mapbed
