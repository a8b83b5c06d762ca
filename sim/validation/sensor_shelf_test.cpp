// Every laser of robots/sensors stands in a small room, records, and is held to what its
// description promises: where its beams look and when, its limits of range, its errors.

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "core/statistics/moments.h"
#include "sim/noise/laser_noise.h"
#include "sim/noise/sensor_noise.h"
#include "sim/recorder.h"
#include "sim/scene/scene.h"
#include "sim/sensors/ideal_laser.h"
#include "sim/testing/small_world.h"
#include "sim/validation/laser_target.h"

namespace mapbed {
namespace {

constexpr double kLength = 4.0;  // [m] of the room
constexpr double kWidth = 3.0;   // [m]
const Pose2 kPlace{1.7, 1.3, 0.3};
constexpr int kSweeps = 10;

class OnTheSpot : public Driver {
 public:
  explicit OnTheSpot(double turn_velocity = 0.0) : turn_velocity_(turn_velocity) {}  // [rad/s]
  void add(const Measurement& /*measurement*/) override {}
  DriveCommand command(double /*time*/) override { return {.turn_velocity = turn_velocity_}; }
  bool is_done() const override { return false; }

 private:
  double turn_velocity_;
};

Robot carrying(const LaserModel& laser) {
  Robot robot;
  robot.name = "stand";
  robot.height = 0.5;
  robot.footprint.radius = 0.1;
  robot.sensors = {{.name = "front", .model = laser}};
  return robot;
}

std::vector<LaserScan> recorded_scans(const LaserModel& laser, const Rng& rng) {
  const Robot robot = carrying(laser);
  Simulation simulation(small_room(kLength, kWidth), robot, kPlace, {}, rng);
  OnTheSpot driver;
  const double longest = (kSweeps - 0.5) / laser.scan_rate + laser.sweep_time();
  const Recording recording = record(simulation, driver, {.longest = longest}, rng);
  std::vector<LaserScan> scans;
  for (const Measurement& measurement : with_noise(recording.readings, robot, rng)) {
    if (const auto* scan = std::get_if<LaserScan>(&measurement)) scans.push_back(*scan);
  }
  return scans;
}

// To the room's wall from kPlace. [m]
struct WallAhead {
  double range, cos_incidence;
};
WallAhead wall_ahead(double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  const double along_x = (c > 0.0 ? kLength - kPlace.x : kPlace.x) / std::abs(c);
  const double along_y = (s > 0.0 ? kWidth - kPlace.y : kPlace.y) / std::abs(s);
  return along_x < along_y ? WallAhead{along_x, std::abs(c)} : WallAhead{along_y, std::abs(s)};
}

// The spot is on one wall.
bool is_off_corners(const LaserModel& laser, double heading) {
  const double half = laser.divergence / 2.0 + laser.aperture / (2.0 * kPlace.y);
  for (const double x : {0.0, kLength}) {
    for (const double y : {0.0, kWidth}) {
      const double corner = std::atan2(y - kPlace.y, x - kPlace.x);
      if (std::abs(angle_difference(corner, heading)) < 1.5 * half + radians(0.1)) return false;
    }
  }
  return true;
}

std::vector<std::string> laser_names() {
  std::vector<std::string> names;
  for (const std::string& name : sensor_names()) {
    if (std::holds_alternative<LaserModel>(load_sensor(name))) names.push_back(name);
  }
  return names;
}

double normal_below(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

// Where beams meet the walls, of a robot that turns by 1 rad/s: those of a log's scan were sent one
// after the other from its stamp on.
TEST(SensorShelf, EverySensorsBeamsAreSentWhenItsScansSay) {
  for (const std::string& name : laser_names()) {
    SCOPED_TRACE(name);
    const LaserModel laser = load_laser(name);
    if (laser.beam_period() == 0.0) continue;
    Robot robot = carrying(laser);
    robot.drive.turn_acceleration = 1000.0;
    Simulation simulation(small_room(kLength, kWidth), robot, kPlace, {}, Rng(1));
    OnTheSpot driver(1.0);
    const Recording recording = record(simulation, driver, {.longest = 1.0}, Rng(1));
    const Trajectory truth = trajectory_of(recording.truth);
    const BeamTruthOfScan& scan = recording.truth.beams.at(recording.truth.beams.size() / 2);
    // What stands for one instant is off by half its sweep.
    const double late = laser.stamp == SweepStamp::middle ? laser.sweep_time() / 2.0 : 0.0;
    for (std::size_t k = 0; k < scan.beams.size(); ++k) {
      const double sent = static_cast<double>(k) * laser.beam_period();
      const double heading = pose_at(truth, scan.time + sent)->theta + laser.first_bearing +
                             static_cast<double>(k) * laser.bearing_step;
      if (!is_off_corners(laser, heading)) continue;
      const WallAhead wall = wall_ahead(heading);
      const double slope =
          wall.range * std::sqrt(1.0 / std::pow(wall.cos_incidence, 2) - 1.0);  // [m/rad]
      EXPECT_NEAR(scan.beams[k].range, wall.range, slope * (late + 0.002) + 0.002) << k;
    }
  }
}

// What is promised of a beam that meets plaster (remission 75 %): lost with `lost`, else read with
// `sigma` about the range, the rounding to steps included.
struct Promise {
  double lost, sigma;
};
Promise promise(const LaserModel& laser, const WallAhead& wall) {
  const LaserNoise& n = laser.noise;
  const double limit = n.dark_range * std::sqrt(7.5 * wall.cos_incidence);
  const double grown = std::clamp(
      (wall.range - n.near_range) / std::max(1e-9, n.far_range - n.near_range), 0.0, 1.0);
  const double sigma = n.sigma_near + grown * (n.sigma_far - n.sigma_near);
  const double too_dark =
      n.dark_range > 0.0 ? normal_below(std::log(wall.range / limit) / n.dark_softness) : 0.0;
  return {std::max(too_dark, wall.range > laser.max_range ? 1.0 : 0.0),
          std::hypot(sigma, n.step / std::sqrt(12.0))};
}

// What the readings of the room are, against what was promised.
struct Tally {
  std::vector<double> errors;  // in promised sigmas
  int beams = 0, lost = 0, gross = 0;
  double expected_lost = 0.0, variance_of_lost = 0.0;
};

Tally tally_of(const LaserModel& laser, const std::vector<LaserScan>& scans, const Rng& rng) {
  const DeviceError device = device_error(laser.noise, 0, rng);
  Tally tally;
  for (const LaserScan& scan : scans) {
    for (std::size_t k = 0; k < scan.ranges.size(); ++k) {
      const double heading = kPlace.theta + scan.bearing(k);
      if (!is_off_corners(laser, heading)) continue;
      const WallAhead wall = wall_ahead(heading);
      const Promise promised = promise(laser, wall);
      ++tally.beams;
      tally.expected_lost += promised.lost;
      tally.variance_of_lost += promised.lost * (1.0 - promised.lost);
      if (scan.is_max_range(k)) {
        ++tally.lost;
        continue;
      }
      const double mean = device.scale * wall.range + laser.noise.bias + device.bias;
      const double error = (scan.ranges[k] - mean) / promised.sigma;
      if (std::abs(error) > 6.0) {
        ++tally.gross;
      } else {
        tally.errors.push_back(error);
      }
    }
  }
  return tally;
}

TEST(SensorShelf, EverySensorsBeamsLookAndComeAsItsDescriptionSays) {
  for (const std::string& name : laser_names()) {
    SCOPED_TRACE(name);
    const LaserModel laser = load_laser(name);
    const std::vector<LaserScan> scans = recorded_scans(laser, Rng(1));
    ASSERT_GE(scans.size(), static_cast<std::size_t>(kSweeps));
    for (std::size_t i = 0; i < scans.size(); ++i) {
      const LaserScan& scan = scans[i];
      ASSERT_EQ(scan.ranges.size(), static_cast<std::size_t>(laser.beams));
      EXPECT_EQ(scan.first_bearing, laser.first_bearing);
      EXPECT_EQ(scan.bearing_step, laser.bearing_step);
      EXPECT_NEAR(scan.time - scans[0].time, static_cast<double>(i) / laser.scan_rate, 1e-9);
      if (laser.interlace == 1) {
        EXPECT_NEAR(scan.beam_period, laser.bearing_step / (2.0 * kPi * laser.mirror_rate), 1e-12);
      }
      for (const double range : scan.ranges) {
        EXPECT_TRUE(range == 0.0 || range >= laser.min_range) << range;
        EXPECT_LE(range, laser.max_range);
        const double steps = range / laser.noise.step;
        EXPECT_TRUE(range == laser.max_range || std::abs(steps - std::round(steps)) < 1e-6);
      }
    }
  }
}

TEST(SensorShelf, EverySensorsReadingsSpreadAndAreLostAsItsDescriptionSays) {
  for (const std::string& name : laser_names()) {
    SCOPED_TRACE(name);
    const LaserModel laser = load_laser(name);
    const Tally tally = tally_of(laser, recorded_scans(laser, Rng(2)), Rng(2));
    const double count = static_cast<double>(tally.errors.size());
    ASSERT_GT(count, 1000.0);
    // Five standard errors; of neighbours within one step the roundings agree, so that fewer are
    // independent where steps are coarse: half of them.
    EXPECT_NEAR(mean_of(tally.errors), 0.0, 5.0 / std::sqrt(count / 2.0));
    EXPECT_NEAR(sigma_of(tally.errors), 1.0, 5.0 / std::sqrt(count));
    const LaserNoise& n = laser.noise;
    const double gross =
        (n.miss_probability + n.short_probability + n.random_probability) * tally.beams;
    EXPECT_LE(tally.gross, gross + 5.0 * std::sqrt(gross) + 2.0);
    EXPECT_NEAR(tally.lost, tally.expected_lost,
                gross + 5.0 * std::sqrt(gross + tally.variance_of_lost) + 2.0);
  }
}

// A hundred readings of a plane, head on, without errors.
std::vector<double> readings_at(double distance, LaserModel laser) {
  laser.noise.sigma_near = laser.noise.sigma_far = 0.0;
  laser.noise.bias_spread = laser.noise.scale_spread = laser.noise.dark_range = 0.0;
  laser.noise.miss_probability = laser.noise.short_probability = 0.0;
  laser.noise.random_probability = 0.0;
  MountedLaser mounted{.model = laser};
  std::vector<AimedBeam> beams(100);
  for (AimedBeam& beam : beams) beam.world_from_robot.theta = -laser.first_bearing;
  IdealScan ideal;
  ideal.first_echo = {0};
  const Scene scene(world_of(wall_target("plaster", distance, 0.0)));
  for (const BeamEchoes& beam : cast_beams(scene, mounted, beams)) {
    ideal.echoes.insert(ideal.echoes.end(), beam.echoes.begin(), beam.echoes.end());
    ideal.first_echo.push_back(static_cast<std::uint32_t>(ideal.echoes.size()));
  }
  mounted.model.beams = 100;
  return with_noise(ideal, mounted, Rng(3)).ranges;
}

TEST(SensorShelf, EverySensorSeesNothingOutsideItsLimits) {
  for (const std::string& name : laser_names()) {
    SCOPED_TRACE(name);
    const LaserModel laser = load_laser(name);
    const double step = laser.noise.step;
    const double near = laser.min_range + 2.0 * step, far = laser.max_range - 2.0 * step;
    for (const double range : readings_at(near, laser)) EXPECT_NEAR(range, near, 0.51 * step);
    for (const double range : readings_at(far, laser)) EXPECT_NEAR(range, far, 0.51 * step);
    // Just out of reach, and nothing at all.
    for (const double distance : {1.02 * laser.max_range, 2.0 * laser.max_range}) {
      for (const double range : readings_at(distance, laser)) EXPECT_EQ(range, laser.max_range);
    }
    if (laser.min_range == 0.0) continue;
    for (const double range : readings_at(laser.min_range / 2.0, laser)) {
      EXPECT_EQ(range, 0.0);
    }
  }
}

// Angles [deg], rates [Hz] and limits [m] by the documents that each file names.
TEST(SensorShelf, DescriptionsAgreeWithTheDocumentsThatTheyName) {
  struct Sheet {
    std::string name;
    double fan, step, rate, least, most;
  };
  for (const Sheet& sheet : {
           Sheet{"hokuyo_urg04lx", 239.77, 360.0 / 1024, 10, 0.02, 5.6},
           Sheet{"hokuyo_utm30lx", 270.25, 0.25, 40, 0.1, 60},
           Sheet{"hokuyo_ust10lx", 270.25, 0.25, 40, 0.06, 30},
           Sheet{"rplidar_a1", 360, 1, 5.5, 0.15, 12},
           Sheet{"rplidar_a2", 360, 0.45, 10, 0.2, 12},
           Sheet{"rplidar_s2", 360, 360.0 / 3200, 10, 0.05, 30},
           Sheet{"sick_tim571", 270 + 1.0 / 3, 1.0 / 3, 15, 0.05, 25},
           Sheet{"sick_lms111", 270.5, 0.5, 50, 0.5, 20},
           Sheet{"ldrobot_ld06", 360, 0.8, 10, 0.02, 12},
           Sheet{"ydlidar_x4", 360, 0.72, 10, 0.12, 10},
           Sheet{"robotis_lds01", 360, 1, 5, 0.12, 3.5},
       }) {
    SCOPED_TRACE(sheet.name);
    const LaserModel laser = load_laser(sheet.name);
    EXPECT_NEAR(degrees(laser.beams * laser.bearing_step), sheet.fan, 0.01);
    EXPECT_NEAR(degrees(laser.bearing_step), sheet.step, 1e-6);
    EXPECT_NEAR(laser.scan_rate, sheet.rate, 1e-9);
    EXPECT_NEAR(laser.min_range, sheet.least, 1e-9);
    EXPECT_NEAR(laser.max_range, sheet.most, 1e-9);
    EXPECT_THAT(laser.source, ::testing::Not(::testing::IsEmpty()));
  }
}

}  // namespace
}  // namespace mapbed
