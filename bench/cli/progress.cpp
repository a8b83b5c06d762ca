#include "bench/cli/progress.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "bench/process/stopwatch.h"

namespace mapbed {
namespace {

constexpr std::size_t kBarLength = 30;

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

std::string progress_line(const std::string& job, std::size_t done,
                          std::optional<std::size_t> total, double elapsed_seconds, bool with_bar) {
  const std::string so_far = duration_text(elapsed_seconds) + " so far";
  if (!total) return fmt::format("{}: {}", job, so_far);
  const double fraction =
      *total == 0 ? 1.0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(*total));
  const int percent = static_cast<int>(100.0 * fraction);  // 100 only when it is done
  const bool is_between = fraction > 0.0 && fraction < 1.0;
  const std::string time =
      is_between ? duration_text(elapsed_seconds * (1.0 - fraction) / fraction) + " left" : so_far;
  if (!with_bar) return fmt::format("{}: {} of {}, {} %, {}", job, done, *total, percent, time);
  const auto filled = static_cast<std::size_t>(fraction * kBarLength);
  return fmt::format("{} [{}{}] {:3} %, {}", job, std::string(filled, '#'),
                     std::string(kBarLength - filled, '.'), percent, time);
}

// A thread draws, so that there is a word however long a step takes.
struct Progress::Ticker {
  Ticker(std::string name, std::optional<std::size_t> steps, double seconds)
      : job(std::move(name)), total(steps), pause(seconds) {
    // Signals are for the thread that works: they end what waits for its input.
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    thread = std::thread([this] { tick(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  ~Ticker() {
    {
      const std::scoped_lock lock(mutex);
      ended = true;
    }
    wake.notify_all();
    thread.join();
    if (drawn && terminal) std::fputs("\r\033[K", stderr);
  }

  void tick() {
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, pause, [this] { return ended; })) {
      const std::string line = progress_line(job, done, total, since_start.seconds(), terminal);
      // No fmt::print, which throws where nobody takes the words.
      std::fputs((terminal ? "\r" + line + "\033[K" : line + "\n").c_str(), stderr);
      std::fflush(stderr);
      drawn = true;
    }
  }

  const std::string job;
  const std::optional<std::size_t> total;
  const std::chrono::duration<double> pause;
  const bool terminal = isatty(STDERR_FILENO) == 1;
  const Stopwatch since_start;
  std::atomic<std::size_t> done = 0;
  std::mutex mutex;
  std::condition_variable wake;
  bool ended = false;  // guarded by `mutex`, as `drawn`
  bool drawn = false;
  std::thread thread;
};

Progress::Progress(std::string job, std::optional<std::size_t> total)
    : Progress(std::move(job), total, isatty(STDERR_FILENO) == 1 ? 0.5 : 10.0) {}

Progress::Progress(std::string job, std::optional<std::size_t> total, double pause)
    : ticker_(std::make_unique<Ticker>(std::move(job), total, pause)) {}

Progress::~Progress() = default;

void Progress::advance_to(std::size_t done) {
  ticker_->done = done;
}

}  // namespace mapbed
