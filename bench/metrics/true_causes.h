#pragma once

#include <optional>
#include <set>
#include <vector>

#include "core/sensor/laser_scan.h"
#include "sim/truth/truth.h"

namespace mapbed {

// What truly made a beam's reading, by what a map should make of it.
enum class Cause : int {
  none,     // nothing was met, nobody knows, or the reading is far from what the beam met
  place,    // what can never move
  moving,   // what moves in this recording, while it does
  waiting,  // the same, while it does not
  resting,  // what could move and never does: a crowd that stands, a door that stays as it is
};

struct BeamCause {
  Cause cause = Cause::none;
  EntityKind kind = EntityKind::structure;
  int entity = -1;  // that the beam met
};

// What a scan is fused of, or itself as the one part.
std::vector<ScanPart> parts_of(const LaserScan& scan);

// Causes of readings by the truth of a simulated recording. It must outlive this.
class TrueCauses {
 public:
  // A reading that is farther than `most_off` [m] from what the beam's axis met is noise, or was
  // mixed of two things.
  explicit TrueCauses(const Truth& truth, double most_off = 0.3);

  // One for each beam of a scan, also of one that is fused.
  std::vector<BeamCause> of(const LaserScan& scan) const;

 private:
  BeamCause of(const BeamTruth& beam, double range) const;

  const Truth& truth_;
  double most_off_;
  std::set<int> movers_;  // entities of which a part is at places far enough apart
};

}  // namespace mapbed
