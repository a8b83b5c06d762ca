#include "core/log/log_options.h"

#include <gtest/gtest.h>

#include "core/config/config_node.h"
#include "core/config/settings.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

TEST(LogOptions, AreSetByName) {
  LogOptions options;
  apply({parse_setting("field_of_view=270 deg"), parse_setting("stamp=logger"),
         parse_setting("robot_from_laser=[0.78, 0, 0]"), parse_setting("wheels.half_track=20 cm")},
        options_of(options), "log");
  EXPECT_NEAR(options.field_of_view, 1.5 * kPi, 1e-12);
  EXPECT_EQ(options.stamp, Stamp::logger);
  EXPECT_EQ(options.robot_from_laser, (std::vector<double>{0.78, 0, 0}));
  EXPECT_EQ(options.wheels.half_track, 0.2);
}

TEST(LogOptions, OfBagsAreSetByNameAndReadBack) {
  LogOptions options;
  apply({parse_setting("bag.scans=[/front, /rear]"), parse_setting("bag.odometry=/ekf"),
         parse_setting("bag.echo=strongest")},
        options_of(options), "log");
  EXPECT_EQ(options.bag.scans, (std::vector<std::string>{"/front", "/rear"}));
  EXPECT_EQ(options.bag.odometry, "/ekf");
  EXPECT_EQ(options.bag.echo, ChosenEcho::strongest);
  for (LogOptions written : {LogOptions{}, options}) {
    const std::string yaml = to_yaml(options_of(written));
    LogOptions read;
    read_options(parse_config(yaml, {"options.yaml", 0}), options_of(read));
    EXPECT_EQ(to_yaml(options_of(read)), yaml);
  }
}

}  // namespace
}  // namespace mapbed
