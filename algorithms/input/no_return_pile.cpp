#include "algorithms/input/no_return_pile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include <fmt/format.h>

namespace mapbed {
namespace {

constexpr std::size_t kBands = 4;       // below the maximum range, the uppermost first
constexpr double kLeastBand = 0.05;     // [m] several sigma of most lasers
constexpr double kRelativeBand = 0.01;  // of the maximum range, where that is more
constexpr double kHigher = 8.0;         // times the readings in a band below, in the mean
constexpr std::size_t kLeastScans = 20;
constexpr double kApart = 0.1;  // [m], [rad] between scans that count

struct Census {
  double max_range = 0.0;  // [m] of the first scan
  std::size_t scans = 0, readings = 0;
  std::size_t scans_with_pile = 0;
  std::optional<Pose2> odometry;  // odometry_from_robot at the last scan that was counted
  std::array<std::size_t, kBands> bands{};

  double band() const { return std::max(kLeastBand, kRelativeBand * max_range); }
};

void count(const LaserScan& scan, Census& census) {
  if (census.scans == 0) census.max_range = scan.max_range;
  if (scan.max_range != census.max_range) return;
  ++census.scans;
  const std::size_t before = census.bands[0];
  for (const double range : scan.ranges) {
    if (!(range > 0.0)) continue;
    ++census.readings;
    if (range >= census.max_range) continue;
    const double below = (census.max_range - range) / census.band();
    if (below < static_cast<double>(kBands)) ++census.bands[static_cast<std::size_t>(below)];
  }
  if (census.bands[0] > before) ++census.scans_with_pile;
}

// A robot that stands may have all the time a wall before it that is as far as its laser reaches.
bool has_moved(const std::optional<Pose2>& before, const std::optional<Pose2>& now) {
  if (!before || !now) return true;
  const Pose2 motion = motion_between(*before, *now);
  return std::hypot(motion.x, motion.y) >= kApart || std::abs(motion.theta) >= kApart;
}

bool has_pile(const Census& census, const NoReturnPileOptions& options) {
  if (census.scans < kLeastScans || 2 * census.scans_with_pile < census.scans) return false;
  const auto pile = static_cast<double>(census.bands[0]);
  const auto others = std::accumulate(census.bands.begin() + 1, census.bands.end(), std::size_t{0});
  const double next = static_cast<double>(others) / static_cast<double>(kBands - 1);
  return pile > options.fraction * static_cast<double>(census.readings) && pile > kHigher * next;
}

}  // namespace

std::map<int, NoReturnPile> no_return_piles(const SensorLog& log,
                                            const NoReturnPileOptions& options) {
  std::map<int, Census> lasers;
  std::optional<Pose2> odometry;
  for (const Measurement& measurement : log) {
    if (const auto* reading = std::get_if<Odometry>(&measurement)) {
      odometry = reading->odometry_from_robot;
    }
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || !has_moved(lasers[scan->laser].odometry, odometry)) continue;
    count(*scan, lasers[scan->laser]);
    lasers[scan->laser].odometry = odometry;
  }
  std::map<int, NoReturnPile> piles;
  for (const auto& [laser, census] : lasers) {
    if (!has_pile(census, options)) continue;
    piles[laser] = {census.max_range - census.band(), census.max_range,
                    static_cast<double>(census.bands[0]) / static_cast<double>(census.readings)};
  }
  return piles;
}

LaserScan without_pile(LaserScan scan, const std::map<int, NoReturnPile>& piles) {
  const auto found = piles.find(scan.laser);
  if (found == piles.end() || found->second.max_range != scan.max_range) return scan;
  for (double& range : scan.ranges) {
    if (range > found->second.from) range = std::max(range, scan.max_range);
  }
  return scan;
}

std::vector<Remark> remarks_on(const std::map<int, NoReturnPile>& piles) {
  std::vector<Remark> result;
  for (const auto& [laser, pile] : piles) {
    result.push_back(
        {RemarkKind::no_return,
         fmt::format(
             "{:.0f} % of the readings of laser {} pile up between {:.4g} m and its maximum "
             "range of {:.4g} m, as no surface makes: taken as no return, as with "
             "log.max_range={:.4g}m",
             100.0 * pile.fraction, laser, pile.from, pile.max_range, pile.from)});
  }
  return result;
}

}  // namespace mapbed
