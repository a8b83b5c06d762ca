#include "bench/cli/render/render_film.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/cli/interrupt.h"
#include "bench/cli/progress.h"
#include "bench/cli/render/run_to_film.h"
#include "bench/film/course.h"
#include "bench/film/film.h"
#include "bench/process/foreign_files.h"
#include "core/config/quantity.h"
#include "core/file/atomic_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kLength = 30.0;  // [s] of a film whose speed nobody chose, at most

// The least of 1, 2, 3, 5, 10, 20, 30, 50, … that makes a film of `seconds` short enough.
double speed_for(double seconds) {
  for (double power = 1.0;; power *= 10.0) {
    for (const double factor : {1.0, 2.0, 3.0, 5.0}) {
      if (seconds <= factor * power * kLength) return factor * power;
    }
  }
}

// What was asked for, as far as it can be known before the run.
struct Window {
  double from = 0.0;                                    // [s]
  double to = std::numeric_limits<double>::infinity();  // [s]
};

Window window_of(const FilmArguments& arguments) {
  Window window;
  const auto seconds = [](const std::string& text, const char* option) {
    const double value = parse_quantity(text, Unit::second, {option, 0});
    if (value < 0.0) throw InputError({option}, "must not be negative");
    return value;
  };
  if (!arguments.from.empty()) window.from = seconds(arguments.from, "--from");
  if (!arguments.to.empty()) window.to = seconds(arguments.to, "--to");
  if (window.from >= window.to) {
    throw InputError(fmt::format("between --from {} and --to {} there is nothing to be shown",
                                 arguments.from.empty() ? "0 s" : arguments.from, arguments.to));
  }
  return window;
}

FilmOptions options_of(const FilmArguments& arguments) {
  FilmOptions options{.rate = arguments.rate, .speed = arguments.speed};
  options.longest_side = arguments.longest_side.value_or(options.longest_side);
  const auto check = [](const char* option, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw InputError(fmt::format("{} of a film must be {:g} to {:g}", option, least, most));
  };
  check("--size", options.longest_side, 100, 4096);
  check("--fps", options.rate, 1, 50);
  if (options.speed != 0.0) check("--speed", options.speed, 0.01, 1e6);
  return options;
}

// The run's course, with the options that its length decided.
Course recorded(const RunToFilm& run, const Window& window, FilmOptions& options,
                const InterruptGuard& interrupt) {
  std::string problem;
  std::optional<Progress> progress;
  const auto choose = [&](double length) {
    if (window.from > length) {
      problem = fmt::format("--from {:g} s is behind the end: the log is {:.1f} s long",
                            window.from, length);
      throw Interrupted();
    }
    options.from = window.from;
    options.to = std::min(window.to, length);
    if (options.speed == 0.0) options.speed = speed_for(options.to - options.from);
    progress.emplace("repeating " + run.words() + ", s of its log",
                     static_cast<std::size_t>(options.to) + 1);
    return CourseMoments{options.from, window.to, options.speed / options.rate};
  };
  const auto goes_on = [&] { return !interrupt.was_interrupted(); };
  CourseRecorder recorder(
      choose, [&](double seconds) { progress->advance_to(static_cast<std::size_t>(seconds)); },
      goes_on);
  try {
    run.record(recorder, goes_on);
  } catch (const Interrupted&) {
    if (!problem.empty()) throw InputError(problem);
    if (!recorder.is_complete()) throw;
  }
  if (recorder.course().steps.empty()) {
    throw InputError(run.words() +
                     ": no scan has a pose in that time, so there is nothing to be "
                     "shown");
  }
  return recorder.course();
}

void check_output(const std::string& output) {
  check_film_can_be_made(output);
  check_writable(output);
  if (!std::filesystem::is_regular_file(output) || is_special_file(output)) return;
  if (!is_film_of_ours(output)) refuse_foreign(output);
}

}  // namespace

std::vector<CommandOption> film_options(FilmArguments& arguments) {
  const std::string of_film = "Of a film";
  return {{.name = "--run",
           .target = &arguments.number,
           .help = "the number of a scenario's run; its first one where left out",
           .group = of_film},
          {.name = "--speed",
           .target = &arguments.speed,
           .help = "times real time; where left out, so that it takes half a minute at most",
           .group = of_film},
          {.name = "--fps",
           .target = &arguments.rate,
           .help = "frames a second",
           .shows_default = true,
           .group = of_film},
          {.name = "--from",
           .target = &arguments.from,
           .help = "since the log's start, as in '10 s'",
           .group = of_film},
          {.name = "--to",
           .target = &arguments.to,
           .help = "the same, where the film ends",
           .group = of_film}};
}

int render_film(const FilmArguments& arguments) {
  const Window window = window_of(arguments);
  FilmOptions options = options_of(arguments);
  check_output(arguments.output);
  const std::unique_ptr<RunToFilm> run = run_to_film(arguments.run, arguments.number);
  const InterruptGuard interrupt;
  try {
    const Course course = recorded(*run, window, options, interrupt);
    const FilmMade film = [&] {
      std::optional<Progress> drawing;
      return write_film(
          course, options, arguments.output,
          [&](std::size_t done, std::size_t total) {
            if (!drawing) drawing.emplace("drawing frames", total);
            drawing->advance_to(done);
          },
          [&] { return !interrupt.was_interrupted(); });
    }();
    fmt::print("{}: {}, {} x {} pixels, {} frames, {:.1f} s, {:g} times real time\n",
               arguments.output, run->words(), film.width, film.height, film.frames, film.seconds,
               options.speed);
    return kDone;
  } catch (const Interrupted&) {
    fmt::print(stderr, "mapbed: interrupted; nothing was written\n");
    return kInterrupted;
  }
}

}  // namespace mapbed
