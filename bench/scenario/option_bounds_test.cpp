// Every numeric option has a smallest and a largest value: a number so large that the work with it
// never ends is refused before any work begins. Goes through all there are, by the configurations
// that the program itself writes.

#include <functional>
#include <optional>

#include <gmock/gmock.h>

#include "algorithms/grid/map_builder.h"
#include "algorithms/methods.h"
#include "bench/experiments/experiment.h"
#include "bench/faults/faults.h"
#include "core/config/config_node.h"
#include "core/log/log_options.h"
#include "robots/robot.h"
#include "sim/drivers/drivers.h"
#include "sim/recorder.h"
#include "sim/render/render_world.h"
#include "sim/simulation.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

// Something with options: its complete configuration, and what takes a setting.
struct Configurable {
  std::string name;
  std::string yaml;
  std::function<void(const Settings&)> configure;
};

template <class Table>
void append_table(std::vector<Configurable>& all, const Table& table) {
  for (const auto& entry : table) {
    all.push_back({entry.name, entry.configure({}).complete_yaml,
                   [&entry](const Settings& settings) { (void)entry.configure(settings); }});
  }
}

template <class Options>
void append_struct(std::vector<Configurable>& all, const std::string& name, Options options) {
  all.push_back({name, to_yaml(options_of(options)), [options](const Settings& settings) {
                   Options changed = options;
                   apply(settings, options_of(changed), "");
                 }});
}

std::vector<Configurable> everything() {
  std::vector<Configurable> all;
  append_table(all, methods());
  append_table(all, experiments());
  append_table(all, world_kinds());
  append_table(all, driver_kinds());
  append_table(all, faults());
  for (const std::string& robot : robot_names()) append_struct(all, robot, load_robot(robot));
  append_struct(all, "log", LogOptions{});
  append_struct(all, "simulation", SimulationOptions{});
  append_struct(all, "recorder", RecorderOptions{});
  append_struct(all, "render", RenderOptions{});
  append_struct(all, "map", MapOptions{});
  return all;
}

// What is said of the value; empty: it was taken.
std::string objection(const Configurable& what, const std::string& path, const std::string& value) {
  try {
    what.configure({{path, value, {"test", 1}}});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

// "m/s" of "0.5 m/s"; no value where the text is no number.
std::optional<std::string> unit_of(const std::string& text) {
  const std::size_t end = text.find_first_not_of("+-0123456789.e");
  if (text.empty() || end == 0) return std::nullopt;
  return end == std::string::npos ? "" : text.substr(end);
}

TEST(OptionBounds, NoNumberIsSoLargeThatWorkWithItNeverEnds) {
  int numbers = 0;
  for (const Configurable& what : everything()) {
    for (const Setting& setting : settings_of(parse_config(what.yaml, {what.name, 1}))) {
      const auto unit = unit_of(setting.text);
      if (!unit || setting.path.ends_with("seed")) continue;  // a seed may be any number
      SCOPED_TRACE(what.name + ": " + setting.path + " = " + setting.text);
      ++numbers;
      const auto refused = [&](const std::string& number) {
        return objection(what, setting.path, number + *unit);
      };
      const bool is_whole = refused("1.5").find("is not a whole number") != std::string::npos;
      EXPECT_THAT(refused(is_whole ? "20000000" : "1e300"), HasSubstr("is too large"));
      EXPECT_THAT(refused(is_whole ? "-20000000" : "-1e300"), HasSubstr("is too small"));
      EXPECT_EQ(objection(what, setting.path, setting.text), "") << "the default";
    }
  }
  EXPECT_GT(numbers, 250);
}

}  // namespace
}  // namespace mapbed
