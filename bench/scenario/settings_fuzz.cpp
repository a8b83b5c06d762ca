// Whatever a scenario says: options that are within their bounds and read back, a sweep, claims and
// plots, or an InputError.

#include <cmath>

#include "algorithms/grid/map_builder.h"
#include "algorithms/rbpf/grid_slam_options.h"
#include "bench/results/claim.h"
#include "bench/results/plot_spec.h"
#include "bench/results/sweep.h"
#include "core/check.h"
#include "core/config/config_node.h"
#include "core/log/log_options.h"
#include "core/testing/fuzz_input.h"
#include "sim/recorder.h"
#include "sim/simulation.h"

namespace {

using namespace mapbed;

template <class Use>
void use(Use use_it) {
  try {
    use_it();
  } catch (const InputError&) {
    return;
  }
}

template <class Options>
void bind(const Settings& settings) {
  for (const Setting& setting : settings) {
    use([&] {
      Options options;
      const OptionList list = options_of(options);
      apply({setting}, list, "fuzz");
      for (const Option& option : list) {
        const auto* number = std::get_if<double*>(&option.value);
        if (number != nullptr)
          CHECK(**number >= option.bounds.low && **number <= option.bounds.high);
      }
      const std::string yaml = to_yaml(list);
      Options again;
      apply(settings_of(parse_config(yaml, {"again", 1})), options_of(again), "again");
      CHECK(to_yaml(options_of(again)) == yaml);
    });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  use([&] {
    const ConfigNode file = parse_config(fuzz_text(data, size), {"fuzz", 1});
    const Settings settings = settings_of(file);
    bind<LogOptions>(settings);
    bind<MapOptions>(settings);
    bind<GridSlamOptions>(settings);
    bind<RecorderOptions>(settings);
    bind<SimulationOptions>(settings);
    for (const ConfigNode& claim : file.at("claims").items()) use([&] { (void)claim_of(claim); });
    for (const ConfigNode& plot : file.at("plots").items()) use([&] { (void)plot_of(plot); });
    std::vector<SweepAxis> axes;
    for (const std::string& path : file.at("sweep").keys()) {
      axes.push_back(axis_of(path, file.at("sweep").at(path).texts()));
    }
    (void)levels_of(axes);
  });
  return 0;
}
