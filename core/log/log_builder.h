#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/log/bearings.h"
#include "core/log/log_file.h"

namespace mapbed {

class Tokens;

// Collects what a dialect's reader finds line by line, watches the stamps and ranges, and completes
// the scans at the end: geometry that the lines did not have, maximum range, order of time.
//
// A scan with bearing_step 0 gets its bearings, one whose robot_from_laser is kMountToBeTold its
// place on the robot from the number of its beams, the parameters and the options; see bearings.h
// and laser_geometry.h.
inline constexpr Pose2 kMountToBeTold{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};

class LogBuilder {
 public:
  // What the numbers count by which messages say where something is.
  enum class Place { line, message };
  LogBuilder(std::string name, const LogOptions& options, Place counted = Place::line);

  const std::string& name() const { return name_; }
  const LogOptions& options() const { return options_; }
  void add(Odometry odometry, long line);
  void add(LaserScan scan, long line);
  void add(RfidDetections round, long line);
  void add_true_pose(const Stamped<Pose2>& pose, long line);
  void set_parameter(std::string name, std::string value, long line);
  // First bearing and step of a scan as its line has them, its field of view [0: not told].
  void state_bearings(LaserScan& scan, double field_of_view, long line);
  // A message was left out; `example`, of the first one of its kind, is part of the remark.
  void broken(long line, const std::string& reason, const std::string& example = {});
  void garbled(long line, const std::string& kind, const Tokens& tokens);  // FLASER: not ok() there
  // A message was read, with a remark.
  void warn(long line, const std::string& reason, const std::string& example = {});
  void forget_scans();  // all so far
  long scans() const { return scans_; }

  RecordedLog finish(const std::string& format);  // throws InputError

 private:
  struct Readings {
    long all = 0, zeros = 0;
  };
  struct LastScan {
    double time = 0.0;
    std::size_t beams = 0;
  };

  SourceLocation place(long line) const;
  bool stamp_is_usable(double time, long line);
  void leave_out(long line, const std::string& reason, const std::string& example = {});
  void account(std::size_t bytes, long line);
  void clean_ranges(LaserScan& scan, long line);
  void look_at_zeros();
  [[noreturn]] void refuse_unknown_scans(const std::map<std::size_t, long>& scans_of_beams) const;
  void complete_geometry();
  void check_counts() const;

  std::string name_;
  LogOptions options_;
  Place counted_;
  RecordedLog log_;
  std::map<std::string, std::size_t> warning_of_reason_;
  std::map<int, LastScan> last_scan_of_laser_;
  std::map<int, Readings> readings_of_laser_;  // as the log has them
  std::map<std::size_t, long> first_line_of_beams_;
  std::map<std::string, long> line_of_parameter_;
  std::map<int, Bearings> other_bearings_;  // that lines of a laser can mean, too
  double newest_ = -1e300;                  // [s]
  bool out_of_order_ = false;
  long line_gone_back_ = 0;  // the last message's, where its stamp was far too old
  double memory_ = 0.0;      // [bytes]
  long messages_ = 0;        // broken ones among them
  long scans_ = 0;
  long broken_ = 0;
  LogWarning first_broken_;
  std::string remedy_;  // of the first one
};

}  // namespace mapbed
