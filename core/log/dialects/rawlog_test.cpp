#include "core/log/dialects/rawlog.h"

#include <cstdint>
#include <cstring>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "core/log/log_file.h"
#include "core/log/log_formats.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

LaserScan scan_at(double time, double first_bearing, double bearing_step) {
  LaserScan scan{
      .time = time, .first_bearing = first_bearing, .bearing_step = bearing_step, .max_range = 8.0};
  scan.ranges = {1.5, 0.0, 8.0};
  return scan;
}

RecordedLog log_of(const LaserScan& scan) {
  RecordedLog log;
  log.measurements = {Odometry{.time = scan.time - 1.0},
                      scan_at(scan.time - 1.0, scan.first_bearing, scan.bearing_step),
                      Odometry{.time = scan.time + 1.0, .odometry_from_robot = {2.0, 0.0, 0.0}},
                      scan};
  std::swap(log.measurements[2], log.measurements[3]);
  return log;
}

// What stands `offset` bytes behind the last place of a text.
template <class T>
T behind(const std::string& bytes, const std::string& text, std::size_t offset) {
  T value{};
  const std::size_t at = bytes.rfind(text);
  EXPECT_NE(at, std::string::npos) << text;
  std::memcpy(&value, bytes.data() + at + text.size() + offset, sizeof value);
  return value;
}

std::size_t count(const std::string& bytes, const std::string& text) {
  std::size_t found = 0;
  for (std::size_t at = bytes.find(text); at != std::string::npos; at = bytes.find(text, at + 1)) {
    ++found;
  }
  return found;
}

// Objects of MRPT: 0x80 + length of the class's name, name, version, members, 0x88.
TEST(Rawlog, HasAnActionAndAFrameForEachScan) {
  const std::string bytes = rawlog_bytes(log_of(scan_at(10.0, -0.5, 0.5)));
  EXPECT_EQ(bytes.substr(0, 19),
            "\x91"
            "CActionCollection" +
                std::string(1, '\0'));
  EXPECT_EQ(count(bytes,
                  "\x91"
                  "CActionCollection"),
            2u);
  EXPECT_EQ(count(bytes,
                  "\x8d"
                  "CSensoryFrame\x02"),
            2u);
  EXPECT_EQ(count(bytes,
                  "\x97"
                  "CObservation2DRangeScan\x06"),
            2u);
  EXPECT_EQ(bytes.back(), '\x88');
}

// From where odometry was at the scan before: half-way from 0 to 2 m in half of the time.
TEST(Rawlog, TellsHowOdometryMovedSinceTheScanBefore) {
  const std::string bytes = rawlog_bytes(log_of(scan_at(10.0, -0.5, 0.5)));
  // Version, estimation method (4 bytes), then the increment, an object of its own.
  const std::string movement = "CActionRobotMovement2D";
  const std::size_t pose = 1 + 4 + 1 + std::strlen("CPose2D") + 1;
  EXPECT_DOUBLE_EQ(behind<double>(bytes, movement, pose), 1.0);
  EXPECT_DOUBLE_EQ(behind<double>(bytes, movement, pose + 8), 0.0);
}

TEST(Rawlog, TellsRangesAndWhichOfThemAreMeasurements) {
  const std::string bytes = rawlog_bytes(log_of(scan_at(10.0, -0.5, 0.5)));
  // Version, field of view, direction, maximum range; pose; number, ranges, validity.
  const std::string scan = "CObservation2DRangeScan";
  EXPECT_FLOAT_EQ(behind<float>(bytes, scan, 1), 1.0f);
  EXPECT_EQ(behind<std::uint8_t>(bytes, scan, 5), 1);  // right to left: counter-clockwise
  EXPECT_FLOAT_EQ(behind<float>(bytes, scan, 6), 8.0f);
  const std::size_t number = 10 + 1 + std::strlen("CPose3D") + 1 + 7 * 8 + 1;
  EXPECT_EQ(behind<std::uint32_t>(bytes, scan, number), 3u);
  EXPECT_FLOAT_EQ(behind<float>(bytes, scan, number + 4), 1.5f);
  const std::size_t valid = number + 4 + 3 * 4;
  EXPECT_EQ(behind<std::uint8_t>(bytes, scan, valid), 1);
  EXPECT_EQ(behind<std::uint8_t>(bytes, scan, valid + 1), 0);
  EXPECT_EQ(behind<std::uint8_t>(bytes, scan, valid + 2), 0);
  // Sigma, then ticks of 0.1 us since the beginning of 1601, 11644473600 s before that of 1970.
  EXPECT_EQ(behind<std::uint64_t>(bytes, scan, valid + 3 + 4),
            (11'644'473'600u + 10u) * std::uint64_t{10'000'000});
}

// From 0 to 90 degrees: MRPT's beams lie about the sensor's x axis, which so looks to 45 degrees.
TEST(Rawlog, TurnsTheSensorOfALaserThatLooksToOneSide) {
  const std::string scan = "CObservation2DRangeScan";
  const std::size_t w = 10 + 1 + std::strlen("CPose3D") + 1 + 3 * 8;
  const auto turn = [&](double first, double step) {
    const std::string bytes = rawlog_bytes(log_of(scan_at(10.0, first, step)));
    return 2.0 * std::atan2(behind<double>(bytes, scan, w + 3 * 8), behind<double>(bytes, scan, w));
  };
  EXPECT_NEAR(turn(0.0, radians(45.0)), radians(45.0), 1e-12);
  EXPECT_NEAR(turn(0.0, -radians(45.0)), -radians(45.0), 1e-12);
  EXPECT_NEAR(turn(-radians(45.0), radians(45.0)), 0.0, 1e-12);
}

TEST(LogFormats, AreKnownByName) {
  EXPECT_STREQ(log_format_by_name("rawlog").extension, ".rawlog");
  EXPECT_INPUT_ERROR(log_format_by_name("rawlgo", {"my.yaml", 3}),
                     "my.yaml:3: unknown format of logs 'rawlgo'; did you mean 'rawlog'?");
}

}  // namespace
}  // namespace mapbed
