#include "bench/scenario/runner.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "bench/methods/program_run.h"
#include "bench/process/memory_gate.h"
#include "bench/process/process_cost.h"
#include "bench/process/thread_limit.h"
#include "core/check.h"
#include "core/failure_text.h"

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Messages on one line, as rows have them.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

std::string key_of(const ScenarioPlan& plan, const RunRow& row) {
  const PlannedRuns& planned = plan.planned_of(row);
  if (planned.sources.empty()) return std::to_string(row.run);
  std::string key;
  for (const auto& source : planned.sources) {
    key += (source->depends_on_seed ? std::to_string(row.seed) : "") + "\n" + source->key;
  }
  return key;
}

class Inside {
 public:
  explicit Inside(MemoryGate& gate) : gate_(gate) { gate_.enter(); }
  ~Inside() { gate_.leave(); }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

 private:
  MemoryGate& gate_;
};

// The logs in memory that runs share, the scenario's own first.
struct OpenedLogs {
  std::vector<std::unique_ptr<LogSource>> sources;
  double seconds = 0.0;  // [s] of processor time that it took
  std::string failure;   // in one line; empty: they are there
};

// A further log is not the same drive again where it has the same settings: its seed is another.
std::uint64_t seed_of(const Experiment& experiment, std::size_t source, std::uint64_t seed) {
  return source == 0 ? seed : Rng(seed).stream(experiment.further_logs[source - 1]).bits();
}

OpenedLogs opened_logs(const ScenarioPlan& plan, const RunRow& row, const GoesOn& goes_on) {
  OpenedLogs logs;
  const double start = processor_time();
  const PlannedRuns& planned = plan.planned_of(row);
  try {
    for (std::size_t i = 0; i < planned.sources.size(); ++i) {
      const std::uint64_t seed = seed_of(*plan.experiment, i, row.seed);
      logs.sources.push_back(open_source(*planned.sources[i], seed, goes_on));
    }
  } catch (const std::bad_alloc&) {
    throw;  // a failure of the machine, not of the run
  } catch (const InputChanged&) {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    logs.failure = one_line(failure_text(error));
  }
  logs.seconds = processor_time() - start;
  return logs;
}

class Runner {
 public:
  Runner(const ScenarioPlan& plan, const RunnerCalls& calls) : plan_(plan), calls_(calls) {}

  int recordings() const { return recordings_; }

