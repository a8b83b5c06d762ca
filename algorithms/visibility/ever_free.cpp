#include "algorithms/visibility/ever_free.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "algorithms/grid/tiled_grid.h"
#include "algorithms/grid/traversal.h"

namespace mapbed {
namespace {

// A beam in the robot's frame, as far as it was followed.
struct Followed {
  std::size_t number = 0;
  Eigen::Vector2d start;
  Eigen::Vector2d direction;
  double length = 0.0;  // [m]
  bool hit = false;
};

std::vector<Followed> followed(const LaserScan& scan, const BeamLimits& limits) {
  std::vector<Followed> beams;
  for_each_beam(scan, Pose2{}, limits, [&](std::size_t n, const Beam& beam) {
    const Eigen::Vector2d along = beam.end - beam.start;
    const double length = along.norm();
    if (length > 0.0) beams.push_back({n, beam.start, along / length, length, beam.hit});
  });
  return beams;
}

// Where along `beam` a hit beside it ends what it clears [m]; no nearer than it lies beside.
double cleared_before(const Followed& beam, const Eigen::Vector2d& hit, double sensor_margin,
                      double pose_margin) {
  const Eigen::Vector2d to_hit = hit - beam.start;
  const double along = beam.direction.dot(to_hit);
  const double beside = std::abs(beam.direction.x() * to_hit.y() - beam.direction.y() * to_hit.x());
  if (along <= 0.0 || beside > pose_margin) return INFINITY;
  return along - sensor_margin - std::sqrt(pose_margin * pose_margin - beside * beside);
}

}  // namespace

// Hits beside a beam are those of its neighbours, up to where the beams are farther apart than the
// margin at the nearer end of both.
std::vector<double> cleared_lengths(const LaserScan& scan, const BeamLimits& limits,
                                    double sensor_margin, double pose_margin) {
  std::vector<double> lengths(scan.ranges.size(), 0.0);
  const std::vector<Followed> beams = followed(scan, limits);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const Followed& beam = beams[i];
    double cleared = beam.hit ? beam.length - sensor_margin - pose_margin : beam.length;
    const auto look_beside = [&](std::size_t other) {  // whether farther neighbours may matter
      const Followed& beside = beams[other];
      if (beside.hit) {
        const Eigen::Vector2d hit = beside.start + beside.length * beside.direction;
        cleared = std::min(cleared, cleared_before(beam, hit, sensor_margin, pose_margin));
      }
      const double cosine = std::clamp(beam.direction.dot(beside.direction), -1.0, 1.0);
      const double nearest = 0.3;  // [m] of anything that a laser meets
      return cosine > 0.0 && nearest * std::sqrt(1.0 - cosine * cosine) <= pose_margin;
    };
    for (std::size_t other = i; other-- > 0;) {
      if (!look_beside(other)) break;
    }
    for (std::size_t other = i + 1; other < beams.size(); ++other) {
      if (!look_beside(other)) break;
    }
    lengths[beam.number] = std::max(0.0, cleared);
  }
  return lengths;
}

BeamLabels EverFree::labels(std::span<const LaserScan> scans,
                            const Trajectory& map_from_robot) const {
  struct Looks {
    std::uint32_t free = 0;  // scans
    std::uint32_t last = 0;  // of these, from 1
  };
  TiledGrid<Looks> looks(options_.resolution);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i + 1);
    const std::vector<double> cleared =
        cleared_lengths(scans[i], options_.beams, options_.sensor_margin, options_.pose_margin);
    TiledGrid<Looks>::Writer writer(looks);
    for_each_beam(scans[i], map_from_robot[i].pose, options_.beams,
                  [&](std::size_t n, const Beam& beam) {
                    const Eigen::Vector2d along = (beam.end - beam.start).normalized();
                    if (!(cleared[n] > 0.0)) return;
                    // The cell that the way ends in is cleared in part alone.
                    traverse(beam.start, beam.start + cleared[n] * along, looks.frame(),
                             [&](CellIndex cell, double) {
                               Looks& of_cell = writer.at(cell);
                               if (of_cell.last == number) return;
                               of_cell.last = number;
                               ++of_cell.free;
                             });
                  });
  }
  const auto enough = static_cast<double>(options_.scans);
  return labels_of_ends(scans, map_from_robot, options_.beams, looks.frame(), [&](CellIndex cell) {
    // One half where the last scan that it takes is missing.
    return 1.0 / (1.0 + std::pow(static_cast<double>(looks[cell].free) / (enough - 0.5), 2.0));
  });
}

}  // namespace mapbed
