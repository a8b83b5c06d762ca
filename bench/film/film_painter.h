#pragma once

#include <vector>

#include "bench/film/course.h"
#include "bench/film/film_view.h"
#include "bench/film/growing_map.h"
#include "core/image/coverage.h"
#include "core/image/image.h"

namespace mapbed {

// Draws the frames of a film, one after the other: the map of the path that is believed in at the
// moment, what stands in the world in truth, the beams of the last scan, the particles with their
// paths, people and doors, the estimated and the true path; below, time and legend.
class FilmPainter {
 public:
  FilmPainter(const Course& course, int longest_side, double speed);  // times real time
  FilmPainter(const FilmPainter&) = delete;
  FilmPainter& operator=(const FilmPainter&) = delete;

  int width() const { return frame_.width(); }
  int height() const { return frame_.height(); }

  // What was believed at that time [s], absolute; each later than the one before.
  const RgbImage& frame_at(double time);
  // What came of it.
  const RgbImage& last_frame();

  // All colours that there are, or nearly so.
  static std::vector<Rgb> palette();

 private:
  void take(const CourseStep& step);
  void draw(const CourseStep* step, double time);
  void draw_beams(std::size_t number, const Pose2& world_from_robot);
  void draw_branches(const CourseStep& step);
  void draw_paths(double time);
  void draw_others(double time);
  void draw_particles(const CourseStep& step);
  void draw_robot(const Pose2& world_from_robot, const Rgb& color);
  void draw_words(const CourseStep* step, double time);
  Eigen::Vector2d pixel_of(const Pose2& world_from_it) const {
    return view_.pixel_of(world_from_it.position());
  }

  const Course& course_;
  double speed_;
  FilmView view_;
  GrowingMap map_;
  bool has_labels_;
  RgbImage footer_;  // with the legend
  RgbImage frame_;
  Coverage coverage_;
  std::size_t next_step_ = 0;
  const CourseStep* shown_ = nullptr;
  std::vector<Pose2> path_;  // world_from_robot, of the step that is shown
};

}  // namespace mapbed
