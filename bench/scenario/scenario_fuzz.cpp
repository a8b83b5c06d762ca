// Whatever a scenario says, as it stands or made quick: settings, levels and seeds within their
// bounds, options that are within theirs and read back, or an InputError.

#include "algorithms/grid/map_builder.h"
#include "algorithms/rbpf/grid_slam_options.h"
#include "bench/scenario/scenario.h"
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

void read(const std::string& path, bool quick) {
  const Scenario scenario = load_scenario(path, {.quick = quick});
  CHECK(scenario.seeds >= 1 && !scenario.variants.empty());
  const std::vector<Level> levels = levels_of(scenario.axes);
  CHECK(!levels.empty());
  const Settings settings = settings_of(scenario, levels.front(), scenario.variants.front());
  bind<LogOptions>(settings);
  bind<MapOptions>(settings);
  bind<GridSlamOptions>(settings);
  bind<RecorderOptions>(settings);
  bind<SimulationOptions>(settings);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = fuzz_file("scenario.yaml", data, size);
  use([&] { read(path, false); });
  use([&] { read(path, true); });
  return 0;
}
