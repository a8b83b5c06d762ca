#include "bench/metrics/true_causes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>

namespace mapbed {
namespace {

constexpr double kMoves = 0.3;  // [m] of a part, from its first place: more than swaying

std::set<int> movers_in(const Truth& truth) {
  std::map<std::pair<int, int>, Eigen::AlignedBox3d> places;  // by entity and part
  for (const StampedStates& states : truth.states) {
    for (const MovingPose& pose : states.moving) {
      places[{pose.entity, pose.part}].extend(pose.world_from_part.position);
    }
  }
  std::set<int> movers;
  for (const auto& [part, box] : places) {
    if (box.diagonal().norm() > kMoves) movers.insert(part.first);
  }
  return movers;
}

}  // namespace

std::vector<ScanPart> parts_of(const LaserScan& scan) {
  if (!scan.parts.empty()) return scan.parts;
  return {{scan.time, scan.laser, scan.ranges.size()}};
}

TrueCauses::TrueCauses(const Truth& truth, double most_off)
    : truth_(truth), most_off_(most_off), movers_(movers_in(truth)) {}

BeamCause TrueCauses::of(const BeamTruth& beam, double range) const {
  const bool is_told = beam.entity >= 0 &&
                       static_cast<std::size_t>(beam.entity) < truth_.entities.size() &&
                       std::abs(static_cast<double>(beam.range) - range) <= most_off_;
  if (!is_told) return {};
  const TruthEntity& entity = truth_.entities[static_cast<std::size_t>(beam.entity)];
  if (!entity.is_dynamic()) return {Cause::place, entity.kind, entity.id};
  if (!movers_.contains(entity.id)) return {Cause::resting, entity.kind, entity.id};
  return {beam.motion == Motion::moving ? Cause::moving : Cause::waiting, entity.kind, entity.id};
}

std::vector<BeamCause> TrueCauses::of(const LaserScan& scan) const {
  std::vector<BeamCause> causes(scan.ranges.size());
  std::size_t first = 0;
  for (const ScanPart& part : parts_of(scan)) {
    const BeamTruthOfScan* truth = beams_of(truth_, part.time, part.laser);
    for (std::size_t n = 0; truth != nullptr && n < std::min(part.beams, truth->beams.size());
         ++n) {
      if (scan.is_hit(first + n)) causes[first + n] = of(truth->beams[n], scan.ranges[first + n]);
    }
    first += part.beams;
  }
  return causes;
}

}  // namespace mapbed
