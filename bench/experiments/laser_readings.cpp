#include "bench/experiments/laser_readings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "bench/plot/plot.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/statistics/chi_square.h"
#include "robots/robot.h"
#include "sim/noise/laser_noise.h"
#include "sim/sensors/ideal_laser.h"
#include "sim/validation/laser_specification.h"

namespace mapbed {
namespace {

enum class TargetKind : int { wall, glass, edge, leg, glass_by_angle };

struct LaserReadingsOptions {
  std::string sensor = "sick_lms200";
  MixedPixels mixed_pixels = MixedPixels::pulse;
  TargetKind target = TargetKind::wall;
  std::string material = "plaster";
  double distance = 5.004;  // [m] within a step, so that rounding is seen
  double incidence = 0.0;   // [rad]
  double gap = 0.6;         // [m]
  double radius = 0.07;     // [m]
  int readings = 100'000;
  LaserModel laser;  // of `sensor`, with `mixed_pixels`; read when the options are bound
};

template <class Visitor>
void visit_fields(LaserReadingsOptions& o, Visitor&& visit) {
  visit("sensor", o.sensor, "the laser, by name or file");
  visit("mixed_pixels", o.mixed_pixels, {"off", "weighted", "either", "pulse"},
        "what a beam on an edge returns, in place of what the laser's file says");
  visit("target", o.target, {"wall", "glass", "edge", "leg", "glass_by_angle"},
        "what the beam is sent at; glass, edge and leg have a wall of plaster behind them");
  visit("material", o.material, "of the wall");
  visit("distance", o.distance, Unit::meter, between(0.001, 1000.0), "of the target");
  visit("incidence", o.incidence, Unit::radian, between(0.0, 1.5),
        "between the beam and the normal of wall or pane");
  visit("gap", o.gap, Unit::meter, between(0.001, 1000.0), "from the target to the wall behind");
  visit("radius", o.radius, Unit::meter, between(0.001, 100.0), "of the leg");
  visit("readings", o.readings, between(1000, 1'000'000), "that are drawn in a run");
}

LaserTarget target_of(const LaserReadingsOptions& o) {
  switch (o.target) {
    case TargetKind::glass:
    case TargetKind::glass_by_angle:
      return glass_target(o.distance, o.incidence, o.gap);
    case TargetKind::edge:
      return edge_target(o.laser, o.distance, o.gap);
    case TargetKind::leg:
      return leg_target(o.laser, o.distance, o.radius, o.gap);
    case TargetKind::wall:
      break;
  }
  return wall_target(o.material, o.distance, o.incidence);
}

LaserModel laser_of(const LaserReadingsOptions& o) {
  LaserModel laser = load_laser(o.sensor);
  laser.noise.mixed_pixels = o.mixed_pixels;
  laser.noise.bias_spread = laser.noise.scale_spread = 0.0;  // of devices, not of readings
  if (laser.noise.step <= 0.0 || o.mixed_pixels == MixedPixels::off) {
    throw InputError({}, "the readings have no specification to be compared with",
                     "take a laser whose noise.step is positive, and mixed_pixels other than off");
  }
  return laser;
}

// The beam that looks along the robot's x axis, sent `readings` times, each time from another place
// and with noise of its own.
std::vector<double> simulated_readings(const LaserTarget& target, const LaserModel& model,
                                       int readings, const Rng& rng) {
  MountedLaser laser;
  laser.model = model;
  const double ahead = -model.first_bearing / model.bearing_step;
  if (std::abs(ahead - std::round(ahead)) > 1e-6 || ahead < 0.0 || ahead > model.beams - 1) {
    throw InputError({}, "no beam of the laser looks straight ahead", "take another sensor");
  }
  std::vector<AimedBeam> beams(static_cast<std::size_t>(readings));
  Rng places = rng.stream("places");
  for (AimedBeam& beam : beams) {
    beam.index = static_cast<int>(std::lround(ahead));
    beam.world_from_robot.y = places.uniform(-target.half_width, target.half_width);
  }
  const Scene scene(world_of(target));
  IdealScan ideal;
  ideal.first_echo = {0};
  for (const BeamEchoes& beam : cast_beams(scene, laser, beams)) {
    ideal.echoes.insert(ideal.echoes.end(), beam.echoes.begin(), beam.echoes.end());
    ideal.first_echo.push_back(static_cast<std::uint32_t>(ideal.echoes.size()));
  }
  laser.model.beams = readings;  // noise takes them for the beams of one sweep
  return with_noise(ideal, laser, rng).ranges;
}

struct Comparison {
  LaserModel laser;
  ReadingFractions specified;
  ReadingFractions disc;  // of an evenly lit disc, without the simulator's few sub-rays
  ReadingFractions found;
  int readings = 0;
};

Comparison compare(const LaserReadingsOptions& o, const LaserTarget& target, const Rng& rng) {
  constexpr int kFineSubRays = 61;
  constexpr int kFinePlaces = 1000;
  Comparison c;
  c.laser = o.laser;
  c.readings = o.readings;
  c.specified = specified_fractions(target, c.laser, spot_model_of(c.laser));
  c.disc = specified_fractions(target, c.laser, {kFineSubRays, false}, kFinePlaces);
  c.found.assign(c.specified.size(), 0.0);
  for (const double reading : simulated_readings(target, c.laser, o.readings, rng)) {
    c.found[reading_index(reading, c.laser)] += 1.0 / o.readings;
  }
  return c;
}

// Largest difference of two cumulative distributions.
double distance_of(const ReadingFractions& a, const ReadingFractions& b) {
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += a[k] - b[k];
    largest = std::max(largest, std::abs(sum));
  }
  return largest;
}

std::vector<double> times(const ReadingFractions& fractions, double factor) {
  std::vector<double> counts(fractions);
  for (double& count : counts) count *= factor;
  return counts;
}

// Where all but the rare readings lie, and a little more.
std::pair<std::size_t, std::size_t> window_of(const ReadingFractions& fractions) {
  constexpr double kRare = 2e-5;  // a cell
  constexpr std::size_t kMargin = 6;
  std::size_t first = fractions.size();
  std::size_t last = 0;
  for (std::size_t k = 0; k + 1 < fractions.size(); ++k) {
    if (fractions[k] < kRare) continue;
    first = std::min(first, k);
    last = k;
  }
  return {first > kMargin ? first - kMargin : 0, std::min(last + kMargin, fractions.size() - 2)};
}

// A value for each reading of the window.
PlotSeries series_of(const std::string& name, const ReadingFractions& fractions,
                     const Comparison& c, Mark mark) {
  PlotSeries series{.name = name, .mark = mark};
  const auto [first, last] = window_of(c.specified);
  for (std::size_t k = first; k <= last; ++k) {
    series.x.push_back(static_cast<double>(k) * c.laser.noise.step);
    series.y.push_back(fractions[k]);
  }
  return series;
}

// Points with the 95 % interval of a fraction of so many readings.
void add_intervals(PlotSeries& series, double readings) {
  for (const double fraction : series.y) {
    const double half = 1.96 * std::sqrt(fraction * (1.0 - fraction) / readings);
    series.low.push_back(std::max(0.0, fraction - half));
    series.high.push_back(std::min(1.0, fraction + half));
  }
}

std::vector<ResultFile> figure_files(const std::string& name, const Plot& plot) {
  return {{"figures/" + name + ".svg", svg_of(plot)}, {"figures/" + name + ".csv", csv_of(plot)}};
}

std::string title_of(const LaserReadingsOptions& o) {
  const double degrees_off = degrees(o.incidence);
  switch (o.target) {
    case TargetKind::glass:
    case TargetKind::glass_by_angle:
      return fmt::format("A pane {:.2f} m away, {:.0f} deg off its normal, a wall {:.2f} m behind",
                         o.distance, degrees_off, o.gap);
    case TargetKind::edge:
      return fmt::format("The edge of a wall {:.2f} m away, another wall {:.2f} m behind",
                         o.distance, o.gap);
    case TargetKind::leg:
      return fmt::format("A leg {:.2f} m away, a wall {:.2f} m behind", o.distance, o.gap);
    case TargetKind::wall:
      break;
  }
  return fmt::format("A wall of {} {:.2f} m away, {:.0f} deg off its normal", o.material,
                     o.distance, degrees_off);
}

Plot histogram_of(const LaserReadingsOptions& o, const Comparison& c) {
  const std::vector<std::string> mixing{"off", "weighted", "either", "pulse"};
  Plot plot{.title = title_of(o),
            .subtitle =
                fmt::format("{}, mixed pixels: {}; {} readings in steps of {:.0f} mm, one "
                            "run; nothing seen: {:.4f}, specified {:.4f}",
                            o.sensor, mixing[static_cast<std::size_t>(o.mixed_pixels)], o.readings,
                            1000.0 * c.laser.noise.step, c.found.back(), c.specified.back()),
            .x = {.label = "reading", .unit = "m"},
            .y = {.label = "fraction of the readings", .unit = "", .low = 0.0}};
  plot.series.push_back(series_of("simulated", c.found, c, Mark::bars));
  plot.series.push_back(series_of("specified", c.specified, c, Mark::line));
  if (distance_of(c.specified, c.disc) > 0.01) {
    plot.series.push_back(series_of("evenly lit disc", c.disc, c, Mark::line));
  }
  return plot;
}

RunOutcome run_histogram(const LaserReadingsOptions& o, const RunInput& input) {
  const Comparison c = compare(o, target_of(o), input.rng);
  const ChiSquare fit = chi_square(times(c.found, o.readings), times(c.specified, o.readings));
  RunOutcome outcome;
  outcome.values = {{"chi_square_score", fit.score},
                    {"classes", fit.classes},
                    {"unseen", c.found.back()},
                    {"unseen_specified", c.specified.back()},
                    {"spot_error", distance_of(c.specified, c.disc)}};
  if (input.shown) outcome.files = figure_files("readings", histogram_of(o, c));
  return outcome;
}

// Of readings, the fraction that came back from the pane and not from behind it.
double pane_fraction(const ReadingFractions& fractions, double border, double step) {
  const auto end = static_cast<std::ptrdiff_t>(std::lround(border / step));
  return std::accumulate(fractions.begin(), fractions.begin() + end, 0.0);
}

// A pane met at one angle after the other: how often does it answer?
RunOutcome run_by_angle(LaserReadingsOptions o, const RunInput& input) {
  const std::vector<double> angles{0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 25, 30, 40, 50, 60, 70};
  o.readings /= static_cast<int>(angles.size());
  PlotSeries specified{.name = "specified"};
  PlotSeries found{.name = "simulated", .mark = Mark::points};
  double squares = 0.0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    o.incidence = radians(angles[i]);
    const Comparison c = compare(o, target_of(o), input.rng.stream("angle", i));
    const double border = o.distance + o.gap / 2.0;
    specified.x.push_back(angles[i]);
    found.x.push_back(angles[i]);
    specified.y.push_back(pane_fraction(c.specified, border, c.laser.noise.step));
    found.y.push_back(pane_fraction(c.found, border, c.laser.noise.step));
    const double p = specified.y.back();
    const double off = found.y.back() - p;
    squares += off * off * o.readings / (p * (1.0 - p));
  }
  add_intervals(found, o.readings);
  // A sum of squares of as many standard normal numbers as there are angles.
  const auto count = static_cast<int>(angles.size());
  RunOutcome outcome;
  outcome.values = {{"chi_square_score", chi_square_score(squares, count)}, {"classes", count}};
  if (!input.shown) return outcome;
  const Plot plot{
      .title = "How often a pane of glass answers",
      .subtitle = fmt::format("{} readings at each angle, one run, 95 % intervals", o.readings),
      .x = {.label = "angle between beam and normal", .unit = "deg"},
      .y = {.label = "fraction of the readings from the pane", .unit = "", .low = 0.0, .high = 1.0},
      .series = {specified, found}};
  outcome.files = figure_files("answers", plot);
  return outcome;
}

RunOutcome run(const LaserReadingsOptions& options, const RunInput& input) {
  if (options.target == TargetKind::glass_by_angle) return run_by_angle(options, input);
  return run_histogram(options, input);
}

Configured<RunOutcome(const RunInput&)> configure(const Settings& settings) {
  LaserReadingsOptions options;
  apply(settings, options_of(options), "laser_readings");
  const InputFiles files = {input_file(sensor_file(options.sensor))};
  options.laser = laser_of(options);
  return {to_yaml(options_of(options)),
          [options](const RunInput& input) { return run(options, input); }, files};
}

}  // namespace

Experiment laser_readings_experiment() {
  return {
      "laser_readings",
      "readings of the simulated laser against its specification",
      Experiment::Needs::nothing,
      {{"chi_square_score", Unit::none,
        "misfit of the readings' histogram; standard normal where they are as specified"},
       {"classes", Unit::none, "that the histogram has for it"},
       {"unseen", Unit::none, "fraction of readings that saw nothing"},
       {"unseen_specified", Unit::none, "what it should be"},
       {"spot_error", Unit::none,
        "largest difference of the cumulative specification from that of an evenly lit disc: what "
        "the few sub-rays cost"}},
      configure};
}

}  // namespace mapbed
