#include "algorithms/field/likelihood_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "algorithms/field/nearest_of_tile.h"
#include "algorithms/grid/grid_size.h"
#include "core/check.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kReach = 3.0;       // [sigma] of the neighbourhood that a mapped point changes
constexpr int kLargestRadius = 200;  // [cells] of it: every point changes its square
constexpr int kMixtureSteps = 1024;
constexpr int kDirectoryMargin = 4;  // [tiles] grown beyond what is needed
constexpr int kBoundSteps = 1024;

// A line's direction as cells keep it; `counted` is what counts of a distance along it.
Eigen::Vector2f along_of(const SurfacePoint& point, double counted) {
  return (std::sqrt(1.0 - counted * counted) * tangent_of(point.doubled)).cast<float>();
}

}  // namespace

LikelihoodField::LikelihoodField(const LikelihoodFieldOptions& options)
    : resolution_(options.resolution),
      sigma_(options.sigma),
      mixture_(options.sigma / options.resolution, options.inlier_ratio, kReach, kMixtureSteps),
      outlier_log_(static_cast<float>(mixture_.outlier_log())),
      radius_(static_cast<int>(std::ceil(kReach * (options.sigma / options.resolution)))) {
  CHECK(options.resolution > 0.0);
  if (radius_ > kLargestRadius) {
    throw InputError(fmt::format(
        "a sigma of {:g} m is too large for a map of {:g} m a cell; choose a smaller one or larger "
        "cells",
        options.sigma, options.resolution));
  }
  const double farthest = kReach * options.sigma / options.resolution;
  bounds_per_square_ = static_cast<float>(kBoundSteps / (farthest * farthest));
  for (int i = 0; i <= kBoundSteps; ++i) {
    // Of the nearest distance that rounds to this index.
    const auto squared = static_cast<float>(std::max(0.0, i - 0.01) / double{bounds_per_square_});
    const double above = double{mixture_.log_at(squared)} - double{outlier_log_};
    bounds_.push_back(
        static_cast<std::uint8_t>(std::clamp(std::ceil(above / bound_step()), 0.0, 255.0)));
  }
  bounds_.back() = 0;
}

void LikelihoodField::clear() {
  std::fill(directory_.begin(), directory_.end(), -1);
  free_tiles_.clear();
  tiles_ = 0;
}

void LikelihoodField::widen_directory(int tile_x, int tile_y) {
  const int old_x = min_x_, old_y = min_y_, old_width = width_, old_height = height_;
  const auto widen = [](int tile, int& min, int& size) {
    const int low = size == 0 ? tile : min;
    const int high = size == 0 ? tile + 1 : min + size;
    min = tile < low ? tile - kDirectoryMargin : low;
    size = (tile >= high ? tile + 1 + kDirectoryMargin : high) - min;
  };
  int min_x = min_x_, min_y = min_y_, width = width_, height = height_;
  widen(tile_x, min_x, width);
  widen(tile_y, min_y, height);
  check_grid_size(width, height);
  min_x_ = min_x, min_y_ = min_y, width_ = width, height_ = height;
  std::vector<std::int32_t> wider(
      static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), -1);
  for (int y = 0; y < old_height; ++y) {
    const auto from = directory_.begin() + std::ptrdiff_t{y} * old_width;
    std::copy(from, from + old_width,
              wider.begin() + std::ptrdiff_t{y + old_y - min_y_} * width_ + (old_x - min_x_));
  }
  directory_ = std::move(wider);
}

std::int32_t LikelihoodField::slot_for_writing(int tile_x, int tile_y) {
  const bool inside =
      tile_x >= min_x_ && tile_x < min_x_ + width_ && tile_y >= min_y_ && tile_y < min_y_ + height_;
  if (!inside) widen_directory(tile_x, tile_y);
  std::int32_t& slot =
      directory_[static_cast<std::size_t>(tile_y - min_y_) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(tile_x - min_x_)];
  if (slot < 0) {
    if (free_tiles_.empty()) {
      slot = tiles_++;
    } else {
      slot = free_tiles_.back();
      free_tiles_.pop_back();
    }
    const std::size_t end = static_cast<std::size_t>(slot + 1) * kTileCells;
    if (cells_.size() < end) cells_.resize(std::max(end, cells_.size() * 3 / 2));
    std::fill_n(cells_.begin() + static_cast<std::ptrdiff_t>(end - kTileCells), kTileCells, Cell{});
  }
  return slot;
}

