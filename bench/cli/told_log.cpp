#include "bench/cli/told_log.h"

#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

namespace mapbed {

namespace fs = std::filesystem;

std::string name_of_log(const std::string& path) {
  fs::path file = fs::path(path).has_filename() ? fs::path(path) : fs::path(path).parent_path();
  file = file.filename();
  if (file.extension() == ".gz") file = file.stem();
  const std::string name = file.stem().string();
  return name.empty() ? "log" : name;
}

void print_log(const std::string& path, const RecordedLog& log, double seconds) {
  int scans = 0;
  int readings = 0;
  for (const Measurement& measurement : log.measurements) {
    if (std::holds_alternative<LaserScan>(measurement)) ++scans;
    if (std::holds_alternative<Odometry>(measurement)) ++readings;
  }
  fmt::print("{}: {}, {} scans, {} odometry readings, {:.1f} s recorded; read in {:.2f} s\n", path,
             log.format, scans, readings,
             time_of(log.measurements.back()) - time_of(log.measurements.front()), seconds);
  for (const RecordedLaser& laser : log.lasers) fmt::print("{}\n", to_string(laser));
  for (const LogWarning& warning : log.warnings) {
    fmt::print(stderr, "warning: {}\n", to_string(warning));
  }
}

}  // namespace mapbed
