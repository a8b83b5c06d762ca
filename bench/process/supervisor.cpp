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
  for (int* descriptor : {&program.messages, &program.lifeline, &program.report}) {
    *descriptor = fcntl(*descriptor, F_DUPFD, kFirstFree);
  }
  const int nothing = open("/dev/null", O_RDONLY);
  place(nothing, STDIN_FILENO);
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

// "/proc/<pid>/status", without memory of its own.
void path_of_status(pid_t process, char (&path)[64]) {
  char digits[16];
  int count = 0;
  do {
    digits[count++] = static_cast<char>('0' + process % 10);
    process /= 10;
  } while (process > 0);
  std::strcpy(path, "/proc/");
  char* end = path + std::strlen(path);
  while (count > 0) *end++ = digits[--count];
  std::strcpy(end, "/status");
}

// [bytes] the most that it has had so far; 0 where it is over.
double peak_memory_of(pid_t process) {
  char path[64];
  path_of_status(process, path);
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0.0;
  char text[4096];
  const ssize_t size = read(file, text, sizeof text - 1);
  close(file);
  text[std::max<ssize_t>(size, 0)] = '\0';
  return 1024.0 * number_behind(text, "VmHWM:");
}

// Those that were started by children that are over are children of this process by then.
void kill_children() {
  const int file = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  char text[4096];
  const ssize_t size = read(file, text, sizeof text - 1);
  close(file);
  pid_t process = 0;
  for (ssize_t i = 0; i < size; ++i) {
    if (text[i] >= '0' && text[i] <= '9') {
      process = 10 * process + (text[i] - '0');
    } else if (process > 0) {
      kill(process, SIGKILL);
      process = 0;
    }
  }
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
// this one's own is known by looking at the program alone.
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
