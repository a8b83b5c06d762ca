#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/interrupt.h"
#include "bench/cli/output_folder.h"
#include "bench/cli/progress.h"
#include "bench/fetch/fetch_log.h"
#include "bench/process/folder_lock.h"
#include "core/data_path.h"
#include "core/input_error.h"
#include "core/interrupted.h"
#include "core/log/log_description.h"
#include "core/log/public_log.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

struct FetchArguments {
  std::vector<std::string> names;
  bool all = false;
  std::string to;
  std::string from;
  bool force = false;
};

std::string data_folder() {
  const char* const data = std::getenv("MAPBED_DATA");
  return data == nullptr ? "" : data;
}

constexpr const char* kHowToSet =
    "export MAPBED_DATA=$HOME/mapbed_data (in ~/.profile, too, for later)";

std::vector<LogDescription> all_logs() {
  std::vector<LogDescription> logs;
  for (const std::string& name : data_names("scenarios/logs")) {
    logs.push_back(load_log_description(find_data_file("log", "scenarios/logs", name).string()));
  }
  return logs;
}

std::string name_of(const LogDescription& log) {
  return fs::path(log.yaml_path).stem().string();
}

// [bytes] of all that is to be got for it.
std::uint64_t download_of(const LogDescription& log) {
  const PublicLog files = load_public_log(log.yaml_path);
  std::set<std::string> needed;
  for (const MadeFile& made : files.made) needed.insert(made.piece);
  std::uint64_t bytes = 0;
  for (const PublicFile& piece : files.pieces) bytes += needed.count(piece.file) * piece.bytes;
  return bytes;
}

std::string state_of(const LogDescription& log) {
  if (is_here(log)) return "here";
  if (!can_be_fetched(log)) return "by hand";
  return fmt::format("to be got, {:.1f} MB", 1e-6 * static_cast<double>(download_of(log)));
}

int list_logs() {
  for (const LogDescription& log : all_logs()) {
    fmt::print("{:<18} {:<18} {}\n", name_of(log), state_of(log), log.about);
  }
  const std::string folder = data_folder();
  fmt::print(
      "\n'mapbed fetch NAME' gets one, or says the steps; 'mapbed fetch --all' gets all that "
      "can be got\n");
  fmt::print("folder: {}\n",
             folder.empty() ? std::string("MAPBED_DATA is not set; ") + kHowToSet : folder);
  return kDone;
}

void print_about(const LogDescription& log) {
  fmt::print("{}: {}\n", name_of(log), log.about);
  fmt::print("source: {}\nlicence: {}\n", log.source, log.licence);
  const PublicLog files = load_public_log(log.yaml_path);
  if (!files.cite.empty()) fmt::print("to cite: {}\n", files.cite);
  std::fflush(stdout);  // before what takes its time
}

// A line on a terminal, or every ten seconds, of the file that comes.
class DownloadProgress {
 public:
  void tell(const std::string& file, std::uint64_t bytes, std::uint64_t all) {
    if (file != file_) {
      file_ = file;
      progress_.reset();
      if (all == 0) {
        progress_.emplace(file);
      } else {
        progress_.emplace(file + " [kB]", all / 1000);
      }
    }
    progress_->advance_to(bytes / 1000);
  }
  void stop() {
    progress_.reset();
    file_.clear();
  }

 private:
  std::string file_;
  std::optional<Progress> progress_;
};

void fetch(const LogDescription& log, const FetchOptions& options,
           const InterruptGuard& interrupt) {
  print_about(log);
  DownloadProgress progress;
  const FetchListener listener{
      .say =
          [&](const std::string& line) {
            progress.stop();
            fmt::print("{}\n", line);
            std::fflush(stdout);
          },
      .goes_on =
          [&](const std::string& file, std::uint64_t so_far, std::uint64_t all) {
            progress.tell(file, so_far, all);
            return !interrupt.was_interrupted();
          }};
  fetch_log(log, options, listener);
}

