#include "algorithms/input/geometry_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "algorithms/input/scan_agreement.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr int kPairs = 100;
constexpr std::size_t kFewestBeams = 10;

// What a laser's beams could be instead.
struct Alternative {
  Bearings bearings;
  RemarkKind kind = RemarkKind::beam_geometry;
  std::string what;  // "the beams run the other way round"
};

Bearings mirrored(const Bearings& b) {
  return {-b.first, -b.step};
}

// Step times `factor`, about the same middle.
Bearings scaled(const Bearings& b, std::size_t beams, double factor) {
  const double middle = b.first + 0.5 * b.step * static_cast<double>(beams - 1);
  return {middle + factor * (b.first - middle), factor * b.step};
}

std::vector<Alternative> alternatives_of(const RecordedLaser& laser) {
  const Bearings& b = laser.bearings;
  const Bearings behind{normalized_angle(b.first + kPi), b.step};
  const char* const around = "its beams run the other way round, as if it hung upside down";
  std::vector<Alternative> all{
      {mirrored(b), RemarkKind::laser_mount, around},
      {behind, RemarkKind::laser_mount, "it looks backwards"},
      {mirrored(behind), RemarkKind::laser_mount, "it looks backwards and hangs upside down"},
      {scaled(b, laser.beams, 0.5), RemarkKind::beam_geometry, "its beams lie half as far apart"}};
  const double extent = 2.0 * std::abs(b.step) * static_cast<double>(laser.beams - 1);
  if (extent < 2.0 * kPi + std::abs(b.step))
    all.push_back({scaled(b, laser.beams, 2.0), RemarkKind::beam_geometry,
                   "its beams lie twice as far apart"});
  return all;
}

// The candidate that is clearly better than all others; 0 where there is none.
std::size_t clear_choice(const AgreementComparison& comparison) {
  const auto best = static_cast<std::size_t>(
      std::max_element(comparison.mean.begin(), comparison.mean.end()) - comparison.mean.begin());
  for (std::size_t other = 0; other < comparison.mean.size(); ++other)
    if (other != best && !is_clearly_better(comparison, best, other)) return 0;
  return best;
}

std::string percent(double fraction) {
  return fmt::format("{:.0f} %", 100.0 * fraction);
}

// Of what the log leaves open, mirrored too. False: the scans do not tell.
bool choose(RecordedLog& log, RecordedLaser& laser, const std::vector<ScanPair>& pairs) {
  std::vector<Bearings> candidates{laser.bearings};
  for (const Bearings& b : laser.candidates)
    if (!is_full_circle(b, laser.beams) || ends_meet(pairs)) candidates.push_back(b);
  const std::size_t upright = candidates.size();
  if (upright == 1) return true;
  for (std::size_t i = 1; i < upright; ++i) candidates.push_back(mirrored(candidates[i]));
  const AgreementComparison comparison = compare(pairs, candidates);
  const std::size_t best = clear_choice(comparison);
  if (best != 0) {
    set_bearings(log, laser, candidates[best],
                 fmt::format("chosen by comparing scans: {} of the beams fit, {} with {} of {}",
                             percent(comparison.mean[best]), percent(comparison.mean[0]),
                             to_string(candidates[0]), laser.source));
    return true;
  }
  for (std::size_t other = 1; other < candidates.size(); ++other)
    if (!is_clearly_better(comparison, 0, other)) return false;
  return true;
}

void contradict(const RecordedLaser& laser, const std::vector<ScanPair>& pairs,
                std::vector<Remark>& remarks) {
  const std::vector<Alternative> alternatives = alternatives_of(laser);
  std::vector<Bearings> candidates{laser.bearings};
  for (const Alternative& alternative : alternatives) candidates.push_back(alternative.bearings);
  const AgreementComparison comparison = compare(pairs, candidates);
  const std::size_t best = clear_choice(comparison);
  if (best == 0) return;
  remarks.push_back(
      {alternatives[best - 1].kind,
       fmt::format("the {} does not look where the log says: {} of the beams fit on those of scans "
                   "before, but {} if {}; if so, set log.first_bearing: "
                   "[{:.2f} deg] and log.bearing_step: {:.4f} deg",
                   name_of_laser(laser.laser), percent(comparison.mean[0]),
                   percent(comparison.mean[best]), alternatives[best - 1].what,
                   degrees(candidates[best].first), degrees(candidates[best].step))});
}

// As they look in most of their scans.
std::vector<RecordedLaser> lasers_in(const SensorLog& log) {
  std::map<int, std::map<std::size_t, std::pair<std::size_t, const LaserScan*>>> by_beams;
  for (const Measurement& m : log) {
    const auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr || scan->bearing_step == 0.0) continue;
    auto& [count, first] = by_beams[scan->laser][scan->ranges.size()];
    if (count++ == 0) first = scan;
  }
  std::vector<RecordedLaser> lasers;
  for (const auto& [laser, counts] : by_beams) {
    const auto most = std::max_element(counts.begin(), counts.end(), [](auto& a, auto& b) {
      return a.second.first < b.second.first;
    });
    const LaserScan& scan = *most->second.second;
    lasers.push_back({laser,
                      scan.ranges.size(),
                      {scan.first_bearing, scan.bearing_step},
                      scan.robot_from_laser.planar,
                      {}});
  }
  return lasers;
}

}  // namespace

std::vector<Remark> choose_geometry(RecordedLog& log) {
  std::vector<Remark> remarks;
  for (RecordedLaser& laser : log.lasers) {
    if (laser.beams < kFewestBeams || laser.candidates.empty()) continue;
    const auto pairs = scan_pairs(log.measurements, laser.laser, laser.beams, kPairs);
    if (choose(log, laser, pairs)) continue;
    remarks.push_back(
        {RemarkKind::note,
         fmt::format("where the {}'s {} beams point is ambiguous, and its scans do not tell: {} "
                     "is taken ({}); set log.field_of_view if it is another",
                     name_of_laser(laser.laser), laser.beams, to_string(laser.bearings),
                     laser.source)});
  }
  return remarks;
}

std::vector<Remark> remarks_on_geometry(const SensorLog& log) {
  std::vector<Remark> remarks;
  for (const RecordedLaser& laser : lasers_in(log)) {
    if (laser.beams < kFewestBeams) continue;
    contradict(laser, scan_pairs(log, laser.laser, laser.beams, kPairs), remarks);
  }
  return remarks;
}

}  // namespace mapbed
