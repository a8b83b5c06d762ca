#include "core/labels/beam_labels.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/check.h"

namespace mapbed {
namespace {

void append_parts(const ScanLabels& whole, const LaserScan& scan, BeamLabels& labels) {
  CHECK(whole.static_probability.size() == scan.ranges.size());
  auto from = whole.static_probability.begin();
  for (const ScanPart& part : scan.parts) {
    const auto to = from + static_cast<std::ptrdiff_t>(part.beams);
    labels.push_back({part.time, part.laser, {from, to}});
    from = to;
  }
  CHECK(from == whole.static_probability.end());
}

}  // namespace

BeamLabels labels_of_lasers(const BeamLabels& labels, const SensorLog& log) {
  BeamLabels result;
  auto next = labels.begin();
  for (const Measurement& measurement : log) {
    if (next == labels.end()) break;
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || scan->time != next->time || scan->laser != next->laser) continue;
    if (scan->parts.empty()) {
      result.push_back(*next);
    } else {
      append_parts(*next, *scan, result);
    }
    ++next;
  }
  CHECK(next == labels.end());
  return result;
}

LaserScan without_dynamic_beams(LaserScan scan, const ScanLabels& labels) {
  CHECK(labels.static_probability.size() == scan.ranges.size());
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (is_dynamic(labels, beam)) scan.ranges[beam] = 0.0;
  }
  return scan;
}

SensorLog without_dynamic_beams(SensorLog log, const BeamLabels& labels_of_lasers) {
  std::map<std::pair<double, int>, const ScanLabels*> by_scan;
  for (const ScanLabels& labels : labels_of_lasers) by_scan[{labels.time, labels.laser}] = &labels;
  for (Measurement& measurement : log) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    const auto found = by_scan.find({scan->time, scan->laser});
    if (found == by_scan.end()) continue;
    const ScanLabels& labels = *found->second;
    if (labels.static_probability.size() != scan->ranges.size()) continue;  // told nothing new
    *scan = without_dynamic_beams(std::move(*scan), labels);
  }
  return log;
}

}  // namespace mapbed
