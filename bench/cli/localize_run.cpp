#include "bench/cli/localize_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/plot/map_picture.h"
#include "bench/process/foreign_files.h"
#include "bench/process/version.h"
#include "bench/scenario/publication.h"
#include "core/file/atomic_file.h"
#include "core/file/utf8.h"
#include "core/geometry/tum_file.h"
#include "core/image/png.h"

namespace mapbed {
namespace {

constexpr const char* kMark = "summary.json";
constexpr const char* kCommand = "localize";
const std::vector<std::string> kFiles{"trajectory.tum", "known.csv", "picture.png", "config.yaml",
                                      kMark};

bool is_in(const std::vector<TimeInterval>& intervals, double time) {
  return std::any_of(intervals.begin(), intervals.end(), [time](const TimeInterval& when) {
    return time >= when.from && time <= when.to;
  });
}

// What lies between the lost times, from scan to scan.
std::vector<TimeInterval> known_times(const Estimate& estimate) {
  std::vector<TimeInterval> result;
  bool was_known = false;
  for (const Stamped<Pose2>& stamped : estimate.trajectory) {
    const bool is_known = !is_in(estimate.lost, stamped.time);
    if (is_known && !was_known) result.push_back({stamped.time, stamped.time});
    if (is_known) result.back().to = stamped.time;
    was_known = is_known;
  }
  return result;
}

std::string known_csv(const Estimate& estimate) {
  std::string text = "time [s],known,sigma_x [m],sigma_y [m],sigma_theta [rad]\n";
  for (std::size_t i = 0; i < estimate.trajectory.size(); ++i) {
    const double time = estimate.trajectory[i].time;
    const Eigen::Vector3d sigmas = estimate.covariances[i].diagonal().cwiseMax(0.0).cwiseSqrt();
    text += fmt::format("{:.6f},{},{:.4f},{:.4f},{:.4f}\n", time,
                        is_in(estimate.lost, time) ? 0 : 1, sigmas.x(), sigmas.y(), sigmas.z());
  }
  return text;
}

RgbImage picture_of(const LocalizeRun& run) {
  const Trajectory& path = run.estimate.trajectory;
  std::vector<DrawnPath> paths{{"known", path, run.estimate.lost}};
  if (!run.estimate.lost.empty()) {
    paths.push_back({"not known", path, known_times(run.estimate)});
  }
  return picture_of(*run.map, paths);
}

std::string summary_json(const std::string& log_name, const LocalizeRun& run) {
  const KnownSummary known = known_summary(run.estimate);
  nlohmann::ordered_json json{
      {"command", kCommand},
      {"log", escaped_utf8(log_name)},
      {"map", escaped_utf8(run.map_path)},
      {"tags",
       run.tags_path.empty() ? nlohmann::json() : nlohmann::json(escaped_utf8(run.tags_path))},
      {"seed", run.config.seed},
      {"complete", run.complete},
      {"scans_used", known.scans},
      {"known_scans", known.known_scans},
      {"known_from_s",
       known.known_from < 0.0 ? nlohmann::json() : nlohmann::json(known.known_from)},
      {"times_lost", known.times_lost},
      {"not_known_s", known.lost_seconds},
      {"path_length_m", path_length(run.estimate.trajectory)},
      {"remarks", nlohmann::ordered_json::array()},
      {"mapbed", version().program},
      {"revision", version().revision},
  };
  for (const Remark& remark : run.estimate.remarks) json["remarks"].push_back(remark.text);
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

KnownSummary known_summary(const Estimate& estimate) {
  KnownSummary result;
  if (estimate.trajectory.empty()) return result;
  const double start = estimate.trajectory.front().time;
  bool was_known = false;
  for (const Stamped<Pose2>& stamped : estimate.trajectory) {
    const bool is_known = !is_in(estimate.lost, stamped.time);
    ++result.scans;
    if (is_known) ++result.known_scans;
    if (is_known && result.known_from < 0.0) result.known_from = stamped.time - start;
    if (was_known && !is_known) ++result.times_lost;
    was_known = is_known;
  }
  for (const TimeInterval& lost : estimate.lost) result.lost_seconds += lost.to - lost.from;
  return result;
}

void write_localize_run(const std::string& folder, const std::string& log_name,
                        const LocalizeRun& run) {
  Publication coming(folder, kMark);
  write_trajectory(coming.add("trajectory.tum"), run.estimate.trajectory);
  write_file(coming.add("known.csv"), known_csv(run.estimate));
  write_png(coming.add("picture.png"), picture_of(run));
  write_file(coming.add("config.yaml"), to_yaml(run.config));
  write_file(coming.add(kMark), summary_json(log_name, run));
  coming.commit();
}

void refuse_foreign_localize_files(const std::string& folder) {
  refuse_foreign(folder, kFiles,
                 log_of_localization(folder).empty() ? std::vector<std::string>{} : kFiles);
}

std::string log_of_localization(const std::string& folder) {
  std::ifstream file(std::filesystem::path(folder) / kMark);
  const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
  const bool is_ours = json.is_object() && json.contains("mapbed") && json.contains("log") &&
                       json.value("command", "") == kCommand && json["log"].is_string();
  return is_ours ? json["log"].get<std::string>() : "";
}

}  // namespace mapbed
