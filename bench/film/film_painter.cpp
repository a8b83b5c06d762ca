#include "bench/film/film_painter.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/film/track_painter.h"
#include "bench/plot/map_legend.h"
#include "bench/plot/map_raster.h"
#include "bench/plot/track_style.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

// Colours of things, told apart with every common kind of colour blindness (Okabe and Ito 2008), as
// in the pages' replays.
constexpr Rgb kTruth{0, 158, 115};
constexpr Rgb kEstimate{0, 114, 178};
constexpr Rgb kParticle{230, 159, 0};
constexpr Rgb kHit{213, 94, 0};
constexpr Rgb kStaticHit{85, 85, 85};  // beside what is called dynamic
constexpr Rgb kPerson{204, 121, 167};
constexpr Rgb kOther{153, 153, 153};
constexpr Rgb kEdge{68, 68, 68};
constexpr Rgb kOutline{90, 105, 130};
constexpr Rgb kBeams{255, 190, 90};
constexpr double kBeamOpacity = 0.35;

constexpr double kUsableRange = 40.0;    // [m] of the beams that are drawn, as of those of the map
constexpr double kNoReturnRange = 20.0;  // [m] see BeamLimits
constexpr double kRobotRadius = 0.25;    // [m] of what stands for any robot
constexpr double kLeastRobot = 5.5;      // [pixels] of the same
constexpr int kMargin = 10;              // [pixels] of the footer
constexpr double kTextSize = 15.0;       // [pixels]

std::vector<LegendItem> legend_of(const Course& course) {
  using Kind = LegendItem::Kind;
  std::vector<LegendItem> items;
  if (!course.truth.empty()) items.push_back({Kind::line, kTruth, "true path"});
  items.push_back({Kind::line, kEstimate, "estimate, " + course.method});
  const bool has_particles =
      std::any_of(course.steps.begin(), course.steps.end(),
                  [](const CourseStep& step) { return !step.particles.empty(); });
  if (has_particles) items.push_back({Kind::disc, kParticle, "particles"});
  if (course.labels.empty()) {
    items.push_back({Kind::disc, kHit, "laser"});
  } else {
    items.push_back({Kind::disc, kStaticHit, "laser"});
    items.push_back({Kind::disc, kDynamicColor, "called dynamic"});
  }
  if (!course.tracks.empty()) {
    items.push_back({Kind::line, kTrackColors[0], "people followed (ring: hidden)"});
  }
  const bool has_people =
      std::any_of(course.others.begin(), course.others.end(),
                  [](const ReplayTrack& other) { return other.kind == "person"; });
  if (has_people) {
    items.push_back({Kind::disc, kPerson, course.tracks.empty() ? "people" : "people in truth"});
  }
  if (!course.outlines.empty()) items.push_back({Kind::line, kOutline, "walls in truth"});
  return items;
}

int legend_width(const FilmView& view) {
  return view.width() - 2 * kMargin;
}

RgbImage footer_of(const Course& course, const FilmView& view) {
  const std::vector<LegendItem> items = legend_of(course);
  const int rows = 1 + legend_rows(items, legend_width(view));
  const int height = kMargin + rows * kLegendRow;
  RgbImage footer(view.width(), height + height % 2, kWhite);
  const Eigen::Vector2d first_row(kMargin, kMargin / 2 + kLegendRow / 2);
  draw_legend(footer, items, first_row + Eigen::Vector2d(0, kLegendRow), legend_width(view));
  return footer;
}

Rgb mixed(const Rgb& below, const Rgb& above, double fraction) {
  const auto channel = [fraction](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + fraction * (b - a)));
  };
  return {channel(below.red, above.red), channel(below.green, above.green),
          channel(below.blue, above.blue)};
}

Rgb grey(double fraction) {
  return mixed(kBlack, kWhite, fraction);
}

}  // namespace

FilmPainter::FilmPainter(const Course& course, int longest_side, double speed)
    : course_(course),
      speed_(speed),
      view_(view_of(course, longest_side)),
      map_(view_.frame, view_.cells_x, view_.cells_y),
      has_labels_(!course.labels.empty()),
      footer_(footer_of(course, view_)),
      frame_(view_.width(), view_.height() + footer_.height(), kWhite),
      coverage_(frame_.width(), frame_.height()) {}

