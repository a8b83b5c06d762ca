#include "bench/process/supervisor.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace mapbed {
namespace {

constexpr int kLifeline = 3, kReport = 4;  // descriptors, behind the standard ones
constexpr int kFirstFree = 10;             // those below are for what stays
constexpr int kMostOpen = 4096;            // that older kernels are asked to close
constexpr int kLookAgain = 20;             // [ms] at the program's memory
constexpr int kNotStarted = 127;           // exit status, as shells have it

// At the number `to`, closed where another program begins.
void place(int descriptor, int to) {
  dup2(descriptor, to);
  fcntl(to, F_SETFD, to > STDERR_FILENO ? FD_CLOEXEC : 0);
}

// Keeps these and closes all others: pipes of other runs, logs, locks.
void keep_only(SupervisedProgram& program) {
  if (program.input < 0) program.input = open("/dev/null", O_RDONLY);
  for (int* descriptor : {&program.input, &program.messages, &program.lifeline, &program.report}) {
    *descriptor = fcntl(*descriptor, F_DUPFD, kFirstFree);
  }
  place(program.input, STDIN_FILENO);
  place(program.messages, STDOUT_FILENO);
  place(program.messages, STDERR_FILENO);
  place(program.lifeline, kLifeline);
  place(program.report, kReport);
  program.lifeline = kLifeline;
  program.report = kReport;
#ifdef SYS_close_range
  if (syscall(SYS_close_range, kReport + 1, ~0u, 0u) == 0) return;
#endif
  for (int descriptor = kReport + 1; descriptor < kMostOpen; ++descriptor) close(descriptor);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigaction(signal, &action, nullptr);
}

// What a terminal or a user tells this program's group is for mapbed, who decides.
void ignore_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) handle(signal, SIG_IGN);
}

[[noreturn]] void become(const SupervisedProgram& program, int failed, pid_t supervisor) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) handle(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() == supervisor && chdir(program.folder) == 0) {
    execve(program.path, program.words, environ);
  }
  const int error = errno;
  (void)!write(failed, &error, sizeof error);
  _exit(kNotStarted);
}

// The number behind `name` in a text of /proc; 0 where it is not there.
double number_behind(const char* text, const char* name) {
  const char* found = std::strstr(text, name);
  if (found == nullptr) return 0.0;
  double number = 0.0;
  for (found += std::strlen(name); *found == ' ' || *found == '\t'; ++found) {
  }
  for (; *found >= '0' && *found <= '9'; ++found) number = 10.0 * number + (*found - '0');
  return number;
}

// A path below /proc, without memory of its own.
class ProcPath {
 public:
  ProcPath& add(const char* text) {
    while (*text != '\0') *end_++ = *text++;
    *end_ = '\0';
    return *this;
  }
  ProcPath& add(pid_t process) {
    char digits[16];
    char* first = digits + sizeof digits - 1;
    for (*first = '\0'; process > 0; process /= 10) {
      *--first = static_cast<char>('0' + process % 10);
    }
    return add(first);
  }

  // The beginning of the file; empty where there is none.
  template <std::size_t size>
  void read_into(char (&text)[size]) const {
    const int file = open(path_, O_RDONLY | O_CLOEXEC);
    const ssize_t read_bytes = file < 0 ? 0 : read(file, text, size - 1);
    if (file >= 0) close(file);
    text[std::max<ssize_t>(read_bytes, 0)] = '\0';
  }

 private:
  char path_[96] = {};
  char* end_ = path_;
};

// Calls `visit` for each number of a text of blanks and digits.
template <class Visit>
void each_process(const char* text, Visit&& visit) {
  pid_t process = 0;
  for (; *text != '\0'; ++text) {
    if (*text >= '0' && *text <= '9') {
      process = 10 * process + (*text - '0');
    } else if (process > 0) {
      visit(process);
      process = 0;
    }
  }
}

