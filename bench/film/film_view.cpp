#include "bench/film/film_view.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/scan/beam.h"

namespace mapbed {
namespace {

constexpr double kStrayFraction = 0.005;  // of the hits, at each side
constexpr double kBorder = 0.7;           // [m] around what is seen
constexpr double kLeastCell = 0.05;       // [m] finer ones stay empty between the beams
constexpr int kLeastWidth = 360;          // [pixels] so that the legend has room

std::vector<Pose2> path_in_the_end(const Course& course) {
  std::vector<Pose2> path;
  const auto take = [&path](const CourseStep& step) {
    path.resize(step.kept);
    path.insert(path.end(), step.later.begin(), step.later.end());
  };
  std::for_each(course.steps.begin(), course.steps.end(), take);
  if (course.last) take(*course.last);
  return path;
}

// Without so many at either end.
void extend_without_strays(std::vector<double>& values, int axis, Eigen::AlignedBox2d& box) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  const auto strays = static_cast<std::size_t>(kStrayFraction * static_cast<double>(values.size()));
  box.min()[axis] = std::min(box.min()[axis], values[strays]);
  box.max()[axis] = std::max(box.max()[axis], values[values.size() - 1 - strays]);
}

Eigen::AlignedBox2d box_of(const Course& course) {
  const std::vector<Pose2> path = path_in_the_end(course);
  Eigen::AlignedBox2d box;
  std::vector<double> x, y;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Pose2 world_from_robot = course.world_from_map * path[i];
    if (world_from_robot.position().allFinite()) box.extend(world_from_robot.position());
  }
  for (const std::size_t number : course.of_map) {
    if (number >= path.size()) break;
    for_each_beam(course.scans.at(number), course.world_from_map * path[number], {},
                  [&](std::size_t, const Beam& beam) {
                    if (!beam.hit) return;
                    x.push_back(beam.end.x());
                    y.push_back(beam.end.y());
                  });
  }
  for (const Stamped<Pose2>& pose : course.truth) {
    if (pose.time <= course.end) box.extend(pose.pose.position());
  }
  if (box.isEmpty()) box.extend(Eigen::Vector2d::Zero());
  extend_without_strays(x, 0, box);
  extend_without_strays(y, 1, box);
  const Eigen::Vector2d border = Eigen::Vector2d::Constant(kBorder);
  return {box.min() - border, box.max() + border};
}

int even(int cells, int pixels_per_cell) {
  return cells * pixels_per_cell % 2 == 0 ? cells : cells + 1;
}

}  // namespace

FilmView view_of(const Course& course, int longest_side) {
  const Eigen::AlignedBox2d box = box_of(course);
  const double pixel = box.sizes().maxCoeff() / longest_side;  // [m]
  FilmView view;
  view.pixels_per_cell = std::max(1, static_cast<int>(std::ceil(kLeastCell / pixel)));
  view.frame.resolution = pixel * view.pixels_per_cell;
  const auto cells = [&](double meters) {
    return static_cast<int>(std::ceil(meters / view.frame.resolution));
  };
  const int least = std::min(kLeastWidth, longest_side) / view.pixels_per_cell;
  view.cells_x = even(std::max(cells(box.sizes().x()), least), view.pixels_per_cell);
  view.cells_y = even(cells(box.sizes().y()), view.pixels_per_cell);
  const Eigen::Vector2d sides(view.cells_x, view.cells_y);
  view.frame.origin = box.center() - 0.5 * view.frame.resolution * sides;
  return view;
}

}  // namespace mapbed