// What is painted over what, at the strengths that smooth edges have.
std::vector<Rgb> FilmPainter::palette() {
  constexpr int greys = 24, lit_greys = 12;
  std::vector<Rgb> colors{kWhite, kUnknownColor, kBlack};
  const Rgb grounds[] = {kWhite, kUnknownColor, mixed(kWhite, kBeams, kBeamOpacity),
                         mixed(kUnknownColor, kBeams, kBeamOpacity), kBlack};
  for (const Rgb& ink : kTrackColors) {
    colors.push_back(ink);
    for (const Rgb& ground : {kWhite, kUnknownColor}) colors.push_back(mixed(ground, ink, 0.5));
  }
  for (const Rgb& ink :
       {kTruth, kEstimate, kParticle, kHit, kPerson, kOther, kEdge, kOutline, kDynamicColor}) {
    colors.push_back(ink);
    for (const Rgb& ground : grounds) {
      for (const double strength : {0.25, 0.5, 0.75}) {
        colors.push_back(mixed(ground, ink, strength));
      }
    }
  }
  colors.insert(colors.end(), std::begin(grounds) + 2, std::end(grounds));
  for (int i = 1; i < greys; ++i) colors.push_back(grey(1.0 * i / greys));
  for (int i = 0; i < lit_greys; ++i) {
    colors.push_back(mixed(grey(1.0 * i / lit_greys), kBeams, kBeamOpacity));
  }
  return colors;
}

const RgbImage& FilmPainter::frame_at(double time) {
  const std::vector<CourseStep>& steps = course_.steps;
  // The first one also where it is yet to come: there is no other.
  while (next_step_ < steps.size() && (next_step_ == 0 || steps[next_step_].time <= time)) {
    take(steps[next_step_++]);
  }
  draw(shown_, time);
  return frame_;
}

const RgbImage& FilmPainter::last_frame() {
  if (course_.last) take(*course_.last);
  draw(nullptr, course_.steps.empty() ? course_.end : course_.steps.back().time);
  return frame_;
}

void FilmPainter::take(const CourseStep& step) {
  path_.resize(step.kept);
  for (const Pose2& pose : step.later) path_.push_back(course_.world_from_map * pose);
  shown_ = &step;
}

void FilmPainter::draw(const CourseStep* step, double time) {
  for (const std::size_t number : course_.of_map) {
    if (number >= path_.size()) break;
    const auto labels = course_.labels.find(number);
    map_.put(number, course_.scans.at(number), path_[number],
             labels == course_.labels.end() ? nullptr : &labels->second);
  }
  if (view_.pixels_per_cell == 1) {
    const std::vector<Rgb>& map = map_.picture().pixels();
    std::copy(map.begin(), map.end(), frame_.pixels().begin());
  } else {
    paste(map_.picture(), view_.pixels_per_cell, frame_, 0, 0);
  }
  std::vector<Eigen::Vector2d> line;
  for (const auto& outline : course_.outlines) {
    line.clear();
    for (const Eigen::Vector2d& point : outline) line.push_back(view_.pixel_of(point));
    coverage_.add_stroke(line, 1.0);
  }
  coverage_.blend_into(frame_, kOutline, 0.6);
  if (has_labels_) draw_others(time);  // below what the laser met of them
  if (step != nullptr && !path_.empty()) {
    draw_beams(path_.size() - 1, path_.back());
    draw_branches(*step);
  }
  draw_paths(time);
  if (!has_labels_) draw_others(time);
  draw_tracks(course_.tracks, time, view_, coverage_, frame_);
  const std::optional<Pose2> truth = pose_at(course_.truth, step == nullptr ? time : step->time);
  if (truth) draw_robot(*truth, kTruth);
  if (!path_.empty()) draw_robot(path_.back(), kEstimate);
  if (step != nullptr) draw_particles(*step);
  draw_words(step, time);
}

void FilmPainter::draw_beams(std::size_t number, const Pose2& world_from_robot) {
  const auto found = course_.scans.find(number);
  if (found == course_.scans.end()) return;
  const LaserScan& scan = found->second;
  const auto labels = course_.labels.find(number);
  std::vector<Eigen::Vector2d> corners{
      view_.pixel_of(world_from_robot * scan.robot_from_laser.planar.position())};
  std::vector<Eigen::Vector2d> hits, dynamic_hits;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const bool says_nothing =
        !(scan.ranges[beam] > 0.0) || (scan.is_max_range(beam) && scan.max_range > kNoReturnRange);
    const double range =
        says_nothing ? 0.0 : std::min({scan.ranges[beam], scan.max_range, kUsableRange});
    corners.push_back(view_.pixel_of(world_from_robot * scan.point_on(beam, range)));
    if (!scan.is_hit(beam) || range != scan.ranges[beam]) continue;
    const bool is_dynamic =
        labels != course_.labels.end() && mapbed::is_dynamic(labels->second, beam);
    (is_dynamic ? dynamic_hits : hits).push_back(corners.back());
  }
  coverage_.add_polygon(corners);
  coverage_.blend_into(frame_, kBeams, kBeamOpacity);
  for (const Eigen::Vector2d& hit : hits) coverage_.add_disc(hit, 1.4);
  coverage_.blend_into(frame_, has_labels_ ? kStaticHit : kHit);
  for (const Eigen::Vector2d& hit : dynamic_hits) coverage_.add_disc(hit, 2.0);
  coverage_.blend_into(frame_, kDynamicColor);
}