void LikelihoodField::add(const std::vector<SurfacePoint>& points) {
  for (const SurfacePoint& point : points) add(point);
}

// The cell whose centre is nearest.
CellIndex LikelihoodField::middle_of(const Eigen::Vector2d& point) const {
  return {static_cast<int>(std::lround(point.x() / resolution_ - 0.5)),
          static_cast<int>(std::lround(point.y() / resolution_ - 0.5))};
}

void LikelihoodField::add(const SurfacePoint& point) {
  const auto [x, y] = middle_of(point.position);
  for (int tile_y = (y - radius_) >> kTileBits; tile_y <= (y + radius_) >> kTileBits; ++tile_y) {
    for (int tile_x = (x - radius_) >> kTileBits; tile_x <= (x + radius_) >> kTileBits; ++tile_x) {
      add_in_tile(point, tile_x, tile_y, tile_in(slot_for_writing(tile_x, tile_y)));
    }
  }
}

void LikelihoodField::add_in_tile(const SurfacePoint& point, int tile_x, int tile_y,
                                  Cell* tile) const {
  // In cells, so that (x, y) stands for the centre of cell (x, y).
  const double u = point.position.x() / resolution_ - 0.5;
  const double v = point.position.y() / resolution_ - 0.5;
  const Eigen::Vector2f along = along_of(point, kAlong);
  const CellIndex middle = middle_of(point.position);
  const int first_x = std::max(middle.x - radius_, tile_x * kTileSide);
  const int last_x = std::min(middle.x + radius_, tile_x * kTileSide + kTileSide - 1);
  const int first_y = std::max(middle.y - radius_, tile_y * kTileSide);
  const int last_y = std::min(middle.y + radius_, tile_y * kTileSide + kTileSide - 1);
  std::array<float, kTileSide> from_x;
  for (int x = first_x; x <= last_x; ++x) {
    from_x[static_cast<std::size_t>(x & (kTileSide - 1))] = static_cast<float>(u - x);
  }
  for (int y = first_y; y <= last_y; ++y) {
    const auto dy = static_cast<float>(v - y);
    Cell* row = tile + (y & (kTileSide - 1)) * kTileSide;
    for (int x = first_x & (kTileSide - 1); x <= (last_x & (kTileSide - 1)); ++x) {
      const float dx = from_x[static_cast<std::size_t>(x)];
      Cell& cell = row[x];
      if (dx * dx + dy * dy < cell.x * cell.x + cell.y * cell.y) {
        cell = {dx, dy, along.x(), along.y()};
      }
    }
  }
}

void LikelihoodField::update(const SurfaceMeans& means, const std::vector<CellIndex>& changed) {
  // A mean lies in its cell, so it is rounded to the cell's centre or to the next one's.
  std::vector<std::pair<int, int>> tiles;  // (y, x)
  for (const CellIndex cell : changed) {
    for (int y = (cell.y - radius_) >> kTileBits; y <= (cell.y + 1 + radius_) >> kTileBits; ++y) {
      for (int x = (cell.x - radius_) >> kTileBits; x <= (cell.x + 1 + radius_) >> kTileBits; ++x) {
        if (tiles.empty() || tiles.back() != std::pair(y, x)) tiles.emplace_back(y, x);
      }
    }
  }
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  std::vector<std::int32_t> slots;
  for (const auto& [y, x] : tiles) {
    release_tile(x, y);
    slots.push_back(slot_for_writing(x, y));
  }
  std::vector<char> is_used(tiles.size());
  tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
    const auto [y, x] = tiles[i];
    is_used[i] = fill_tile(x, y, means, tile_in(slots[i])) ? 1 : 0;
  });
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (is_used[i] == 0) release_tile(tiles[i].second, tiles[i].first);
  }
}

