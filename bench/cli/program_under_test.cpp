#include "bench/cli/program_under_test.h"

#include <cstdlib>
#include <filesystem>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/check.h"
#include "core/file/text_file.h"

namespace mapbed {
namespace {

// In the child: never returns.
[[noreturn]] void become(const std::vector<std::string>& command, const std::string& folder,
                         const std::string& out, const std::string& err) {
  const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(out_file, STDOUT_FILENO);
  dup2(err_file, STDERR_FILENO);
  if (chdir(folder.c_str()) != 0) _exit(126);
  setenv("MAPBED", MAPBED_PROGRAM, 1);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(words[0], words.data());
  _exit(127);
}

Outcome run(const std::vector<std::string>& command, const std::string& folder) {
  const std::string base =
      std::filesystem::temp_directory_path() / ("mapbed_cli_" + std::to_string(getpid()));
  const pid_t child = fork();
  CHECK(child >= 0);
  if (child == 0) become(command, folder, base + ".out", base + ".err");
  int status = 0;
  CHECK(waitpid(child, &status, 0) == child);
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                  read_text_file(base + ".out"), read_text_file(base + ".err")};
  std::filesystem::remove(base + ".out");
  std::filesystem::remove(base + ".err");
  return outcome;
}

}  // namespace

Outcome run_mapbed(const std::vector<std::string>& arguments, const std::string& folder) {
  std::vector<std::string> command{MAPBED_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run(command, folder);
}

Outcome run_shell(const std::string& script, const std::string& folder) {
  return run({"/bin/sh", "-c", script}, folder);
}

}  // namespace mapbed
