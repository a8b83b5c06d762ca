#include "algorithms/localization_method.h"

#include <memory>
#include <string>
#include <utility>

#include "algorithms/localization/beam_model_weights.h"
#include "algorithms/localization/monte_carlo_localizer.h"
#include "algorithms/motion/motion_learning.h"
#include "algorithms/rfid/learned_rfid.h"
#include "algorithms/rfid/rfid_weights.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// What weights the particles.
enum class LocalizationSensors : int { given, laser, rfid };

struct RfidOptions {
  std::string model = "pioneer_rfid_smooth";
  RfidWeightOptions weights;
};

struct LocalizationOptions {
  LocalizationSensors sensors = LocalizationSensors::given;
  MonteCarloOptions monte_carlo;
  RfidOptions rfid;
};

template <class Visitor>
void visit_fields(RfidOptions& o, Visitor&& visit) {
  visit("model", o.model,
        "what was learned of the antennas: a file of algorithms/rfid/rfid_models");
  visit_fields(o.weights, visit);
}

template <class Visitor>
void visit_fields(LocalizationOptions& o, Visitor&& visit) {
  visit("sensors", o.sensors, {"given", "laser", "rfid"},
        "what weights the particles: scans, and RFID where tags are given; or one of them alone");
  visit_fields(o.monte_carlo, visit);
  visit("rfid", o.rfid, "how the rounds of an RFID reader weight the particles");
}

struct Setup {
  LocalizationOptions options;
  LearnedRfid model;
};

FreeSpace space_in(const Given& given, const MonteCarloOptions& options) {
  if (given.map == nullptr) {
    throw InputError(
        {}, "localization finds a robot in a map, and was given none",
        "use 'mapbed localize LOG --map MAP.yaml', or choose a method that makes maps");
  }
  FreeSpace space(given.map);
  if (!given.near.empty()) space = space.near(given.near, options.start_near);
  if (!space.empty()) return space;
  throw InputError({},
                   given.near.empty() ? "nothing of the map is free, so that no robot can be there"
                                      : "nothing of the map is free near the path that was told",
                   "take another map, or look at its thresholds and 'negate'");
}

MonteCarloLocalizer::AllWeights weights_of(const Setup& setup, const Given& given,
                                           const FreeSpace& space, const Rng& rng) {
  const LocalizationOptions& options = setup.options;
  MonteCarloLocalizer::AllWeights weights;
  if (options.sensors != LocalizationSensors::laser) {
    if (options.sensors == LocalizationSensors::rfid && given.tags.empty()) {
      throw InputError({}, "localization by RFID alone needs to know where tags are",
                       "use 'mapbed localize LOG --map MAP.yaml --tags TAGS.csv'");
    }
    // First: where a tag answers, particles need not begin everywhere.
    for (std::size_t antenna = 0; antenna < setup.model.size() && !given.tags.empty(); ++antenna) {
      weights.push_back(std::make_unique<RfidWeights>(static_cast<int>(antenna),
                                                      setup.model[antenna], given.tags, *given.map,
                                                      options.rfid.weights));
    }
  }
  if (options.sensors != LocalizationSensors::rfid) {
    weights.push_back(make_laser_weights(options.monte_carlo.laser, space, rng.stream("laser")));
  }
  return weights;
}

std::unique_ptr<Estimator> make(const Setup& setup, const Given& given, const Rng& rng) {
  const MonteCarloOptions& options = setup.options.monte_carlo;
  const FreeSpace space = space_in(given, options);
  return std::make_unique<MonteCarloLocalizer>(options, space, weights_of(setup, given, space, rng),
                                               given.start, rng.stream("particles"));
}

ConfiguredMethod configure(const std::string& name, const Settings& settings) {
  Setup setup;
  apply(with_learned_models(settings), options_of(setup.options), name);
  setup.model = load_learned_rfid(setup.options.rfid.model);
  const std::string yaml = to_yaml(options_of(setup.options));
  InputFiles files = learned_model_files(settings);
  files.push_back(learned_rfid_file(setup.options.rfid.model));
  return {
      yaml,
      [setup = std::move(setup)](const Given& given, Rng rng) { return make(setup, given, rng); },
      std::move(files)};
}

}  // namespace

Method localization_method() {
  const std::string name = "localization";
  return {.name = name,
          .about = "Monte Carlo localisation in a map that is given, section 7.4",
          .configure = [name](const Settings& settings) { return configure(name, settings); },
          .needs_map = true};
}

}  // namespace mapbed