// An empty tile, with all means that reach into it. False where none does.
bool LikelihoodField::fill_tile(int tile_x, int tile_y, const SurfaceMeans& means,
                                Cell* tile) const {
  const int reach = radius_ + 1;
  const CellIndex corner{tile_x * kTileSide, tile_y * kTileSide};
  const CellBox about{{corner.x - reach, corner.y - reach},
                      {corner.x + kTileSide - 1 + reach, corner.y + kTileSide - 1 + reach}};
  struct Point {
    double u, v;  // [cells], so that (x, y) stands for the centre of cell (x, y)
    Eigen::Vector2f along;
  };
  std::vector<Point> points;
  NearestOfTile<kTileSide> nearest(2.0F * (kFar * kFar));
  means.for_each_in(about, [&](const SurfacePoint& mean) {
    const CellIndex middle = middle_of(mean.position);
    const CellIndex low{middle.x - radius_ - corner.x, middle.y - radius_ - corner.y};
    const CellIndex high{middle.x + radius_ - corner.x, middle.y + radius_ - corner.y};
    if (high.x < 0 || high.y < 0 || low.x >= kTileSide || low.y >= kTileSide) return;
    const double u = mean.position.x() / resolution_ - 0.5;
    const double v = mean.position.y() / resolution_ - 0.5;
    nearest.add(static_cast<std::int32_t>(points.size()), u, v, corner, {low, high});
    points.push_back({u, v, along_of(mean, kAlong)});
  });
  if (points.empty()) return false;
  for (int i = 0; i < kTileSide * kTileSide; ++i) {
    const std::int32_t number = nearest.number[static_cast<std::size_t>(i)];
    if (number < 0) continue;
    const Point& point = points[static_cast<std::size_t>(number)];
    tile[i] = {static_cast<float>(point.u - (corner.x + i % kTileSide)),
               static_cast<float>(point.v - (corner.y + i / kTileSide)), point.along.x(),
               point.along.y()};
  }
  return true;
}

void LikelihoodField::release_tile(int tile_x, int tile_y) {
  const int x = tile_x - min_x_, y = tile_y - min_y_;
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  std::int32_t& slot = directory_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                  static_cast<std::size_t>(x)];
  if (slot < 0) return;
  free_tiles_.push_back(slot);
  slot = -1;
}

inline const LikelihoodField::Cell* LikelihoodField::cell_at(int x, int y) const {
  const std::int32_t slot =
      directory_[static_cast<std::size_t>((y >> kTileBits) * width_ + (x >> kTileBits))];
  if (slot < 0) return nullptr;
  return &cells_[static_cast<std::size_t>(slot) * kTileCells +
                 static_cast<std::size_t>((y & (kTileSide - 1)) * kTileSide +
                                          (x & (kTileSide - 1)))];
}

// Negative and far coordinates, NaN too, read as far from everything.
inline float LikelihoodField::log_in_directory(float x, float y) const {
  if (!(x >= 0.0F && y >= 0.0F && x < static_cast<float>(width_ * kTileSide) &&
        y < static_cast<float>(height_ * kTileSide))) {
    return outlier_log_;
  }
  const int ix = static_cast<int>(x), iy = static_cast<int>(y);
  const Cell* cell = cell_at(ix, iy);
  if (cell == nullptr) return outlier_log_;
  const float dx = x - static_cast<float>(ix) - 0.5F - cell->x;
  const float dy = y - static_cast<float>(iy) - 0.5F - cell->y;
  const float along = dx * cell->along_x + dy * cell->along_y;
  return mixture_.log_at(dx * dx + dy * dy - along * along);
}

double LikelihoodField::log_at(const Eigen::Vector2d& point) const {
  return double{
      log_in_directory(static_cast<float>(point.x() / resolution_ - double{kTileSide} * min_x_),
                       static_cast<float>(point.y() / resolution_ - double{kTileSide} * min_y_))};
}