void FilmPainter::draw_branches(const CourseStep& step) {
  std::vector<Eigen::Vector2d> line;
  for (const auto& branch : step.branches) {
    line.clear();
    for (const Eigen::Vector2f& place : branch) {
      line.push_back(view_.pixel_of(course_.world_from_map * place.cast<double>()));
    }
    coverage_.add_stroke(line, 0.8);
  }
  coverage_.blend_into(frame_, kParticle, 0.7);
}

void FilmPainter::draw_paths(double time) {
  std::vector<Eigen::Vector2d> line;
  for (const Stamped<Pose2>& pose : course_.truth) {
    if (pose.time > time) break;
    if (pose.time >= course_.start) line.push_back(pixel_of(pose.pose));
  }
  coverage_.add_stroke(line, 4.4);
  coverage_.blend_into(frame_, kTruth);
  line.clear();
  for (const Pose2& pose : path_) line.push_back(pixel_of(pose));
  coverage_.add_stroke(line, 1.9);
  coverage_.blend_into(frame_, kEstimate);
}

void FilmPainter::draw_others(double time) {
  for (const bool is_edge : {true, false}) {
    for (const bool is_person : {true, false}) {
      for (const ReplayTrack& other : course_.others) {
        const std::optional<Pose2> pose = pose_at(other.world_from_it, time);
        if (!pose || is_person != (other.kind == "person")) continue;
        const double radius = std::max(other.radius * view_.pixels_per_meter(), 3.0);
        coverage_.add_disc(pixel_of(*pose), is_edge ? radius + 0.8 : radius);
      }
      coverage_.blend_into(frame_, is_edge ? kEdge : is_person ? kPerson : kOther);
    }
  }
}

void FilmPainter::draw_particles(const CourseStep& step) {
  for (const bool is_edge : {true, false}) {
    for (const Pose2& particle : step.particles) {
      coverage_.add_disc(pixel_of(course_.world_from_map * particle), is_edge ? 2.3 : 1.6);
    }
    coverage_.blend_into(frame_, is_edge ? kEdge : kParticle);
  }
}

void FilmPainter::draw_robot(const Pose2& world_from_robot, const Rgb& color) {
  const double radius = std::max(kRobotRadius, kLeastRobot / view_.pixels_per_meter());
  std::vector<Eigen::Vector2d> outline;
  for (const auto& [x, y] : {std::pair{1.5, 0.0}, {-1.0, 1.0}, {-0.5, 0.0}, {-1.0, -1.0}}) {
    outline.push_back(view_.pixel_of(world_from_robot * Eigen::Vector2d(x * radius, y * radius)));
  }
  coverage_.add_polygon(outline);
  coverage_.blend_into(frame_, color);
  outline.push_back(outline.front());
  coverage_.add_stroke(outline, 1.0);
  coverage_.blend_into(frame_, kWhite);
}

void FilmPainter::draw_words(const CourseStep* step, double time) {
  std::copy(footer_.pixels().begin(), footer_.pixels().end(),
            frame_.pixels().begin() + static_cast<std::ptrdiff_t>(view_.height()) * view_.width());
  const double middle = view_.height() + kMargin / 2 + kLegendRow / 2;
  std::string words = fmt::format("{:.1f} s", std::max(0.0, time - course_.start));
  if (step == nullptr) words += ", the result";
  if (step != nullptr && speed_ != 1.0) words += fmt::format(", {:g} times real time", speed_);
  const std::optional<Pose2> truth = pose_at(course_.truth, step == nullptr ? time : step->time);
  if (truth && !path_.empty()) {
    words += fmt::format(", estimate off by {:.2f} m", distance(*truth, path_.back()));
  }
  draw_text(frame_, {kMargin, middle + 5.0}, words, {.size = kTextSize});
  // As long as there is room for beside the words.
  for (const double most : {0.7 * view_.width(), 0.4 * view_.width()}) {
    const double left = view_.width() - kMargin - 0.25 * most - 60.0;
    if (left < kMargin + text_width(words, kTextSize) + 20.0) continue;
    draw_scale_bar(frame_, {left, middle}, view_.pixels_per_meter(), most);
    return;
  }
}

}  // namespace mapbed
