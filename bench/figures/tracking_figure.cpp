#include "bench/figures/tracking_figure.h"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "bench/figures/figure_sheet.h"
#include "bench/figures/plane_panel.h"
#include "bench/plot/track_style.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr double kBody = 0.3;       // [m] radius of a ring about somebody
constexpr double kLeastSide = 7.0;  // [m]
constexpr double kBorder = 1.5;     // [m] about whom it is about
constexpr std::size_t kDrawnSamples = 100;

// "after 12.4 s, 3 hidden"
std::string caption_of(const PeopleMoment& moment) {
  std::string words = fmt::format("after {:.1f} s", moment.seconds);
  std::string hidden;
  for (const PersonThen& then : moment.people) {
    if (!then.person.is_seen)
      hidden += fmt::format("{}{}", hidden.empty() ? "" : ", ", then.person.id);
  }
  return hidden.empty() ? words : words + ", not seen: " + hidden;
}

void draw_person(const PersonThen& then, const Pose2& panel_from_local, PlanePanel& panel) {
  const Rgb color = track_color(then.person.id);
  std::vector<Eigen::Vector2d> way;
  for (const Eigen::Vector2d& place : then.way) way.push_back(panel_from_local * place);
  panel.draw_path(way, color);
  const std::size_t step = std::max<std::size_t>(1, then.samples.size() / kDrawnSamples);
  for (std::size_t n = 0; n < then.samples.size(); n += step) {
    fill_disc(panel.image(), panel.pixel_of(panel_from_local * then.samples[n]), 1.6, color, 0.6);
  }
  const Eigen::Vector2d place = panel_from_local * then.person.position;
  const Eigen::Rotation2Dd turn(panel_from_local.theta);
  const Eigen::Matrix2d rotation = turn.toRotationMatrix();
  if (then.person.is_seen) {
    panel.draw_ring(place, kBody, color, false);
  } else {
    panel.draw_ellipse(place, rotation * then.person.covariance * 4.0 * rotation.transpose(), color,
                       true);
  }
}

RgbImage panel_of(const PeopleMoment& moment, const Pose2& panel_from_local, PlanePanel panel) {
  const LaserScan& scan = moment.found.view.scan();
  const Pose2 panel_from_robot = panel_from_local * moment.found.local_from_robot;
  panel.draw_area_seen(scan, panel_from_robot);
  for (const Eigen::Vector2d& person : moment.truth) {
    fill_disc(panel.image(), panel.pixel_of(panel_from_local * person),
              0.25 * panel.pixels_per_meter(), kTruthColor, 0.35);
  }
  panel.draw_hits(scan, panel_from_robot, kScanColor);
  for (const PersonThen& then : moment.people) draw_person(then, panel_from_local, panel);
  for (const PersonThen& then : moment.people) {
    panel.draw_number(panel_from_local * then.person.position, then.person.id,
                      track_color(then.person.id));
  }
  panel.draw_robot(panel_from_robot);
  panel.draw_border();
  return panel.image();
}

// About the robot and whoever is not seen in one of them, in a frame that all share.
Eigen::AlignedBox2d area_of(const std::vector<PeopleMoment>& moments,
                            const Pose2& panel_from_local) {
  std::set<int> hidden;
  Eigen::AlignedBox2d box;
  for (const PeopleMoment& moment : moments) {
    box.extend(panel_from_local * moment.found.local_from_robot.position());
    for (const PersonThen& then : moment.people) {
      if (!then.person.is_seen) hidden.insert(then.person.id);
    }
  }
  for (const PeopleMoment& moment : moments) {
    for (const PersonThen& then : moment.people) {
      if (hidden.contains(then.person.id)) box.extend(panel_from_local * then.person.position);
    }
  }
  if (hidden.empty()) {
    const Eigen::AlignedBox2d ahead = area_about(moments.back().found.view.scan());
    return {box.center() + ahead.min(), box.center() + ahead.max()};
  }
  const double half = std::max(kLeastSide, box.sizes().maxCoeff() + 2.0 * kBorder) / 2.0;
  return {box.center() - Eigen::Vector2d::Constant(half),
          box.center() + Eigen::Vector2d::Constant(half)};
}

}  // namespace

// All in one frame, so that what moves is seen to.
RgbImage tracking_figure(const std::vector<PeopleMoment>& moments, int longest_side) {
  const Pose2 panel_from_local = inverse(moments.front().found.local_from_robot);
  const Eigen::AlignedBox2d area = area_of(moments, panel_from_local);
  const PlanePanel empty(area, 0.5 * longest_side / area.sizes().x());
  std::vector<FigurePanel> panels;
  bool has_truth = false;
  for (const PeopleMoment& moment : moments) {
    panels.push_back({panel_of(moment, panel_from_local, empty), caption_of(moment)});
    has_truth = has_truth || !moment.truth.empty();
  }
  using Kind = LegendItem::Kind;
  std::vector<LegendItem> legend{
      {Kind::disc, kScanColor, "met by the laser"},
      {Kind::line, track_color(0), "somebody's way, samples, number; broken: not seen, 2 sigma"}};
  if (has_truth) legend.push_back({Kind::disc, kTruthColor, "people in truth"});
  return sheet_of(panels, 2, empty.pixels_per_meter(), legend);
}

}  // namespace mapbed