std::vector<LogDescription> chosen_logs(const FetchArguments& arguments) {
  if (!arguments.all) {
    std::vector<LogDescription> logs;
    for (const std::string& name : arguments.names) {
      logs.push_back(load_log_description(find_data_file("log", "scenarios/logs", name).string()));
    }
    return logs;
  }
  if (!arguments.names.empty()) throw InputError("--all is all of them; leave the names out");
  std::vector<LogDescription> logs = all_logs();
  if (arguments.from.empty()) {
    std::erase_if(logs, [](const LogDescription& log) { return !can_be_fetched(log); });
  }
  return logs;
}

FetchOptions options_for(const FetchArguments& arguments) {
  const std::string folder = arguments.to.empty() ? data_folder() : arguments.to;
  if (folder.empty()) {
    throw InputError({"MAPBED_DATA"}, "is not set, so nobody knows where logs are kept",
                     std::string(kHowToSet) + ", or name a folder with --to");
  }
  return {fs::absolute(folder).lexically_normal().string(), arguments.from, arguments.force};
}

bool is_folder_of_data(const std::string& folder) {
  std::error_code none;
  const std::string data = data_folder();
  return !data.empty() && fs::equivalent(data, folder, none);
}

bool is_all_here(const LogDescription& log, const std::string& folder) {
  const auto files = stored_files(log);
  return std::all_of(files.begin(), files.end(), [&](const StoredFile* stored) {
    return presence_of(*stored, log, folder) == Presence::here;
  });
}

// One that cannot be got keeps none of the others away: it is told, and the status says so.
int fetch_all(const std::vector<LogDescription>& logs, const FetchOptions& options) {
  const InterruptGuard interrupt;
  int status = kDone;
  for (const LogDescription& log : logs) {
    try {
      fetch(log, options, interrupt);
    } catch (const InputError& error) {
      if (logs.size() == 1) throw;
      std::fflush(stdout);
      fmt::print(stderr, "mapbed: {}\n", error.what());
      status = kWrongInput;
    } catch (const Interrupted&) {
      fmt::print(stderr, "mapbed: interrupted; what has come is kept: the same command goes on\n");
      return kInterrupted;
    }
    if (&log != &logs.back()) fmt::print("\n");
  }
  return status;
}

int fetch_logs(const FetchArguments& arguments) {
  if (arguments.names.empty() && !arguments.all) return list_logs();
  const std::vector<LogDescription> logs = chosen_logs(arguments);
  const FetchOptions options = options_for(arguments);
  std::optional<OutputFolder> made;
  std::optional<FolderLock> lock;
  const bool is_work = std::any_of(logs.begin(), logs.end(), [&](const LogDescription& log) {
    return !is_all_here(log, options.folder);
  });
  if (is_work) {
    made.emplace(options.folder, "--to");
    lock.emplace(options.folder, 0.0, "--to");
  }
  const int status = fetch_all(logs, options);
  if (status == kDone && !is_folder_of_data(options.folder)) {
    fmt::print("for the other commands: export MAPBED_DATA={}\n", options.folder);
  }
  return status;
}

}  // namespace

Command fetch_command() {
  const auto a = std::make_shared<FetchArguments>();
  return {.name = "fetch",
          .help = "Get public logs: list them, or bring some here",
          .options = {{"NAME", &a->names,
                       "logs, as 'mapbed list logs' names them, or files (YAML) that describe one; "
                       "left out: which there are, and which of them are here"},
                      {"--all", &a->all, "all that can be got without work by hand"},
                      {"--to", &a->to, "folder for them; MAPBED_DATA where left out"},
                      {"--from", &a->from,
                       "a folder that has them, or the address (http, https) of a mirror: finished "
                       "files or the public ones that they are made of, with or without folders"},
                      {"--force", &a->force, "replace files that are not the described ones"}},
          .run = [a] { return fetch_logs(*a); }};
}

}  // namespace mapbed
