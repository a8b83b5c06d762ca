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

// Sweeps, rounds and odometry readings in order of their stamps, each as soon as it is over.
class Schedule {
 public:
  explicit Schedule(const Robot& robot)
      : lasers_(lasers_of(robot)),
        antennas_(antennas_of(robot)),
        odometry_rate_(robot.odometry.rate),
        next_(lasers_.size() + 1 + antennas_.size()) {}

  struct Event {
    double start = 0.0;  // [s] of the sweep
    double stamp = 0.0;  // [s]
    double end = 0.0;    // [s] of the sweep
    int laser = -1;
    int antenna = -1;  // where that is -1, too: odometry of its own
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
      return {stamp, stamp, stamp, -1, -1, number};
    }
    if (source > lasers_.size()) {
      const std::size_t antenna = source - lasers_.size() - 1;
      const double turn = static_cast<double>(antenna) / static_cast<double>(antennas_.size());
      const double stamp = (k + turn) / antennas_[antenna].model.round_rate;
      return {stamp, stamp, stamp, -1, static_cast<int>(antenna), number};
    }
    const LaserModel& model = lasers_[source].model;
    const double start = k / model.scan_rate;
    return {start,
            start + model.stamp_delay(),
            start + model.sweep_time(),
            static_cast<int>(source),
            -1,
            number};
  }

  std::vector<MountedLaser> lasers_;
  std::vector<MountedAntenna> antennas_;
  double odometry_rate_;             // [Hz] 0: none of its own
  std::vector<std::uint64_t> next_;  // of each laser's sweeps, odometry, each antenna's rounds
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
      if (event->antenna >= 0) {
        take_round(*event);
        continue;
      }
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

  // Without odometry: that would draw noise of its own, and with it change all that follows.
  void take_round(const Schedule::Event& event) {
    IdealRfid round = simulation_.rfid_round(event.antenna, event.stamp, event.number);
    round.time += options_.first_stamp;
    take(std::move(round));
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