  void do_group(const std::vector<int>& runs) try {
    if (!calls_.may_go_on()) return;
    const Inside inside(gate_);
    const OpenedLogs logs = opened_logs(plan_, plan_.row(runs.front()), calls_.may_go_on);
    recordings_ += static_cast<int>(logs.sources.size());
    tell_remarks(logs, plan_.row(runs.front()).seed);
    // Isolated: a thread that waits here shall not begin another group, with a recording more.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t i) {
        if (!calls_.may_go_on()) return;
        RunResult result =
            logs.failure.empty() ? done(runs[i], logs) : failed(runs[i], logs.failure);
        result.cost.recording_seconds = i == 0 ? logs.seconds : 0.0;
        const std::scoped_lock lock(mutex_);
        calls_.done(std::move(result));
      });
    });
  } catch (const Interrupted&) {
    // The runs of this log are left for the next start.
  }

 private:
  void tell_remarks(const OpenedLogs& logs, std::uint64_t seed) {
    for (const auto& source : logs.sources) {
      if (!calls_.remark || source->remark().empty()) continue;
      const std::scoped_lock lock(mutex_);
      calls_.remark(fmt::format("seed {}: {}", seed, source->remark()));
    }
  }

  RunResult done(int run, const OpenedLogs& logs) const {
    const double start = processor_time();
    RunOutcome outcome;
    const RunRow row = plan_.row(run);
    try {
      outcome = plan_.planned_of(row).experiment.make(input_of(row, logs));
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const InputChanged&) {
      throw;
    } catch (const Interrupted&) {
      throw;
    } catch (const ProgramFailed& error) {
      RunResult result = failed(run, one_line(error.what()));
      result.files.push_back({fmt::format("messages/run_{}.txt", run), error.messages});
      return result;
    } catch (const std::exception& error) {
      return failed(run, one_line(failure_text(error)));
    }
    RunResult result{.row = row, .files = std::move(outcome.files)};
    result.row.failure = std::move(outcome.failure);
    result.row.values = wanted_values(outcome.values);
    result.series = wanted_series(std::move(outcome.series), run);
    result.cost = {.run = run,
                   .seconds = processor_time() - start + outcome.program_seconds,
                   .method_seconds = outcome.method_seconds,
                   .peak_memory = peak_memory(),
                   .method_wall_seconds = outcome.method_wall_seconds,
                   .program_memory = outcome.program_memory};
    if (!logs.sources.empty()) {
      result.cost.recorded_seconds = logs.sources.front()->recorded_seconds();
    }
    return result;
  }

  std::vector<double> wanted_values(
      const std::vector<std::pair<std::string, double>>& values) const {
    std::vector<double> wanted(plan_.results.metrics.size(), kNone);
    for (const auto& [name, value] : values) {
      const auto is_named = [&name = name](const Metric& metric) { return metric.name == name; };
      const auto& known = plan_.experiment->metrics;
      CHECK(std::any_of(known.begin(), known.end(), is_named));  // else its meaning stands nowhere
      const auto& metrics = plan_.results.metrics;
      const auto found = std::find_if(metrics.begin(), metrics.end(), is_named);
      if (found != metrics.end()) wanted[static_cast<std::size_t>(found - metrics.begin())] = value;
    }
    return wanted;
  }

  std::vector<Series> wanted_series(std::vector<Series> series, int run) const {
    std::vector<Series> wanted;
    for (const SeriesMetric& metric : plan_.results.series_metrics) {
      const auto found = std::find_if(series.begin(), series.end(),
                                      [&](const Series& s) { return s.name == metric.name; });
      if (found == series.end()) continue;
      std::erase_if(found->points, [](const SeriesPoint& p) { return !std::isfinite(p.value); });
      found->run = run;
      wanted.push_back(std::move(*found));
    }
    return wanted;
  }

  RunInput input_of(const RunRow& row, const OpenedLogs& logs) const {
    const PlannedRuns& planned = plan_.planned_of(row);
    RunInput input;
    for (std::size_t i = 0; i < logs.sources.size(); ++i) {
      const std::uint64_t seed = seed_of(*plan_.experiment, i, row.seed);
      LogInput log = logs.sources[i]->input(*planned.sources[i], seed);
      if (i == 0) {
        static_cast<LogInput&>(input) = std::move(log);
      } else {
        input.further[plan_.experiment->further_logs[i - 1]] = std::move(log);
      }
    }
    input.rng = Rng(row.seed).stream("experiment");
    input.seed = row.seed;
    input.goes_on = calls_.may_go_on;
    input.viewer = calls_.viewer;
    input.alone = calls_.alone;
    input.shown = calls_.alone || row.seed == plan_.scenario.seed;
    input.label = label_of(row);
    for (const Metric& metric : plan_.results.metrics) input.wanted.insert(metric.name);
    for (const SeriesMetric& series : plan_.results.series_metrics) {
      input.wanted.insert(series.name);
    }
    return input;
  }

  // Its variant and level, as far as there are others.
  std::string label_of(const RunRow& row) const {
    const Results& results = plan_.results;
    std::string label =
        results.variants.size() > 1 ? results.variants[static_cast<std::size_t>(row.variant)] : "";
    if (results.levels.size() > 1) {
      label += (label.empty() ? "" : ", ") + level_text(results, row.level);
    }
    return label;
  }

  RunResult failed(int run, const std::string& reason) const {
    RunResult result{.row = plan_.row(run), .cost = {.run = run, .peak_memory = peak_memory()}};
    result.row.failure = reason;
    for (const Metric& metric : plan_.results.metrics) {
      result.row.values.push_back(metric.when_failed);
    }
    return result;
  }

  const ScenarioPlan& plan_;
  const RunnerCalls& calls_;
  MemoryGate gate_{available_memory, peak_memory};
  std::mutex mutex_;
  std::atomic<int> recordings_ = 0;
};

}  // namespace

std::vector<std::vector<int>> sharing_recordings(const ScenarioPlan& plan,
                                                 const std::vector<int>& runs) {
  std::map<std::string, std::size_t> by_key;
  std::vector<std::vector<int>> groups;
  for (const int run : runs) {
    const auto [entry, is_new] = by_key.emplace(key_of(plan, plan.row(run)), groups.size());
    if (is_new) groups.emplace_back();
    groups[entry->second].push_back(run);
  }
  return groups;
}

int do_runs(const ScenarioPlan& plan, const std::vector<int>& runs, int threads,
            const RunnerCalls& calls) {
  const ThreadLimit limit(threads);
  tbb::task_arena arena(threads);
  const std::vector<std::vector<int>> groups = sharing_recordings(plan, runs);
  Runner runner(plan, calls);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, groups.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) runner.do_group(groups[i]);
        },
        tbb::simple_partitioner{});
  });
  return runner.recordings();
}

int recordings_needed(const ScenarioPlan& plan) {
  int recordings = 0;
  for (const std::vector<int>& runs : sharing_recordings(plan, plan.runs_to_do())) {
    recordings += static_cast<int>(plan.planned_of(plan.row(runs.front())).sources.size());
  }
  return recordings;
}

}  // namespace mapbed
