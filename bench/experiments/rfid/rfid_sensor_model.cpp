#include "bench/experiments/rfid/rfid_sensor_model.h"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "algorithms/rfid/calibration.h"
#include "algorithms/rfid/learned_rfid.h"
#include "bench/experiments/rfid/posed_rounds.h"
#include "bench/figures/detection_field_figure.h"
#include "core/image/png.h"
#include "core/input_error.h"
#include "core/statistics/moments.h"
#include "worlds/world.h"

namespace mapbed {
namespace {

const std::array<std::string, 2> kSides{"left", "right"};

struct RfidSensorModelOptions {
  double cell_size = 0.5;  // [m]
  double reach = 9.0;      // [m]
};

template <class Visitor>
void visit_fields(RfidSensorModelOptions& o, Visitor&& visit) {
  visit("cell_size", o.cell_size, Unit::meter, between(0.1, 5.0), "of the histogram");
  visit("reach", o.reach, Unit::meter, between(1.0, 50.0),
        "of the histogram, to each side; tags farther away are not read");
}

using Readings = std::vector<CalibrationReading>;

// By antenna: each round is a reading of every tag within `reach` [m].
std::vector<Readings> readings_in(const LogInput& drive, std::size_t antennas, double reach) {
  std::vector<Readings> readings(antennas);
  for (const PosedRound& posed : posed_rounds(drive.log, drive.truth)) {
    if (static_cast<std::size_t>(posed.round->antenna) >= antennas) continue;
    const Pose2 antenna_from_world = inverse(posed.map_from_antenna());
    for (const RfidTag& tag : drive.world->tags) {
      const Eigen::Vector2d place = tag.world_from_tag.position.head<2>();
      CalibrationReading reading{antenna_from_world * place};
      if (reading.tag_in_antenna.norm() > reach) continue;
      for (const RfidRead& read : posed.round->reads) {
        if (read.tag != tag.id) continue;
        reading.detected = true;
        if (read.has_rssi()) reading.rssi = read.rssi;
      }
      readings[static_cast<std::size_t>(posed.round->antenna)].push_back(reading);
    }
  }
  return readings;
}

struct LearnedAntenna {
  PiecewiseAntenna piecewise;
  HistogramAntenna histogram;
  SmoothAntenna smooth;
  double rate = 0.0;  // of all readings
};

LearnedAntenna learned_from(const Readings& readings, const RfidSensorModelOptions& options) {
  LearnedAntenna learned;
  learned.piecewise = fitted_piecewise(readings);
  learned.histogram =
      counted_histogram(readings, {.cell_size = options.cell_size, .reach = options.reach});
  learned.smooth = fitted_smooth(readings);
  double detections = 0.0;
  for (const CalibrationReading& reading : readings) detections += reading.detected ? 1.0 : 0.0;
  learned.rate = detections / static_cast<double>(readings.size());
  return learned;
}

void tell(const std::string& side, const LearnedAntenna& learned, const Readings& readings,
          RunOutcome& outcome) {
  const auto tell_value = [&](const std::string& name, double value) {
    outcome.values.emplace_back(side + "_" + name, value);
  };
  tell_value("readings", static_cast<double>(readings.size()));
  tell_value("direction", learned.piecewise.direction);
  tell_value("opening", learned.piecewise.opening);
  tell_value("range", learned.piecewise.range);
  tell_value("disc_radius", learned.piecewise.disc_radius);
  tell_value("arc_rate", learned.piecewise.arc_rate);
  tell_value("disc_rate", learned.piecewise.disc_rate);
  tell_value("elsewhere_rate", learned.piecewise.elsewhere_rate);
  tell_value("level", learned.smooth.level);
  tell_value("pointing", learned.smooth.direction);
  tell_value("rssi", learned.smooth.rssi);
  tell_value("rssi_sigma", learned.smooth.rssi_sigma);
}

// -ln p of a reading, by models that were learned elsewhere: in the mean over both antennas.
void tell_losses(const std::vector<LearnedAntenna>& learned, const std::vector<Readings>& held_out,
                 const std::string& name, RunOutcome& outcome) {
  Moments constant, cautious, piecewise, histogram, smooth, rssi;
  for (std::size_t a = 0; a < learned.size(); ++a) {
    const PiecewiseAntenna of_rate{.arc_rate = learned[a].rate,
                                   .disc_rate = learned[a].rate,
                                   .elsewhere_rate = learned[a].rate};
    PiecewiseAntenna careful = learned[a].piecewise;
    careful.caution = 1.0;
    constant.add(-mean_log_likelihood(of_rate, held_out[a]));
    cautious.add(-mean_log_likelihood(careful, held_out[a]));
    piecewise.add(-mean_log_likelihood(learned[a].piecewise, held_out[a]));
    histogram.add(-mean_log_likelihood(learned[a].histogram, held_out[a]));
    smooth.add(-mean_log_likelihood(learned[a].smooth, held_out[a]));
    rssi.add(-mean_log_likelihood_of_rssi(learned[a].smooth, held_out[a]));
  }
  outcome.values.emplace_back(name + "constant_loss", constant.mean());
  outcome.values.emplace_back(name + "cautious_loss", cautious.mean());
  outcome.values.emplace_back(name + "piecewise_loss", piecewise.mean());
  outcome.values.emplace_back(name + "histogram_loss", histogram.mean());
  outcome.values.emplace_back(name + "smooth_loss", smooth.mean());
  outcome.values.emplace_back(name + "rssi_loss", rssi.mean());
}

void add_files(const std::vector<LearnedAntenna>& learned, const RunInput& input,
               RunOutcome& outcome) {
  LearnedRfid piecewise, histogram, smooth;
  for (const LearnedAntenna& antenna : learned) {
    piecewise.push_back(antenna.piecewise);
    histogram.push_back(antenna.histogram);
    smooth.push_back(antenna.smooth);
  }
  const std::string comment = fmt::format(
      "# Learned by\n#   ./mapbed run ch7_sensor_model --seed {} --set seeds=1\n", input.seed);
  outcome.files.push_back({"learned/piecewise.yaml", to_yaml(piecewise, comment)});
  outcome.files.push_back({"learned/histogram.yaml", to_yaml(histogram, comment)});
  outcome.files.push_back({"learned/smooth.yaml", to_yaml(smooth, comment)});
  std::vector<DetectionField> fields;
  for (std::size_t a = 0; a < learned.size(); ++a) {
    fields.push_back({learned[a].histogram, learned[a].piecewise, learned[a].smooth,
                      fmt::format("{} antenna", a < kSides.size() ? kSides[a] : "further")});
  }
  outcome.files.push_back({"maps/detection_field.png", png_of(detection_field_figure(fields)),
                           "what the antennas heard of a tag, by its place"});
}

RunOutcome run(const RfidSensorModelOptions& options, const RunInput& input) {
  if (input.world->tags.empty()) {
    throw InputError({}, "the world has no RFID tags", "choose one with tags, as rfid_calibration");
  }
  const auto antennas = static_cast<std::size_t>(antennas_in(input.log));
  const std::vector<Readings> readings = readings_in(input, antennas, options.reach);
  std::vector<LearnedAntenna> learned;
  RunOutcome outcome;
  for (std::size_t a = 0; a < antennas; ++a) {
    if (readings[a].empty()) {
      throw InputError({}, fmt::format("antenna {} has no rounds on the way", a + 1));
    }
    learned.push_back(learned_from(readings[a], options));
    if (a < kSides.size()) tell(kSides[a], learned[a], readings[a], outcome);
  }
  tell_losses(learned, readings_in(input.further.at("held_out"), antennas, options.reach), "",
              outcome);
  tell_losses(learned, readings_in(input.further.at("office"), antennas, options.reach), "office_",
              outcome);
  if (antennas > 1) {
    outcome.values.emplace_back("level_difference",
                                learned[0].smooth.level - learned[1].smooth.level);
    outcome.values.emplace_back("rssi_difference", learned[0].smooth.rssi - learned[1].smooth.rssi);
  }
  if (input.shown) add_files(learned, input, outcome);
  return outcome;
}

std::vector<Metric> metrics_of(const std::string& side) {
  const auto named = [&](const std::string& name) { return side + "_" + name; };
  const std::string of = " of the " + side + " antenna";
  return {
      {named("readings"), Unit::none, "inventory rounds" + of + ", with the tag's place known"},
      {named("direction"), Unit::radian, "middle of the arc" + of + ", off its mount"},
      {named("opening"), Unit::radian, "opening of the arc" + of},
      {named("range"), Unit::meter, "range of the arc" + of},
      {named("disc_radius"), Unit::meter, "radius of the disc" + of},
      {named("arc_rate"), Unit::none, "probability of an answer within the arc" + of},
      {named("disc_rate"), Unit::none, "probability of an answer within the disc" + of},
      {named("elsewhere_rate"), Unit::none, "probability of an answer elsewhere" + of},
      {named("level"), Unit::none, "[dB] over the tag's threshold 1 m ahead" + of},
      {named("pointing"), Unit::radian, "strongest direction" + of + ", off its mount"},
      {named("rssi"), Unit::none, "[dBm] strength of an answer from 1 m ahead" + of},
      {named("rssi_sigma"), Unit::none, "[dB] what strengths differ by from that" + of},
  };
}

std::vector<Metric> loss_metrics(const std::string& name, const std::string& where) {
  const std::string of = ", " + where;
  return {
      {name + "constant_loss", Unit::none, "mean -ln p of a round by one rate everywhere" + of},
      {name + "cautious_loss", Unit::none, "the same by Figure 7.4, 1/2 outside" + of},
      {name + "piecewise_loss", Unit::none, "the same by arc, disc and rates" + of},
      {name + "histogram_loss", Unit::none, "the same by the histogram" + of},
      {name + "smooth_loss", Unit::none, "the same by the link budget" + of},
      {name + "rssi_loss", Unit::none, "mean -ln p of an answer's strength, per dB" + of},
  };
}

std::vector<Metric> all_metrics() {
  std::vector<Metric> metrics;
  const auto add = [&](std::vector<Metric> more) {
    for (Metric& metric : more) metrics.push_back(std::move(metric));
  };
  for (const std::string& side : kSides) add(metrics_of(side));
  add(loss_metrics("", "in a run held out"));
  add(loss_metrics("office_", "in another building"));
  metrics.push_back({"level_difference", Unit::none, "[dB] left_level less right_level"});
  metrics.push_back({"rssi_difference", Unit::none, "[dB] left_rssi less right_rssi"});
  return metrics;
}

}  // namespace

Experiment rfid_sensor_model_experiment() {
  Experiment experiment = make_experiment<RfidSensorModelOptions>(
      "rfid_sensor_model", "what antennas hear of a tag, learned by turning before it, Figure 7.3",
      Experiment::Needs::world, all_metrics(), run);
  experiment.further_logs = {"held_out", "office"};
  return experiment;
}

}  // namespace mapbed
