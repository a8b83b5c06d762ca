#include "bench/film/growing_map.h"

#include <algorithm>
#include <cmath>

#include "algorithms/grid/traversal.h"
#include "algorithms/scan/beam.h"
#include "bench/plot/map_raster.h"

namespace mapbed {
namespace {

constexpr double kSameCells = 0.5;  // of a cell, between poses that are the same
constexpr double kSameReach = 8.0;  // [m] at which a turn may move a beam's end so far
constexpr double kBlackFrom = 0.5;  // beams that pass a wall's edges must not make it grey

// By a cell, or the nearest to it within `all`.
void extend(CellBox& box, CellIndex cell, const CellBox& all) {
  cell = {std::clamp(cell.x, all.min.x, all.max.x), std::clamp(cell.y, all.min.y, all.max.y)};
  if (box.empty()) box = {cell, cell};
  box.min = {std::min(box.min.x, cell.x), std::min(box.min.y, cell.y)};
  box.max = {std::max(box.max.x, cell.x), std::max(box.max.y, cell.y)};
}

Rgb color_of(const CountingMap::Cell& cell) {
  if (cell.hits + cell.misses == 0) return kUnknownColor;
  const double occupied = *counting_occupancy(cell.hits, cell.misses);
  const auto grey =
      static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - std::min(1.0, occupied / kBlackFrom))));
  return {grey, grey, grey};
}

}  // namespace

GrowingMap::GrowingMap(const GridFrame& frame, int width, int height)
    : frame_(frame), cells_(width, height), picture_(width, height, kUnknownColor) {}

bool GrowingMap::is_same(const Pose2& a, const Pose2& b) const {
  const double off = kSameCells * frame_.resolution;
  const double turn = std::abs(std::remainder(a.theta - b.theta, 2.0 * M_PI));
  return distance(a, b) < off && turn * kSameReach < off;
}

void GrowingMap::put(std::size_t number, const LaserScan& scan, const Pose2& map_from_robot,
                     const ScanLabels* labels) {
  const auto [at, is_new] = poses_.try_emplace(number, map_from_robot);
  if (!is_new) {
    if (is_same(at->second, map_from_robot)) return;
    count(scan, at->second, labels, -1U);
    at->second = map_from_robot;
  }
  count(scan, map_from_robot, labels, 1U);
}

// Counts wrap round: what is taken out again was put in before.
void GrowingMap::count(const LaserScan& scan, const Pose2& map_from_robot, const ScanLabels* labels,
                       std::uint32_t sign) {
  const CellBox all{{0, 0}, {cells_.width() - 1, cells_.height() - 1}};
  const auto cell_at = [&](CellIndex index) {
    return &cells_.at(index.x, cells_.height() - 1 - index.y);
  };
  for_each_beam(scan, map_from_robot, {}, [&](std::size_t n, const Beam& beam) {
    const CoveredCell last = traverse(beam.start, beam.end, frame_, [&](CellIndex index, double) {
      if (all.contains(index)) cell_at(index)->misses += sign;
    });
    const bool meets = beam.hit && (labels == nullptr || !is_dynamic(*labels, n));
    if (meets && all.contains(last.cell)) cell_at(last.cell)->hits += sign;
    extend(changed_, frame_.cell_of(beam.start), all);
    extend(changed_, last.cell, all);
  });
}

const RgbImage& GrowingMap::picture() {
  for (int y = changed_.min.y; y <= changed_.max.y; ++y) {
    const int row = cells_.height() - 1 - y;
    for (int x = changed_.min.x; x <= changed_.max.x; ++x) {
      picture_.at(x, row) = color_of(cells_.at(x, row));
    }
  }
  changed_ = {};
  return picture_;
}

}  // namespace mapbed
