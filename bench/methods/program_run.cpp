#include "bench/methods/program_run.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "algorithms/scan/level_lasers.h"
#include "bench/methods/command_text.h"
#include "bench/methods/geometry_file.h"
#include "bench/methods/work_folder.h"
#include "bench/process/child_process.h"
#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/geometry/tum_file.h"
#include "core/log/log_file.h"
#include "core/log/log_formats.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr double kSameStamp = 1e-3;     // [s] programs write stamps with so many digits at least
constexpr double kLeastFraction = 0.9;  // of the scans that have a pose
constexpr std::uint64_t kSeeds = 1u << 31;  // that fit a whole number of any program
constexpr std::size_t kMostMessages = std::size_t{1} << 20;  // [bytes] that are kept of them
constexpr std::size_t kLargestKept = std::size_t{1} << 27;   // [bytes] of a file

std::string stamps_text(const SensorLog& log) {
  std::string text;
  for (const Measurement& measurement : log) {
    if (std::holds_alternative<LaserScan>(measurement)) {
      text += fmt::format("{:.6f}\n", time_of(measurement));
    }
  }
  return text;
}

// What goes into its folder, which is empty for the program but for its own files: these stand in
// another one beside it.
struct Folders {
  WorkFolder whole;
  std::string out = whole.path("out");
  std::string messages = whole.path("messages");
};

Placeholders given_files(const ProgramMethod& method, const SensorLog& log, std::uint64_t seed,
                         const Folders& folders) {
  const LogFormat& format = log_format_by_name(method.log_format);
  Placeholders values(method.files.begin(), method.files.end());
  values.insert(method.options.begin(), method.options.end());
  values["log"] = folders.whole.path(std::string("log") + format.extension);
  values["geometry"] = folders.whole.path("geometry.json");
  values["stamps"] = folders.whole.path("stamps.txt");
  values["out"] = folders.out;
  values["seed"] = fmt::to_string(seed % kSeeds);
  RecordedLog recorded;
  recorded.measurements = log;
  format.write(values["log"], recorded);
  write_file(values["geometry"], geometry_json(log), Durability::unsynced);
  write_file(values["stamps"], stamps_text(log), Durability::unsynced);
  return values;
}

ChildCommand command_of(const ProgramMethod& method, const Placeholders& values,
                        const Folders& folders) {
  ChildCommand command{.words = {},
                       .folder = folders.out,
                       .messages = folders.messages,
                       .limit = method.limit,
                       .leftover = folders.whole.path(".")};
  if (method.is_shell) {
    command.words = {"sh", "-e", "-c", filled_for_shell(method.command.front(), values)};
  } else {
    for (const std::string& word : method.command) command.words.push_back(filled(word, values));
  }
  return command;
}

// The last of them, where they are many.
std::string messages_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::size_t>(std::max<std::streamoff>(file.tellg(), 0));
  const std::size_t kept = std::min(size, kMostMessages);
  file.seekg(static_cast<std::streamoff>(size - kept));
  std::string text(kept, '\0');
  file.read(text.data(), static_cast<std::streamsize>(kept));
  return text;
}

Trajectory path_of(const ProgramMethod& method, const Folders& folders) {
  const fs::path path = fs::path(folders.out) / method.trajectory;
  if (!fs::is_regular_file(path)) {
    throw InputError({method.name}, "wrote no " + method.trajectory,
                     "it is to write it into the folder where it runs, '{out}', or 'trajectory' in "
                     "its file names another one");
  }
  return parse_trajectory(method.name + ": " + method.trajectory, read_text_file(path.string()));
}

void keep_files(const ProgramMethod& method, const Folders& folders, ProgramRun& run) {
  for (const std::string& name : method.keep) {
    const fs::path path = fs::path(folders.out) / name;
    if (fs::is_regular_file(path) && fs::file_size(path) <= kLargestKept) {
      std::ifstream file(path, std::ios::binary);
      run.kept.emplace_back(name, std::string(std::istreambuf_iterator<char>(file), {}));
    } else {
      run.estimate.remarks.push_back(
          {RemarkKind::note,
           fmt::format("{} wrote no {}, which it was to keep", method.name, name)});
    }
  }
}

// At the ends within a stamp's rounding.
std::optional<Pose2> pose_near(const Trajectory& path, double time) {
  const double inside = std::clamp(time, path.front().time, path.back().time);
  return std::abs(inside - time) <= kSameStamp ? pose_at(path, inside) : std::nullopt;
}

}  // namespace

Estimate estimate_at_scans(const std::string& name, const Trajectory& path, const SensorLog& log) {
  Estimate estimate;
  LevelLasers level;
  std::size_t scans = 0;
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || !level.take(*scan)) continue;
    ++scans;
    if (const auto pose = pose_near(path, scan->time)) {
      estimate.trajectory.push_back({scan->time, *pose});
    }
  }
  const std::size_t known = estimate.trajectory.size();
  if (static_cast<double>(known) < kLeastFraction * static_cast<double>(scans)) {
    throw InputError(
        {name},
        fmt::format("has poses for {} of the log's {} scans: its stamps go from {:.3f} to {:.3f}, "
                    "the log's from {:.3f} to {:.3f}",
                    known, scans, path.front().time, path.back().time, time_of(log.front()),
                    time_of(log.back())),
        "a trajectory's stamps are those of the log, and reach over nine in ten of its scans");
  }
  estimate.remarks = level.remarks();
  if (known < scans) {
    estimate.remarks.push_back(
        {RemarkKind::note,
         fmt::format("{} has poses for {} of {} scans; those before its first and after its last "
                     "pose are left out",
                     name, known, scans)});
  }
  return estimate;
}

ProgramRun run_program_method(const ProgramMethod& method, const SensorLog& as_recorded,
                              const SensorLog& prepared, std::uint64_t seed,
                              const GoesOn& goes_on) {
  for (const InputFile& file : method.input_files) check_unchanged(file);
  const Folders folders;
  fs::create_directory(folders.out);
  const Placeholders values = given_files(method, as_recorded, seed, folders);
  const ChildCommand command = command_of(method, values, folders);
  throw_unless(goes_on);
  const ChildEnd end = run_child(command, goes_on);
  try {
    if (!end.is_success()) throw InputError(method.name + " " + text_of(end, method.limit));
    ProgramRun run{.estimate = estimate_at_scans(method.name, path_of(method, folders), prepared),
                   .cost = {end.wall_seconds, end.processor_seconds, end.peak_memory},
                   .kept = {}};
    keep_files(method, folders, run);
    return run;
  } catch (const InputError& error) {
    throw ProgramFailed(error.what(), messages_in(folders.messages));
  }
}

}  // namespace mapbed
