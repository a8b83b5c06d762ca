#include "bench/cli/testing/killed_program.h"

#include <cerrno>
#include <csignal>
#include <cstddef>

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr int kCannotBeTraced = 125;  // exit status of the child

using Filter = std::vector<sock_filter>;

sock_filter statement(int code, std::size_t value) {
  return BPF_STMT(static_cast<unsigned short>(code), static_cast<unsigned>(value));
}

// Goes on with the next statement where it holds, else behind `skipped` of them.
sock_filter condition(int code, std::size_t value, int skipped) {
  return BPF_JUMP(static_cast<unsigned short>(code | BPF_JMP | BPF_K), static_cast<unsigned>(value),
                  0, static_cast<unsigned char>(skipped));
}

// Stops at `call` where its argument fulfils a condition.
void stop_at(Filter& filter, long call, std::size_t argument, int code, std::size_t value) {
  filter.push_back(condition(BPF_JEQ, static_cast<std::size_t>(call), 4));
  filter.push_back(
      statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args) + argument * sizeof(__u64)));
  filter.push_back(condition(code, value, 1));
  filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_TRACE));
  filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
}

void stop_at(Filter& filter, long call) {
  filter.push_back(condition(BPF_JEQ, static_cast<std::size_t>(call), 1));
  filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_TRACE));
}

// What the kernel asks at each system call: whether to stop there and tell the tracer.
Filter changing_calls() {
  Filter filter{statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  stop_at(filter, SYS_openat, 2, BPF_JSET, O_CREAT | O_TRUNC);
  for (const long call : {SYS_write, SYS_pwrite64, SYS_writev}) {
    stop_at(filter, call, 0, BPF_JGT, STDERR_FILENO);
  }
  for (const long call : {SYS_ftruncate, SYS_fsync, SYS_fdatasync, SYS_renameat2, SYS_unlinkat,
                          SYS_mkdirat, SYS_linkat, SYS_symlinkat, SYS_fallocate, SYS_sendfile,
                          SYS_copy_file_range, SYS_truncate}) {
    stop_at(filter, call);
  }
#ifdef SYS_open  // calls of older kinds of processors
  stop_at(filter, SYS_open, 1, BPF_JSET, O_CREAT | O_TRUNC);
  for (const long call : {SYS_creat, SYS_rename, SYS_renameat, SYS_unlink, SYS_rmdir, SYS_mkdir,
                          SYS_link, SYS_symlink}) {
    stop_at(filter, call);
  }
#endif
  filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  return filter;
}

// In the child: never returns.
[[noreturn]] void become_traced(const std::vector<char*>& words, const std::string& folder,
                                Filter& filter) {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  if (chdir(folder.c_str()) != 0 || ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) {
    _exit(kCannotBeTraced);
  }
  raise(SIGSTOP);
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
      prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) {
    _exit(kCannotBeTraced);
  }
  execv(words[0], words.data());
  _exit(kCannotBeTraced);
}

// Lets the program and its threads go on from stop to stop.
KilledRun traced(pid_t program, int nth) {
  KilledRun run;
  for (;;) {
    int status = 0;
    const pid_t thread = waitpid(-1, &status, __WALL);
    CHECK(thread > 0 || errno == EINTR);
    if (thread == program && !WIFSTOPPED(status)) {
      run.was_killed = WIFSIGNALED(status);
      run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
      return run;
    }
    if (thread <= 0 || !WIFSTOPPED(status)) continue;
    const int event = status >> 16;
    const int signal = WSTOPSIG(status);
    if (event == PTRACE_EVENT_SECCOMP && ++run.calls == nth) kill(program, SIGKILL);
    // A new thread begins with a stop of its own.
    const bool is_of_program = event == 0 && signal != SIGSTOP && signal != SIGTRAP;
    ptrace(PTRACE_CONT, thread, nullptr, is_of_program ? signal : 0);
  }
}

}  // namespace

std::optional<KilledRun> run_killed_at(int nth, const std::vector<std::string>& arguments,
                                       const std::string& folder) {
  Filter filter = changing_calls();
  std::vector<char*> words{const_cast<char*>(MAPBED_PROGRAM)};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t child = fork();
  CHECK(child >= 0);
  if (child == 0) become_traced(words, folder, filter);

  int status = 0;
  CHECK(waitpid(child, &status, __WALL) == child);
  if (!WIFSTOPPED(status)) return std::nullopt;
  const long options = PTRACE_O_TRACESECCOMP | PTRACE_O_TRACECLONE | PTRACE_O_TRACEFORK |
                       PTRACE_O_TRACEVFORK | PTRACE_O_TRACEEXEC | PTRACE_O_EXITKILL;
  CHECK(ptrace(PTRACE_SETOPTIONS, child, nullptr, options) == 0);
  ptrace(PTRACE_CONT, child, nullptr, nullptr);
  const KilledRun run = traced(child, nth);
  if (run.status == kCannotBeTraced) return std::nullopt;
  return run;
}

}  // namespace mapbed
