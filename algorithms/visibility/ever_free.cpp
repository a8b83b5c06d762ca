#include "algorithms/visibility/ever_free.h"

#include <algorithm>
#include <cstdint>

#include "algorithms/grid/tiled_grid.h"
#include "algorithms/grid/traversal.h"

namespace mapbed {
namespace {

// What was seen of a cell.
struct Look {
  std::uint32_t met_in = 0;    // number of the newest such scan, from 1
  std::uint32_t free_in = 0;   // the same
  std::uint16_t free_for = 0;  // scans that looked there, up to the newest; as many as are enough
  bool was_surely_free = false;
};

// Scans one after the other.
class FreeSpace {
 public:
  explicit FreeSpace(const EverFreeOptions& options)
      : options_(options), looks_(options.resolution) {}

  void add(const LaserScan& scan, const Pose2& map_from_robot) {
    ++scan_;
    free_.clear();
    for_each_beam(scan, map_from_robot, options_.beams, [&](std::size_t, const Beam& beam) {
      if (beam.hit) mark_met(beam);
    });
    for_each_beam(scan, map_from_robot, options_.beams,
                  [&](std::size_t, const Beam& beam) { mark_free(beam); });
    for (const CellIndex cell : free_) {
      Look& look = looks_.at(cell);
      if (!look.was_surely_free) look.was_surely_free = is_free_about(cell);
    }
  }

  bool was_surely_free(const Eigen::Vector2d& point) const {
    return looks_[looks_.cell_of(point)].was_surely_free;
  }

 private:
  // The last stretch of a beam that hit something, and the cell that it did so in.
  void mark_met(const Beam& beam) {
    TiledGrid<Look>::Writer writer(looks_);
    const Eigen::Vector2d along = beam.end - beam.start;
    const double stretch = std::min(1.0, options_.sensor_margin / std::max(along.norm(), 1e-9));
    const auto mark = [&](CellIndex cell, double) {
      writer.at(cell).met_in = scan_;
      writer.at(cell).free_for = 0;
    };
    mark(traverse(beam.end - stretch * along, beam.end, looks_.frame(), mark).cell, 0.0);
  }

  // A beam's way, up to the first cell that any beam of the scan met something in. The cell that a
  // beam without hit ends in is passed in part alone, and left out.
  void mark_free(const Beam& beam) {
    TiledGrid<Look>::Writer writer(looks_);
    bool is_open = true;
    const auto mark = [&](CellIndex cell, double) {
      if (!is_open) return;
      Look& look = writer.at(cell);
      is_open = look.met_in != scan_;
      if (!is_open || look.free_in == scan_) return;
      look.free_in = scan_;
      if (look.free_for < options_.scans) ++look.free_for;
      free_.push_back(cell);
    };
    traverse(beam.start, beam.end, looks_.frame(), mark);
  }

  bool is_free_about(CellIndex cell) const {
    const int margin = options_.pose_margin;
    for (int y = cell.y - margin; y <= cell.y + margin; ++y) {
      for (int x = cell.x - margin; x <= cell.x + margin; ++x) {
        const Look& look = looks_[CellIndex{x, y}];
        if (options_.same_scan ? look.free_in != scan_ : look.free_for < options_.scans)
          return false;
      }
    }
    return true;
  }

  const EverFreeOptions& options_;
  TiledGrid<Look> looks_;
  std::uint32_t scan_ = 0;
  std::vector<CellIndex> free_;  // in this scan
};

}  // namespace

BeamLabels EverFree::labels(std::span<const LaserScan> scans,
                            const Trajectory& map_from_robot) const {
  FreeSpace space(options_);
  for (std::size_t i = 0; i < scans.size(); ++i) space.add(scans[i], map_from_robot[i].pose);
  BeamLabels labels;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    ScanLabels& of_scan = labels.emplace_back(unlabelled(scans[i]));
    for_each_beam(scans[i], map_from_robot[i].pose, options_.beams,
                  [&](std::size_t n, const Beam& beam) {
                    if (!beam.hit) return;
                    of_scan.static_probability[n] = space.was_surely_free(beam.end) ? 0.0F : 1.0F;
                  });
  }
  return labels;
}

}  // namespace mapbed
