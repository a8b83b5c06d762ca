#include "bench/figures/weights_figure.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/figures/figure_sheet.h"
#include "bench/figures/plane_panel.h"
#include "bench/plot/map_raster.h"
#include "bench/plot/track_style.h"
#include "core/image/color_map.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr double kCell = 0.1;           // [m]
constexpr std::size_t kMostPeople = 3;  // with a picture of their own

// (3.10) of one person: the fraction of his samples so near.
double hit_by(const PersonThen& person, const Eigen::Vector2d& point, double footprint) {
  const auto near = std::count_if(
      person.samples.begin(), person.samples.end(),
      [&](const Eigen::Vector2d& sample) { return (sample - point).norm() <= footprint; });
  return static_cast<double>(near) / static_cast<double>(person.samples.size());
}

// (3.9)
double hit_by_any(const PeopleMoment& moment, const Eigen::Vector2d& point) {
  double nobody = 1.0;
  for (const PersonThen& person : moment.people) {
    nobody *= 1.0 - hit_by(person, point, moment.footprint);
  }
  return 1.0 - nobody;
}

Rgb mixed(const Rgb& from, const Rgb& to, double fraction) {
  const auto channel = [fraction](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + fraction * (b - a)));
  };
  return {channel(from.red, to.red), channel(from.green, to.green), channel(from.blue, to.blue)};
}

template <class Probability>
RgbImage probability_panel(const PeopleMoment& moment, PlanePanel panel, const Rgb& color,
                           Probability&& probability) {
  const Pose2& local_from_robot = moment.found.local_from_robot;
  panel.shade(kCell, [&](const Eigen::Vector2d& point) {
    return mixed(kWhite, color, probability(local_from_robot * point));
  });
  panel.draw_hits(moment.found.view.scan(), {}, {150, 150, 150});
  panel.draw_robot({});
  panel.draw_border();
  return panel.image();
}

RgbImage beams_panel(const PeopleMoment& moment, PlanePanel panel) {
  const LaserScan& scan = moment.found.view.scan();
  const Pose2& local_from_robot = moment.found.local_from_robot;
  panel.draw_area_seen(scan, {});
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (!scan.is_hit(beam)) continue;
    const Eigen::Vector2d end = scan.point_on(beam, scan.ranges[beam]);
    const double q = hit_by_any(moment, local_from_robot * end);
    fill_disc(panel.image(), panel.pixel_of(end), 2.4, mixed(kScanColor, kDynamicColor, q));
  }
  panel.draw_robot({});
  panel.draw_border();
  return panel.image();
}

std::vector<const PersonThen*> nearest(const PeopleMoment& moment) {
  std::vector<const PersonThen*> people;
  for (const PersonThen& person : moment.people) people.push_back(&person);
  const auto distance = [&](const PersonThen* person) {
    return (person->person.position - moment.found.local_from_robot.position()).norm();
  };
  std::sort(people.begin(), people.end(),
            [&](const PersonThen* a, const PersonThen* b) { return distance(a) < distance(b); });
  people.resize(std::min(people.size(), kMostPeople));
  return people;
}

}  // namespace

RgbImage weights_figure(const std::vector<PeopleMoment>& moments, int longest_side) {
  const PeopleMoment& moment = moments.front();
  const Eigen::AlignedBox2d area = area_about(moment.found.view.scan());
  const std::vector<const PersonThen*> people = nearest(moment);
  const int columns = people.size() < 2 ? 2 : 3;
  const PlanePanel empty(area, 1.0 * longest_side / columns / area.sizes().x());
  std::vector<FigurePanel> panels;
  for (const PersonThen* person : people) {
    panels.push_back({probability_panel(moment, empty, track_color(person->person.id),
                                        [&](const Eigen::Vector2d& point) {
                                          return hit_by(*person, point, moment.footprint);
                                        }),
                      fmt::format("a beam that ends there met person {}", person->person.id)});
  }
  panels.push_back(
      {probability_panel(moment, empty, kBlack,
                         [&](const Eigen::Vector2d& p) { return hit_by_any(moment, p); }),
       fmt::format("it met any of the {} people", moment.people.size())});
  panels.push_back({beams_panel(moment, empty),
                    fmt::format("weights of the beams after {:.1f} s", moment.seconds)});
  using Kind = LegendItem::Kind;
  return sheet_of(panels, columns, empty.pixels_per_meter(),
                  {{Kind::area, kWhite, "probability 0"},
                   {Kind::area, kBlack, "probability 1"},
                   {Kind::disc, kScanColor, "beam of weight 1"},
                   {Kind::disc, kDynamicColor, "beam of weight 0"}});
}

}  // namespace mapbed
