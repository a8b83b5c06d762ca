#include "bench/fetch/corrected_log.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/file/file_reader.h"
#include "core/file/tokens.h"
#include "core/input_error.h"
#include "core/log/public_log.h"

namespace mapbed {
namespace {

struct Planar {
  double x = 0.0, y = 0.0, theta = 0.0;
};

double wrapped(double angle) {
  return std::atan2(std::sin(angle), std::cos(angle));
}

// `pose` after the motion from one place to another. In this order, and with an angle that goes
// on beyond pi: the digits that are written are compared by their checksum.
Planar moved(const Planar& pose, const Planar& from, const Planar& to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double cos_from = std::cos(from.theta);
  const double sin_from = std::sin(from.theta);
  const double ahead = cos_from * dx + sin_from * dy;
  const double left = -sin_from * dx + cos_from * dy;
  const double cos_pose = std::cos(pose.theta);
  const double sin_pose = std::sin(pose.theta);
  return {pose.x + cos_pose * ahead - sin_pose * left, pose.y + sin_pose * ahead + cos_pose * left,
          pose.theta + wrapped(to.theta - from.theta)};
}

class CorrectedLogReader {
 public:
  explicit CorrectedLogReader(std::string path) : path_(std::move(path)) {}

  void take(std::string_view line) {
    ++line_;
    Tokens tokens(line);
    const std::string_view kind = tokens.word();
    if (kind == "ODOM") take_odometry(tokens);
    if (kind == "FLASER") take_scan(tokens);
  }

  std::vector<CorrectedScan> finish() {
    if (scans_.empty()) throw InputError({path_}, "has no FLASER line: no corrected log of CARMEN");
    return std::move(scans_);
  }

 private:
  void take_odometry(Tokens& tokens) {
    const double x = tokens.number();
    const double y = tokens.number();
    const double theta = tokens.number();
    check(tokens);
    const Planar pose{x, y, theta};
    if (!track_) {
      odometry_ = pose;
    } else if (!is_after_scan_) {
      odometry_ = moved(odometry_, *track_, pose);
    }
    is_after_scan_ = false;
    track_ = pose;
  }

  void take_scan(Tokens& tokens) {
    CorrectedScan scan;
    const std::string_view all = without_blanks(tokens.rest());
    const std::size_t beams = tokens.count();
    for (std::size_t beam = 0; beam < beams; ++beam) (void)tokens.word();
    const auto length = static_cast<std::size_t>(tokens.rest().data() - all.data());
    for (double& of : scan.corrected) of = tokens.number();
    for (int i = 0; i < 3; ++i) (void)tokens.number();
    scan.time = tokens.number();
    check(tokens);
    scan.readings = all.substr(0, length);
    scan.odometry[0] = odometry_.x;
    scan.odometry[1] = odometry_.y;
    scan.odometry[2] = wrapped(odometry_.theta);
    scans_.push_back(std::move(scan));
    is_after_scan_ = true;
  }

  void check(const Tokens& tokens) const {
    if (!tokens.ok()) throw InputError({path_, line_}, "is no line of a corrected log of CARMEN");
  }

  std::string path_;
  long line_ = 0;
  std::vector<CorrectedScan> scans_;
  std::optional<Planar> track_;  // the last ODOM line
  Planar odometry_;
  bool is_after_scan_ = false;  // the next ODOM line is the corrected pose
};

}  // namespace

std::vector<CorrectedScan> read_corrected_log(const std::string& path) {
  CorrectedLogReader reader(path);
  FileReader file(path);
  LineSplitter splitter(path);
  const auto take = [&reader](std::string_view line) { reader.take(line); };
  for (std::string_view piece; !(piece = file.next()).empty();) splitter.add(piece, take);
  splitter.finish(take);
  return reader.finish();
}

std::string chained_odometry(const std::vector<CorrectedScan>& scans, const MadeFile& made) {
  std::string text;
  for (const CorrectedScan& scan : scans) {
    const auto& [x, y, theta] = scan.odometry;
    text += fmt::format(
        "FLASER {0} {1:.6f} {2:.6f} {3:.6f} {1:.6f} {2:.6f} {3:.6f} {4:.6f} {5} "
        "{6:.6f}\n",
        scan.readings, x, y, theta, scan.time + made.start, made.host, scan.time);
  }
  return text;
}

std::string corrected_poses(const std::vector<CorrectedScan>& scans, const MadeFile& made) {
  std::string text;
  for (const CorrectedScan& scan : scans) {
    const auto& [x, y, theta] = scan.corrected;
    text += fmt::format("{:.6f} {:.6f} {:.6f} {:.6f}\n", scan.time + made.start, x, y, theta);
  }
  return text;
}

}  // namespace mapbed