// With q = d^2 in cells, ln(w exp(-q / (2 s^2)) + 1 - w) has the derivative -r / (2 s^2), r the
// probability of the Gaussian in the mixture; q's second derivative alone counts for the curvature
// (Gauss-Newton).
std::optional<LikelihoodField::Surface> LikelihoodField::surface_at(
    const Eigen::Vector2d& point) const {
  const Eigen::Vector2d corner(double{kTileSide} * min_x_, double{kTileSide} * min_y_);
  const Eigen::Vector2d cells = point / resolution_ - corner;
  const Eigen::Vector2d size(width_ * kTileSide, height_ * kTileSide);
  if (!((cells.array() >= 0.0).all() && (cells.array() < size.array()).all())) return {};
  const Eigen::Vector2d middle = cells.array().floor() + 0.5;
  const Cell* cell = cell_at(static_cast<int>(cells.x()), static_cast<int>(cells.y()));
  if (cell == nullptr || cell->x == kFar) return {};
  const Eigen::Vector2d nearest = middle + Eigen::Vector2d(double{cell->x}, double{cell->y});
  const Eigen::Vector2d along(double{cell->along_x}, double{cell->along_y});
  return Surface{(corner + nearest) * resolution_,
                 along.isZero() ? along : Eigen::Vector2d(along.normalized())};
}

LikelihoodField::Shape LikelihoodField::shape_at(const Eigen::Vector2d& point) const {
  const double x = point.x() / resolution_ - double{kTileSide} * min_x_;
  const double y = point.y() / resolution_ - double{kTileSide} * min_y_;
  if (!(x >= 0.0 && y >= 0.0 && x < width_ * kTileSide && y < height_ * kTileSide)) return {};
  const Cell* cell = cell_at(static_cast<int>(x), static_cast<int>(y));
  if (cell == nullptr || cell->x == kFar) return {};
  const Eigen::Vector2d off(x - std::floor(x) - 0.5 - double{cell->x},
                            y - std::floor(y) - 0.5 - double{cell->y});
  Eigen::Matrix2d across = Eigen::Matrix2d::Identity();
  const Eigen::Vector2d along(double{cell->along_x}, double{cell->along_y});
  if (!along.isZero()) across -= along * along.transpose() / along.squaredNorm();
  const double value = double{mixture_.log_at(static_cast<float>(off.dot(across * off)))};
  const double weight = mixture_.inlier_probability(value) / (sigma_ * sigma_);
  return {.slope = -weight * resolution_ * across * off, .curvature = weight * across};
}

std::vector<CellIndex> LikelihoodField::tile_corners() const {
  std::vector<CellIndex> corners;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (directory_[static_cast<std::size_t>(y * width_ + x)] < 0) continue;
      corners.push_back({(min_x_ + x) * kTileSide, (min_y_ + y) * kTileSide});
    }
  }
  return corners;
}

CellBox LikelihoodField::box() const {
  CellBox box;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (directory_[static_cast<std::size_t>(y * width_ + x)] < 0) continue;
      const CellIndex low{(min_x_ + x) * kTileSide, (min_y_ + y) * kTileSide};
      const CellIndex high{low.x + kTileSide - 1, low.y + kTileSide - 1};
      if (box.empty()) {
        box = {low, high};
      } else {
        box.min = {std::min(box.min.x, low.x), std::min(box.min.y, low.y)};
        box.max = {std::max(box.max.x, high.x), std::max(box.max.y, high.y)};
      }
    }
  }
  return box;
}

double LikelihoodField::sum_log_at(const FieldPoints& points, const Pose2& map_from_robot) const {
  const auto c = static_cast<float>(std::cos(map_from_robot.theta));
  const auto s = static_cast<float>(std::sin(map_from_robot.theta));
  const auto tx = static_cast<float>(map_from_robot.x / resolution_ - double{kTileSide} * min_x_);
  const auto ty = static_cast<float>(map_from_robot.y / resolution_ - double{kTileSide} * min_y_);
  float sum = 0.0F;
  if (points.weights.empty()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float x = points.x[i], y = points.y[i];
      sum += log_in_directory(c * x - s * y + tx, s * x + c * y + ty);
    }
    return double{sum};
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = points.x[i], y = points.y[i];
    sum += points.weights[i] * log_in_directory(c * x - s * y + tx, s * x + c * y + ty);
  }
  return double{sum};
}

}  // namespace mapbed
