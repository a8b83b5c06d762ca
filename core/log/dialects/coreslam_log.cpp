#include "core/log/dialects/coreslam_log.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/file/tokens.h"
#include "core/geometry/angle.h"
#include "core/log/log_builder.h"
#include "core/log/log_reader.h"

namespace mapbed {
namespace {

constexpr std::size_t kBeams = 682;
constexpr double kStep = 2.0 * kPi / 1024.0;   // [rad]
constexpr double kFirst = (44 - 384) * kStep;  // [rad]
constexpr double kMaxRange = 5.6;              // [m]
constexpr double kLeastRange = 0.020;          // [m]
constexpr double kLaserAhead = 0.145;          // [m]

class CoreslamReader : public LogLineReader {
 public:
  CoreslamReader(const std::string& name, const LogOptions& options)
      : LogLineReader(name), builder_(name, options), wheels_(options.wheels) {}

  void add_line(std::string_view line, long number) override {
    Tokens tokens(line);
    values_.clear();
    while (!tokens.at_end()) values_.push_back(tokens.word());
    if (values_.empty() || values_[0][0] == '#') return;
    const std::size_t before = values_.size() < kBeams ? 0 : values_.size() - kBeams;
    if (before != 25 && before != 13)
      return builder_.broken(number, "truncated or garbled CoreSLAM line: left out");

    ok_ = true;
    const double time = number_at(0) * 1e-6;
    const bool recent = before == 25;
    const double left = number_at(recent ? 2 : 1);
    const double right = recent ? number_at(3) : -number_at(2);
    LaserScan scan;
    scan.time = time;
    scan.robot_from_laser.planar.x = kLaserAhead;
    scan.first_bearing = kFirst;
    scan.bearing_step = kStep;
    scan.max_range = kMaxRange;
    scan.ranges.reserve(kBeams);
    for (std::size_t beam = 0; beam < kBeams; ++beam) {
      const double range = number_at(before + beam) * 1e-3;
      scan.ranges.push_back(range >= 0.0 && range < kLeastRange ? 0.0 : range);
    }
    if (!ok_) return builder_.broken(number, "truncated or garbled CoreSLAM line: left out");
    builder_.add(Odometry{time, follow(left, right)}, number);
    builder_.add(std::move(scan), number);
  }

  RecordedLog finish_lines() override { return builder_.finish("CoreSLAM"); }

 private:
  double number_at(std::size_t field) {
    const std::string_view word = values_[field];
    double value = 0.0;
    const char* const end = word.data() + word.size();
    if (read_number(word.data(), end, value) != end) ok_ = false;
    return value;
  }

  // Dead reckoning along an arc: half the turn, the chord, the other half.
  Pose2 follow(double left, double right) {
    if (ticks_) {
      const double meters_per_tick = 2.0 * kPi * wheels_.wheel_radius / wheels_.ticks_per_turn;
      const double left_arc = meters_per_tick * (left - ticks_->first);
      const double right_arc =
          meters_per_tick * wheels_.left_right_ratio * (right - ticks_->second);
      const double turn = (right_arc - left_arc) / (2.0 * wheels_.half_track);
      const double arc = 0.5 * (left_arc + right_arc);
      const double chord = std::abs(turn) < 1e-9 ? arc : arc * std::sin(turn / 2) / (turn / 2);
      pose_ = pose_ *
              Pose2{chord * std::cos(turn / 2), chord * std::sin(turn / 2), normalized_angle(turn)};
    }
    ticks_ = {left, right};
    return pose_;
  }

  LogBuilder builder_;
  WheelGeometry wheels_;
  std::vector<std::string_view> values_;
  bool ok_ = true;
  std::optional<std::pair<double, double>> ticks_;
  Pose2 pose_;
};

bool fits(const LogBeginning& beginning) {
  Tokens tokens(beginning.line);
  tokens.number();
  return tokens.ok() && words_in(beginning.line) > 600;
}

}  // namespace

LogDialect coreslam_dialect() {
  return {"CoreSLAM", fits,
          [](const std::string& name, const LogOptions& options) -> std::unique_ptr<LogReader> {
            return std::make_unique<CoreslamReader>(name, options);
          }};
}

}  // namespace mapbed
