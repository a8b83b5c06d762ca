#include "bench/process/child_process.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/process/stopwatch.h"
#include "bench/process/supervisor.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr int kAskAgain = 50;  // [ms] whether to go on

[[noreturn]] void refuse(const std::string& what) {
  throw InputError(what + ": " + std::strerror(errno));
}

// A file descriptor that is closed in the end, and in other programs.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void reset(int number = -1) {
    if (number_ >= 0) close(number_);
    number_ = number;
  }

 private:
  int number_;
};

// Two ends that are joined; a socket, as writing to a pipe that nobody reads would end this
// program.
struct Line {
  Descriptor here, there;

  Line() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      refuse("there is no line to another program");
    }
    here.reset(ends[0]);
    there.reset(ends[1]);
  }
};

bool is_program(const fs::path& path) {
  std::error_code failed;
  return fs::is_regular_file(path, failed) && access(path.c_str(), X_OK) == 0;
}

// Waits for the report, or until the program shall end. True: it ended by itself.
bool waits(const Descriptor& report, const Stopwatch& stopwatch, double limit,
           const GoesOn& goes_on, bool& timed_out) {
  for (;;) {
    pollfd waiting{report.number(), POLLIN, 0};
    if (poll(&waiting, 1, kAskAgain) > 0) return true;
    timed_out = limit > 0.0 && stopwatch.seconds() > limit;
    if (timed_out || (goes_on && !goes_on())) return false;
  }
}

SupervisorReport report_from(const Descriptor& report, pid_t supervisor) {
  SupervisorReport told;
  ssize_t size = 0;
  do size = read(report.number(), &told, sizeof told);
  while (size < 0 && errno == EINTR);
  int status = 0;
  while (waitpid(supervisor, &status, 0) < 0 && errno == EINTR) {
  }
  if (size != static_cast<ssize_t>(sizeof told)) {  // somebody killed it
    told = SupervisorReport{};
    told.status = WIFSIGNALED(status) ? WTERMSIG(status) : SIGKILL;
  }
  return told;
}

// The other program, running, with the process between.
class Child {
 public:
  explicit Child(const ChildCommand& command) {
    const std::string path = program_in_path(command.words.front());
    const Descriptor messages(
        open(command.messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600));
    if (messages.number() < 0) refuse(command.messages + " cannot be written");
    std::vector<char*> words;
    for (const std::string& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const SupervisedProgram program{
        .path = path.c_str(),
        .words = words.data(),
        .folder = command.folder.c_str(),
        .leftover = command.leftover.empty() ? nullptr : command.leftover.c_str(),
        .input = command.input,
        .messages = messages.number(),
        .lifeline = lifeline_.there.number(),
        .report = report_.there.number()};
    supervisor_ = fork();
    if (supervisor_ < 0) refuse("there is no process for another program");
    if (supervisor_ == 0) supervise(program);
    lifeline_.there.reset();
    report_.there.reset();
  }

  const Descriptor& report() const { return report_.here; }

  SupervisorReport end() {
    (void)!send(lifeline_.here.number(), "e", 1, MSG_NOSIGNAL);
    return report_from(report_.here, supervisor_);
  }

 private:
  Line lifeline_, report_;
  pid_t supervisor_ = -1;
};

}  // namespace

std::string text_of(const ChildEnd& end, double limit) {
  if (end.timed_out) return fmt::format("was ended after its limit of {:g} s", limit);
  if (end.error != 0) return std::string("cannot be started: ") + std::strerror(end.error);
  if (end.signal == 0) return fmt::format("ended with exit status {}", end.status);
  return fmt::format("was ended by signal {} ({})", end.signal, strsignal(end.signal));
}

ChildEnd run_child(const ChildCommand& command, const GoesOn& goes_on) {
  ChildEnd end;
  const Stopwatch stopwatch;
  Child child(command);
  const bool is_over = waits(child.report(), stopwatch, command.limit, goes_on, end.timed_out);
  const SupervisorReport told = child.end();
  if (!is_over && !end.timed_out) throw Interrupted();
  end.wall_seconds = stopwatch.seconds();
  end.error = told.error;
  end.status = WIFEXITED(told.status) ? WEXITSTATUS(told.status) : 0;
  end.signal = WIFSIGNALED(told.status) ? WTERMSIG(told.status) : 0;
  end.processor_seconds = told.processor_seconds;
  end.peak_memory = told.peak_memory;
  return end;
}

std::string program_in_path(const std::string& name) {
  if (name.find('/') != std::string::npos) {
    return is_program(name) ? fs::absolute(name).string() : "";
  }
  const char* const given = std::getenv("PATH");
  std::string_view path = given == nullptr ? "/usr/bin:/bin" : given;
  while (!name.empty()) {
    const std::size_t end = path.find(':');
    const fs::path folder(path.substr(0, end));
    const fs::path file = fs::absolute(folder.empty() ? "." : folder) / name;
    if (is_program(file)) return file.string();
    if (end == std::string_view::npos) break;
    path.remove_prefix(end + 1);
  }
  return "";
}

}  // namespace mapbed
