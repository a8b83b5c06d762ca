#include "sim/recorder.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "sim/noise/sensor_noise.h"
#include "sim/stuck.h"

namespace mapbed {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

IdealOdometry odometry_of(const Situation& s) {
  return {s.time, s.robot, s.wheels, s.motors.forward_velocity, s.motors.turn_velocity};
}

// Sweeps and odometry readings in order of their stamps, each as soon as it is over.
class Schedule {
 public:
  explicit Schedule(const Robot& robot)
      : lasers_(lasers_of(robot)), odometry_rate_(robot.odometry.rate), next_(lasers_.size() + 1) {}

  struct Event {
    double start = 0.0;  // [s] of the sweep
    double stamp = 0.0;  // [s]
    double end = 0.0;    // [s] of the sweep
    int laser = -1;      // -1: odometry of its own
    std::uint64_t number = 0;
  };

  // The event that is next, if it is over at `now`. One that comes later waits even where it is
  // over first.
  std::optional<Event> next(double now) {
    Event best{.stamp = kNever, .end = kNever};
    std::size_t best_source = 0;
    for (std::size_t source = 0; source < next_.size(); ++source) {
      const Event event = event_of(source);
      if (event.stamp >= best.stamp) continue;
      best = event;
      best_source = source;
    }
    if (best.end > now + 1e-9) return {};
    ++next_[best_source];
    return best;
  }

 private:
  Event event_of(std::size_t source) const {
    const std::uint64_t number = next_[source];
    const double k = static_cast<double>(number);
    if (source == lasers_.size()) {
      const double stamp = odometry_rate_ > 0.0 ? k / odometry_rate_ : kNever;
      return {stamp, stamp, stamp, -1, number};
    }
    const LaserModel& model = lasers_[source].model;
    const double start = k / model.scan_rate;
    return {start, start + model.stamp_delay(), start + model.sweep_time(),
            static_cast<int>(source), number};
  }

  std::vector<MountedLaser> lasers_;
  double odometry_rate_;             // [Hz] 0: none of its own
  std::vector<std::uint64_t> next_;  // number of each laser's next sweep; odometry last
};

class Recorder {
 public:
  Recorder(Simulation& simulation, Driver& driver, const RecorderOptions& options, const Rng& rng,
           const RecordingSink& sink)
      : simulation_(simulation),
        driver_(driver),
        options_(options),
        sink_(sink),
        schedule_(simulation.robot()),
        noise_(simulation.robot(), rng) {}

  RecordingEnd run() {
    StuckWatch watch(options_.stuck_after);
    take_readings();
    while (!driver_.is_done() && simulation_.now().time < options_.longest) {
      simulation_.step(driver_.command(simulation_.now().time));
      take_readings();
      const Situation& now = simulation_.now();
      if (watch.is_stuck(now, driver_.is_resting(now.time))) return {false, report(watch.since())};
    }
    return {driver_.is_done(), {}};
  }

 private:
  std::string report(double since) const {
    const Pose2& robot = simulation_.now().robot;
    return fmt::format("the robot has stood at ({:.2f} m, {:.2f} m) since {:.1f} s, {}", robot.x,
                       robot.y, since + options_.first_stamp, what_is_in_the_way(simulation_));
  }

  void take_readings() {
    while (const auto event = schedule_.next(simulation_.now().time)) {
      const Situation situation = simulation_.at(event->stamp);
      const double time = situation.time + options_.first_stamp;
      if (time != last_odometry_) {
        IdealOdometry reading = odometry_of(situation);
        reading.time = last_odometry_ = time;
        take(reading);
      }
      if (event->laser >= 0) take_sweep(*event, situation);
    }
  }

  void take_sweep(const Schedule::Event& event, const Situation& situation) {
    Simulation::Sweep sweep = simulation_.sweep(event.laser, event.start, event.number);
    // Exactly the stamp of the odometry reading that belongs to it.
    sweep.ideal.time = sweep.truth.time = last_odometry_;
    if (last_states_ != last_odometry_) {
      last_states_ = last_odometry_;
      sink_.states({last_states_, situation.robot, situation.moving});
    }
    sink_.beams(std::move(sweep.truth));
    take(std::move(sweep.ideal));
  }

  void take(IdealReading reading) {
    if (options_.tells_driver) driver_.add(noise_.read(reading));
    sink_.reading(std::move(reading));
  }

  Simulation& simulation_;
  Driver& driver_;
  RecorderOptions options_;
  const RecordingSink& sink_;
  Schedule schedule_;
  SensorNoise noise_;
  double last_odometry_ = -kNever;  // [s] its stamp
  double last_states_ = -kNever;    // [s]
};

}  // namespace

RecordingEnd record(Simulation& simulation, Driver& driver, const RecorderOptions& options,
                    const Rng& rng, const RecordingSink& sink) {
  return Recorder(simulation, driver, options, rng, sink).run();
}

Recording record(Simulation& simulation, Driver& driver, const RecorderOptions& options,
                 const Rng& rng) {
  Recording recording;
  static_cast<TruthHeader&>(recording.truth) = simulation.truth_header();
  recording.end = record(simulation, driver, options, rng, sink_into(recording));
  return recording;
}

}  // namespace mapbed
