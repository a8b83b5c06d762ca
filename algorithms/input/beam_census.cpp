#include "algorithms/input/beam_census.h"

#include <fmt/format.h>

namespace mapbed {
namespace {

constexpr std::size_t kLeastScans = 20;
constexpr std::size_t kFewBeams = 40;  // of a scan: rooms have more corners than these show
constexpr double kManyFail = 0.2;      // of the beams

}  // namespace

void BeamCensus::add(const LaserScan& scan) {
  Count& count = lasers_[scan.laser];
  ++count.scans;
  count.beams += scan.ranges.size();
  bool before = false;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const bool fails = !(scan.ranges[beam] > 0.0);
    if (fails) ++count.failed;
    if (beam > 0 && fails != before) ++count.changes;
    before = fails;
  }
}

std::vector<Remark> BeamCensus::remarks() const {
  std::vector<Remark> result;
  for (const auto& [laser, count] : lasers_) {
    if (count.scans < kLeastScans || count.beams == 0) continue;
    const std::size_t beams = (count.beams + count.scans / 2) / count.scans;
    const double failed = static_cast<double>(count.failed) / static_cast<double>(count.beams);
    if (beams < kFewBeams) {
      result.push_back({RemarkKind::few_beams,
                        fmt::format("laser {} has {} beams a scan: too few to match scans safely",
                                    laser, beams)});
    }
    // Of beams that fail each by chance, f of them, 2 f (1 - f) neighbours differ.
    const double by_chance = 2.0 * failed * (1.0 - failed) * static_cast<double>(count.beams);
    if (failed >= kManyFail && static_cast<double>(count.changes) > 0.5 * by_chance) {
      result.push_back({RemarkKind::few_beams, fmt::format("{:.0f} % of the beams of laser {} fail",
                                                           100.0 * failed, laser)});
    }
  }
  return result;
}

}  // namespace mapbed
