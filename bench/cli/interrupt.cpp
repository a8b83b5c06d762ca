#include "bench/cli/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace mapbed {
namespace {

// A signal handler can reach nothing but such a variable.
volatile std::sig_atomic_t interrupted = 0;

void note(int) {
  interrupted = 1;
}

void handle(void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  interrupted = 0;
  handle(note, static_cast<int>(SA_RESETHAND) | SA_RESTART);
}

InterruptGuard::~InterruptGuard() {
  handle(SIG_DFL, 0);
}

bool InterruptGuard::was_interrupted() const {
  return interrupted != 0;
}

}  // namespace mapbed
