#include "algorithms/people/place_in_boxes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "algorithms/grid/cells_about.h"
#include "algorithms/grid/counting_map.h"
#include "algorithms/scan/beam.h"
#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kResolution = 0.05;     // [m]
constexpr std::uint32_t kLeastEnds = 2;  // one alone may be anything

bool any_dynamic(const ScanLabels& labels) {
  return std::any_of(labels.static_probability.begin(), labels.static_probability.end(),
                     [](float p) { return is_dynamic(p); });
}

// visit(scan, number of the beam, beam)
template <class Visitor>
void for_each_beam_of(const std::vector<KeptScan>& scans, const Trajectory& map_from_robot,
                      Visitor&& visit) {
  for (std::size_t k = 0; k < scans.size(); ++k) {
    for_each_beam(scans[k].readings, map_from_robot[k].pose, {},
                  [&](std::size_t b, const Beam& beam) { visit(k, b, beam); });
  }
}

}  // namespace

void keep_the_place(const std::vector<KeptScan>& scans, const Trajectory& map_from_robot,
                    float static_probability, BeamLabels& labels) {
  CHECK(labels.size() == scans.size() && map_from_robot.size() == scans.size());
  if (std::none_of(labels.begin(), labels.end(), any_dynamic)) return;
  CountingMap others(GridFrame{.resolution = kResolution});
  for_each_beam_of(scans, map_from_robot, [&](std::size_t k, std::size_t b, const Beam& beam) {
    if (!is_dynamic(labels[k], b)) others.insert(beam);
  });
  const auto something_stands = [&](CellIndex index) {
    const CountingMap::Cell& cell = others.cells()[index];
    return cell.hits >= kLeastEnds && cell.hits > cell.misses ? 1.0 : 0.0;
  };
  for_each_beam_of(scans, map_from_robot, [&](std::size_t k, std::size_t b, const Beam& beam) {
    if (!beam.hit || !is_dynamic(labels[k], b)) return;
    const CellIndex end = others.cells().cell_of(beam.end);
    if (largest_about(end, something_stands) > 0.0) {
      labels[k].static_probability[b] = static_probability;
    }
  });
}

}  // namespace mapbed
