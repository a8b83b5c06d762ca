#include "bench/cli/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace mapbed {
namespace {

constexpr std::size_t kBarLength = 30;

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

std::string progress_line(const std::string& job, std::size_t done, std::size_t total,
                          double elapsed_seconds, bool with_bar) {
  const double fraction =
      total == 0 ? 1.0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
  const int percent = static_cast<int>(100.0 * fraction);  // 100 only when it is done
  const std::string left =
      fraction > 0.0 ? ", " + duration_text(elapsed_seconds * (1.0 - fraction) / fraction) + " left"
                     : "";
  if (!with_bar) return fmt::format("{}: {} of {}, {} %{}", job, done, total, percent, left);
  const auto filled = static_cast<std::size_t>(fraction * kBarLength);
  return fmt::format("{} [{}{}] {:3} %{}", job, std::string(filled, '#'),
                     std::string(kBarLength - filled, '.'), percent, left);
}

Progress::Progress(std::string job, std::size_t total)
    : job_(std::move(job)), total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_ && terminal_) fmt::print(stderr, "\r\033[K");
}

void Progress::advance_to(std::size_t done) {
  const double now = since_start_.seconds();
  const double pause = terminal_ ? 0.1 : 10.0;  // [s]
  if (now - last_ < pause) return;
  last_ = now;
  drawn_ = true;
  const std::string line = progress_line(job_, done, total_, now, terminal_);
  if (terminal_) {
    fmt::print(stderr, "\r{}\033[K", line);
    std::fflush(stderr);
  } else {
    fmt::print(stderr, "{}\n", line);
  }
}

}  // namespace mapbed
