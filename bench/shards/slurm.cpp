#include "bench/shards/slurm.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "bench/process/child_process.h"
#include "bench/shards/shard_folders.h"
#include "core/file/atomic_file.h"
#include "core/file/hash.h"
#include "core/file/parse_number.h"
#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr double kLimit = 60.0;  // [s] for an answer

// Of the names of all jobs that are submitted for a folder, whatever it is called.
std::string job_prefix(const std::string& folder) {
  return "mapbed_" + sha256(fs::canonical(folder).string()).substr(0, 12) + "_";
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string in_one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

// What a program of Slurm prints, errors and all.
std::string answer_of(const std::vector<std::string>& words) {
  if (program_in_path(words.front()).empty()) {
    throw InputError({words.front()}, "there is no such program in PATH",
                     "call this where Slurm is, or hand each '--shard 1/8', '2/8', … to another "
                     "scheduler");
  }
  const fs::path messages =
      fs::temp_directory_path() / fmt::format("mapbed_{}_{}", words.front(), getpid());
  const ChildEnd end = run_child({.words = words,
                                  .folder = fs::current_path().string(),
                                  .messages = messages.string(),
                                  .limit = kLimit});
  const std::string answer = read_text_file(messages.string());
  fs::remove(messages);
  if (end.is_success()) return answer;
  throw InputError({words.front()},
                   fmt::format("{}: {}", text_of(end, kLimit), in_one_line(answer)),
                   "see what Slurm says of it; the runs so far are kept");
}

// "1-3,7": numbers of shards, which come in their order.
std::string array_of(const std::vector<Shard>& shards) {
  std::string text;
  for (std::size_t i = 0; i < shards.size();) {
    std::size_t last = i;
    while (last + 1 < shards.size() && shards[last + 1].index == shards[last].index + 1) ++last;
    if (!text.empty()) text += ',';
    text += last == i ? fmt::format("{}", shards[i].index)
                      : fmt::format("{}-{}", shards[i].index, shards[last].index);
    i = last + 1;
  }
  return text;
}

std::string script_of(const ShardSubmission& submission) {
  std::string script = "#!/bin/sh\nexec";
  for (const std::string& word : submission.command) script += " " + quoted(word);
  return script +
         fmt::format(" --shard \"$SLURM_ARRAY_TASK_ID/{}\"\n", submission.shards.front().count);
}

// Slurm puts numbers in place of what stands behind a '%'.
std::string without_patterns(const std::string& path) {
  std::string text;
  for (const char c : path) text += c == '%' ? std::string("%%") : std::string(1, c);
  return text;
}

// The number of the job, on a line of its own: "12" or "12;cluster".
std::string job_in(std::string_view answer) {
  std::string job;
  while (!answer.empty()) {
    const std::string_view line = next_line(answer);
    const std::string_view word = line.substr(0, line.find(';'));
    const bool is_number = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
      return c >= '0' && c <= '9';
    });
    if (is_number) job = word;
  }
  return job;
}

}  // namespace

bool has_slurm() {
  return !program_in_path("squeue").empty();
}

// The folder stays that of the caller, where the scenario's file is found.
void check_sbatch_options(const std::vector<std::string>& options) {
  const auto refuse = [](const std::string& name) {
    throw InputError({}, "sbatch's option " + name + " is chosen by mapbed", "leave it out");
  };
  for (const std::string& option : options) {
    const std::string name = option.substr(0, option.find('='));
    for (const char* own : {"--array", "--chdir", "--job-name", "--parsable", "--wrap"}) {
      if (name == own) refuse(own);
    }
    for (const char* own : {"-a", "-D", "-J"}) {
      if (option.starts_with(own)) refuse(own);
    }
  }
}

std::string messages_of(const Shard& shard) {
  return fmt::format("{}/{}_of_{}.txt", kSlurmFiles, shard.index, shard.count);
}

std::string submit_to_slurm(const ShardSubmission& submission) {
  const int count = submission.shards.front().count;
  const fs::path files = fs::canonical(submission.folder) / kSlurmFiles;
  fs::create_directories(files);
  const std::string script = (files / fmt::format("task_of_{}.sh", count)).string();
  write_file(script, script_of(submission));
  std::vector<std::string> words{
      "sbatch", "--requeue", "--open-mode=append",
      fmt::format("--cpus-per-task={}", submission.processors),
      fmt::format("--output={}/%a_of_{}.txt", without_patterns(files.string()), count)};
  words.insert(words.end(), submission.options.begin(), submission.options.end());
  words.insert(words.end(),
               {"--parsable", "--array=" + array_of(submission.shards),
                fmt::format("--job-name={}{}", job_prefix(submission.folder), count), script});
  const std::string answer = answer_of(words);
  const std::string job = job_in(answer);
  if (!job.empty()) return job;
  throw InputError({"sbatch"}, "names no job: " + in_one_line(answer),
                   "see what Slurm says of it; 'squeue' tells what was submitted");
}

// One line a task: name of the job, number in the array, state, reason.
std::vector<QueuedShard> queued_in_slurm(const std::string& folder) {
  const std::string prefix = job_prefix(folder);
  const std::string answer =
      answer_of({"squeue", "--noheader", "--me", "--array", "-o", "%j|%K|%T|%r"});
  std::vector<QueuedShard> queued;
  for (std::string_view left = answer; !left.empty();) {
    const std::string_view line = next_line(left);
    if (!line.starts_with(prefix)) continue;
    std::vector<std::string> words;
    for (std::string_view rest = line; words.size() < 4;) {
      const std::size_t end = rest.find('|');
      words.emplace_back(rest.substr(0, end));
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    QueuedShard task;
    if (!parse_number(words[0].substr(prefix.size()), task.shard.count) ||
        !parse_number(words[1], task.shard.index)) {
      continue;
    }
    const bool has_reason = !words[3].empty() && words[3] != "None";
    task.state = words[2] + (has_reason ? " (" + words[3] + ")" : "");
    queued.push_back(task);
  }
  return queued;
}

}  // namespace mapbed