// [bytes] the most that it or one that it started has had so far; 0 where they are over.
double peak_memory_of(pid_t process, int generations = 8) {
  char text[4096];
  ProcPath().add("/proc/").add(process).add("/status").read_into(text);
  double peak = 1024.0 * number_behind(text, "VmHWM:");
  if (generations == 0) return peak;
  ProcPath().add("/proc/").add(process).add("/task/").add(process).add("/children").read_into(text);
  each_process(text,
               [&](pid_t child) { peak = std::max(peak, peak_memory_of(child, generations - 1)); });
  return peak;
}

// Those that were started by children that are over are children of this process by then.
void kill_children() {
  char text[4096];
  ProcPath().add("/proc/thread-self/children").read_into(text);
  each_process(text, [](pid_t child) { kill(child, SIGKILL); });
}

void kill_all(pid_t group) {
  kill(-group, SIGKILL);
  for (;;) {
    kill_children();
    const pid_t over = waitpid(-1, nullptr, WNOHANG);
    if (over < 0 && errno == ECHILD) return;
    if (over == 0) poll(nullptr, 0, 1);
  }
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// A process begins with the memory of the one that started it in its account: what is not above
// this one's own is known only by having looked.
void take_costs(double looked, SupervisorReport& report) {
  rusage own{}, children{};
  getrusage(RUSAGE_SELF, &own);
  getrusage(RUSAGE_CHILDREN, &children);
  report.processor_seconds = seconds(children.ru_utime) + seconds(children.ru_stime);
  const bool is_exact = children.ru_maxrss > own.ru_maxrss;
  report.peak_memory =
      is_exact ? std::max(looked, 1024.0 * static_cast<double>(children.ru_maxrss)) : looked;
}

// True where the program ended by itself.
bool watch(pid_t child, int lifeline, int children, int& status, double& memory) {
  for (;;) {
    memory = std::max(memory, peak_memory_of(child));
    pollfd waiting[] = {{lifeline, POLLIN, 0}, {children, POLLIN, 0}};
    poll(waiting, 2, memory == 0.0 ? 1 : kLookAgain);
    if (waiting[1].revents != 0) {
      signalfd_siginfo ignored;
      (void)!read(children, &ignored, sizeof ignored);
    }
    int of_one = 0;
    for (pid_t over = 0; (over = waitpid(-1, &of_one, WNOHANG)) > 0;) {
      if (over != child) continue;
      status = of_one;
      return true;
    }
    if (waiting[0].revents != 0) return false;
  }
}

// Somebody closed the lifeline without a word: the program that waited for this is gone.
bool is_orphaned(int lifeline) {
  char word = 0;
  pollfd waiting{lifeline, POLLIN, 0};
  return poll(&waiting, 1, 0) > 0 && read(lifeline, &word, 1) == 0;
}

}  // namespace

void supervise(const SupervisedProgram& given) {
  SupervisedProgram program = given;
  setsid();
  ignore_signals();
  keep_only(program);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  sigset_t of_children;
  sigemptyset(&of_children);
  sigaddset(&of_children, SIGCHLD);
  sigprocmask(SIG_SETMASK, &of_children, nullptr);
  const int children = signalfd(-1, &of_children, SFD_CLOEXEC | SFD_NONBLOCK);
  int failed[2];
  SupervisorReport report;
  const pid_t supervisor = getpid();
  const pid_t child = pipe2(failed, O_CLOEXEC) == 0 ? fork() : -1;
  if (child == 0) become(program, failed[1], supervisor);
  if (child < 0) {
    report.error = errno;
  } else {
    close(failed[1]);
    if (read(failed[0], &report.error, sizeof report.error) <= 0) report.error = 0;
    double memory = 0.0;
    watch(child, program.lifeline, children, report.status, memory);
    kill_all(child);
    take_costs(memory, report);
  }
  (void)!write(program.report, &report, sizeof report);
  if (program.leftover != nullptr && is_orphaned(program.lifeline)) {
    execl("/bin/rm", "rm", "-rf", "--", program.leftover, static_cast<char*>(nullptr));
  }
  _exit(0);
}

}  // namespace mapbed
