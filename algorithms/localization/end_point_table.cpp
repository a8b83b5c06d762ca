#include "algorithms/localization/end_point_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>

#include "algorithms/localization/free_space.h"
#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kReach = 3.0;       // [sigma]
constexpr int kSteps = 512;          // of the mixture's table
constexpr std::size_t kBlock = 128;  // poses that are looked at together
constexpr std::size_t kTask = 1024;  // poses of a thread at a time

// How a pose moves points, in cells of the table.
struct Turning {
  float c, s, x, y;
};

Turning turning(const Pose2& pose, const GridFrame& frame, CellIndex corner) {
  const Eigen::Vector2d at = frame.in_cells(pose.position());
  return {static_cast<float>(std::cos(pose.theta)), static_cast<float>(std::sin(pose.theta)),
          static_cast<float>(at.x() - corner.x), static_cast<float>(at.y() - corner.y)};
}

MAPBED_INLINE_LOOP inline float clamped(float x, float largest) {
  const float not_below = x > 0.0F ? x : 0.0F;
  return not_below < largest ? not_below : largest;
}

}  // namespace

EndPointTable::EndPointTable(const OccupancyMap& map, double sigma, double inlier_ratio)
    : frame_(map.frame()), mixture_(sigma / map.resolution(), inlier_ratio, kReach, kSteps) {
  const CellBox box = known_box(map);
  const int radius = static_cast<int>(std::ceil(kReach * sigma / map.resolution()));
  if (box.empty()) {
    width_ = height_ = 1;
    logs_.assign(1, static_cast<float>(outlier_log()));
    is_told_.assign(1, false);
    return;
  }
  corner_ = {box.min.x - radius - 1, box.min.y - radius - 1};
  width_ = box.width() + 2 * (radius + 1);
  height_ = box.height() + 2 * (radius + 1);
  const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  std::vector<int> squared(cells, radius * radius + 1);  // [cells^2] to the nearest occupied one
  map.for_each([&](CellIndex cell, const Occupancy& occupancy) {
    if (!is_occupied(occupancy)) return;
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int dx = -radius; dx <= radius; ++dx) {
        const auto row = static_cast<std::size_t>(cell.y + dy - corner_.y);
        const auto column = static_cast<std::size_t>(cell.x + dx - corner_.x);
        int& least = squared[row * static_cast<std::size_t>(width_) + column];
        least = std::min(least, dx * dx + dy * dy);
      }
    }
  });
  logs_.resize(cells);
  is_told_.resize(cells);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const auto i = static_cast<std::size_t>(y * width_ + x);
      const bool is_far = squared[i] > radius * radius;
      logs_[i] = is_far ? static_cast<float>(outlier_log())
                        : mixture_.log_at(static_cast<float>(squared[i]));
      is_told_[i] = !is_far || map[{corner_.x + x, corner_.y + y}].known();
    }
  }
}

std::size_t EndPointTable::index_of(float x, float y) const {
  const auto column = static_cast<int>(clamped(x, static_cast<float>(width_ - 1)));
  const auto row = static_cast<int>(clamped(y, static_cast<float>(height_ - 1)));
  return static_cast<std::size_t>(row * width_ + column);
}

float EndPointTable::log_at(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d at = frame_.in_cells(point);
  return logs_[index_of(static_cast<float>(at.x() - corner_.x),
                        static_cast<float>(at.y() - corner_.y))];
}

float EndPointTable::sum(const Pose2& map_from_robot, const FieldPoints& points) const {
  const Turning t = turning(map_from_robot, frame_, corner_);
  float sum = 0.0F;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const float weight = points.weights.empty() ? 1.0F : points.weights[k];
    const float x = t.c * points.x[k] - t.s * points.y[k] + t.x;
    const float y = t.s * points.x[k] + t.c * points.y[k] + t.y;
    sum += weight * logs_[index_of(x, y)];
  }
  return sum;
}

EndPointTable::Told EndPointTable::told(const Pose2& map_from_robot,
                                        const FieldPoints& points) const {
  const Turning t = turning(map_from_robot, frame_, corner_);
  Told told;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t index = index_of(t.c * points.x[k] - t.s * points.y[k] + t.x,
                                       t.s * points.x[k] + t.c * points.y[k] + t.y);
    if (!is_told_[index]) continue;
    const double weight = points.weights.empty() ? 1.0 : double{points.weights[k]};
    told.weight += weight;
    told.log += weight * double{logs_[index]};
  }
  return told;
}

void EndPointTable::sums(std::span<const Pose2> map_from_robot, const FieldPoints& points,
                         std::span<float> sums, Processor processor) const {
  CHECK(sums.size() == map_from_robot.size());
  const float last_column = static_cast<float>(width_ - 1);
  const float last_row = static_cast<float>(height_ - 1);
  const float* logs = logs_.data();
  const int width = width_;
  const std::size_t count = points.size();
  const float* weights = points.weights.empty() ? nullptr : points.weights.data();

  const auto block = [&](std::size_t first, std::size_t n) {
    std::array<float, kBlock> c, s, x, y, sum;
    std::array<int, kBlock> index;
    for (std::size_t i = 0; i < n; ++i) {
      const Turning t = turning(map_from_robot[first + i], frame_, corner_);
      c[i] = t.c, s[i] = t.s, x[i] = t.x, y[i] = t.y, sum[i] = 0.0F;
    }
    // Beam by beam, many poses at a time: each pose adds its beams up in the same order.
    run(processor, [&]() MAPBED_INLINE_LOOP {
      for (std::size_t k = 0; k < count; ++k) {
        const float px = points.x[k], py = points.y[k];
        const float weight = weights == nullptr ? 1.0F : weights[k];
        for (std::size_t i = 0; i < n; ++i) {
          const float column = clamped(c[i] * px - s[i] * py + x[i], last_column);
          const float row = clamped(s[i] * px + c[i] * py + y[i], last_row);
          index[i] = static_cast<int>(row) * width + static_cast<int>(column);
        }
        for (std::size_t i = 0; i < n; ++i) sum[i] += weight * logs[index[i]];
      }
    });
    std::copy_n(sum.begin(), n, sums.begin() + static_cast<std::ptrdiff_t>(first));
  };
  const auto task = [&](std::size_t number) {
    const std::size_t end = std::min(map_from_robot.size(), (number + 1) * kTask);
    for (std::size_t i = number * kTask; i < end; i += kBlock) block(i, std::min(kBlock, end - i));
  };
  tbb::parallel_for(std::size_t{0}, (map_from_robot.size() + kTask - 1) / kTask, task);
}

}  // namespace mapbed
