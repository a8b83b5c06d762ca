#include "worlds/mine/rough_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr int kWaves = 12;
constexpr double kShortest = 1.5, kLongest = 6.0;  // [m] waves
constexpr double kSlab = 0.1;                      // [m] thickness
constexpr double kLeast = 0.01;                    // [m] shorter slabs are left out
constexpr double kRoom = 3.0;                      // [m] about the pieces, more than relief
constexpr std::size_t kSlabsAnEntity = 200;

double distance_to(const CorridorPiece& piece, const Vector2d& point) {
  const Vector2d along = piece.to - piece.from;
  const double squared = along.squaredNorm();
  const double fraction =
      squared == 0.0 ? 0.0 : std::clamp((point - piece.from).dot(along) / squared, 0.0, 1.0);
  return (point - piece.from - fraction * along).norm();
}

struct Corner {
  Vector2d position;
  double outside;  // [m]
};

struct CornerGrid {
  int width = 0, height = 0;
  std::vector<Corner> corners = {};  // by rows

  Corner& at(int x, int y) { return corners[static_cast<std::size_t>(y * width + x)]; }
  const Corner& at(int x, int y) const { return corners[static_cast<std::size_t>(y * width + x)]; }
};

Eigen::AlignedBox2d box_about(const CorridorPiece& piece) {
  Eigen::AlignedBox2d box(piece.from.cwiseMin(piece.to), piece.from.cwiseMax(piece.to));
  const Vector2d room = Vector2d::Constant(piece.width / 2 + kRoom);
  return {box.min() - room, box.max() + room};
}

// How far each corner is outside of the walls; infinitely, where no piece is near.
CornerGrid grid_over(const std::vector<CorridorPiece>& pieces, const WallRelief& relief,
                     double step) {
  Eigen::AlignedBox2d box;
  for (const CorridorPiece& piece : pieces) box.extend(box_about(piece));
  if (box.isEmpty()) return {};
  const Eigen::Vector2i size = (box.sizes() / step).array().ceil().cast<int>() + 1;
  CornerGrid grid{size.x(), size.y()};
  for (int y = 0; y < size.y(); ++y) {
    for (int x = 0; x < size.x(); ++x) {
      grid.corners.push_back({box.min() + step * Vector2d(x, y), HUGE_VAL});
    }
  }
  for (const CorridorPiece& piece : pieces) {
    const Eigen::AlignedBox2d near = box_about(piece);
    const Eigen::Vector2i low = ((near.min() - box.min()) / step).cast<int>();
    const Eigen::Vector2i high = ((near.max() - box.min()) / step).cast<int>();
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int x = low.x(); x <= high.x(); ++x) {
        Corner& corner = grid.at(x, y);
        const double outside = distance_to(piece, corner.position) - piece.width / 2;
        corner.outside = std::min(corner.outside, outside);
      }
    }
  }
  for (Corner& corner : grid.corners) {
    if (std::isfinite(corner.outside)) corner.outside -= relief.at(corner.position);
  }
  return grid;
}

Vector2d crossing(const Corner& a, const Corner& b) {
  return a.position + (b.position - a.position) * (a.outside / (a.outside - b.outside));
}

struct Segment {
  Vector2d from, to;  // the inside lies to the left
};

// Where the border crosses a square, corners counter-clockwise (marching squares).
std::vector<Segment> segments_in(const std::array<Corner, 4>& corners) {
  std::vector<Vector2d> in, out;  // where the way round goes in, and out
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % 4];
    if ((a.outside < 0.0) == (b.outside < 0.0)) continue;
    (a.outside < 0.0 ? out : in).push_back(crossing(a, b));
  }
  std::vector<Segment> segments;
  // Of two pieces of border, each cuts off an inner corner. What comes out first after going in.
  const bool begins_inside = corners[0].outside < 0.0;
  for (std::size_t i = 0; i < in.size(); ++i) {
    const std::size_t next = begins_inside ? (i + 1) % out.size() : i;
    segments.push_back({out[next], in[i]});
  }
  return segments;
}

Part slab_of(const Segment& segment, double height, int material) {
  const Vector2d along = segment.to - segment.from;
  const double length = along.norm();
  const Vector2d outward = Vector2d(along.y(), -along.x()) / length;
  const Vector2d middle = (segment.from + segment.to) / 2 + outward * kSlab / 2;
  // A little longer, so that nobody looks through between two of them.
  return {.name = "slab",
          .geometry = Box{{length + kSlab, kSlab, height}},
          .entity_from_part =
              upright({middle.x(), middle.y(), std::atan2(along.y(), along.x())}, height / 2),
          .material = material};
}

}  // namespace

WallRelief::WallRelief(double sigma, Rng& rng) : amplitude_(sigma * std::sqrt(2.0 / kWaves)) {
  for (int i = 0; i < kWaves; ++i) {
    const double length = rng.uniform(kShortest, kLongest);
    const double direction = rng.uniform(-kPi, kPi);
    waves_.push_back({2 * kPi / length * Vector2d(std::cos(direction), std::sin(direction)),
                      rng.uniform(-kPi, kPi)});
  }
}

double WallRelief::at(const Vector2d& position) const {
  double sum = 0.0;
  for (const Wave& wave : waves_) sum += std::sin(wave.wave_number.dot(position) + wave.phase);
  return amplitude_ * sum;
}

void add_rough_walls(World& world, const std::string& name,
                     const std::vector<CorridorPiece>& pieces, const WallRelief& relief,
                     const std::string& material, double step) {
  const CornerGrid grid = grid_over(pieces, relief, step);
  const int stone = material_index(world, material);
  Entity wall{.name = name};
  for (int y = 0; y + 1 < grid.height; ++y) {
    for (int x = 0; x + 1 < grid.width; ++x) {
      for (const Segment& segment : segments_in(
               {grid.at(x, y), grid.at(x + 1, y), grid.at(x + 1, y + 1), grid.at(x, y + 1)})) {
        if ((segment.to - segment.from).norm() < kLeast) continue;
        wall.parts.push_back(slab_of(segment, world.ceiling, stone));
      }
    }
    if (wall.parts.size() < kSlabsAnEntity && y + 2 < grid.height) continue;
    if (!wall.parts.empty()) world.entities.push_back(std::exchange(wall, {.name = name}));
  }
}

}  // namespace mapbed
