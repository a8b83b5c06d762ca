#include "algorithms/rfid/learned_rfid.h"

#include <utility>

#include <fmt/format.h>

#include "core/config/config_node.h"
#include "core/config/settings.h"
#include "core/config/suggestion.h"
#include "core/data_path.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// By the place of each kind in the variant.
const std::vector<std::string> kKinds{"piecewise", "histogram", "smooth"};

std::string path_of(const std::string& name_or_path) {
  return find_data_file("RFID model", "algorithms/rfid/rfid_models", name_or_path).string();
}

AntennaModel of_kind(const std::string& kind, const SourceLocation& place) {
  if (kind == kKinds[0]) return PiecewiseAntenna{};
  if (kind == kKinds[1]) return HistogramAntenna{};
  if (kind == kKinds[2]) return SmoothAntenna{};
  throw InputError(place, "unknown kind " + in_quotes(kind) + " of an antenna",
                   suggestion(kind, kKinds));
}

void check(const HistogramAntenna& antenna, const SourceLocation& place) {
  const auto cells =
      static_cast<std::size_t>(antenna.cells) * static_cast<std::size_t>(antenna.cells);
  if (antenna.rounds.size() != cells || antenna.detections.size() != cells) {
    throw InputError(
        place, fmt::format("{} cells a side are {} cells, not {} with rounds and {} with "
                           "detections",
                           antenna.cells, cells, antenna.rounds.size(), antenna.detections.size()));
  }
  for (std::size_t i = 0; i < cells; ++i) {
    if (antenna.detections[i] <= antenna.rounds[i]) continue;
    throw InputError(place, fmt::format("cell {} has more detections than rounds", i));
  }
}

AntennaModel antenna_in(const ConfigNode& node) {
  AntennaModel antenna = of_kind(node.at("kind").text(), node.at("kind").place());
  std::visit([&](auto& a) { read_options(node, options_of(a)); }, antenna);
  if (const auto* counted = std::get_if<HistogramAntenna>(&antenna)) check(*counted, node.place());
  return antenna;
}

}  // namespace

std::string kind_of(const AntennaModel& antenna) {
  return kKinds[antenna.index()];
}

LearnedRfid load_learned_rfid(const std::string& name_or_path) {
  const ConfigNode file = load_config(path_of(name_or_path));
  LearnedRfid model;
  for (const ConfigNode& node : file.at("antennas").items()) model.push_back(antenna_in(node));
  if (model.empty()) {
    throw InputError(file.at("antennas").place(), "an RFID model without antennas",
                     "learn one by the scenario ch7_sensor_model");
  }
  file.check_all_used("the RFID model");
  return model;
}

InputFile learned_rfid_file(const std::string& name_or_path) {
  return input_file(path_of(name_or_path));
}

std::string to_yaml(const LearnedRfid& model, const std::string& comment) {
  std::string text = comment + "antennas:\n";
  for (const AntennaModel& antenna : model) {
    text += "  - kind: " + kind_of(antenna) + "\n";
    AntennaModel copy = antenna;
    const std::string options = std::visit([](auto& a) { return to_yaml(options_of(a)); }, copy);
    text += indented(indented(options));
  }
  return text;
}

}  // namespace mapbed
