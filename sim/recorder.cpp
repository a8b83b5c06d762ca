#include "sim/recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "sim/noise/laser_noise.h"
#include "sim/noise/odometry_noise.h"

namespace mapbed {
namespace {

IdealOdometry odometry_of(const Situation& s) {
  return {s.time, s.robot, s.wheels, s.motors.forward_velocity, s.motors.turn_velocity};
}

// Sweeps and odometry readings that are over, in order of their stamps.
class Schedule {
 public:
  explicit Schedule(const Robot& robot) : robot_(robot), next_(robot.lasers.size() + 1, 0) {}

  struct Event {
    double start;  // [s] of the sweep
    double stamp;  // [s]
    int laser;     // -1: odometry of its own
    std::uint64_t number;
  };

  // The next event whose sweep is over at `now`; laser -2 where there is none.
  Event next(double now) {
    Event best{0.0, now + 1.0, -2, 0};
    std::size_t best_source = 0;
    for (std::size_t source = 0; source < next_.size(); ++source) {
      const Event event = event_of(source);
      if (event.laser == -1 && robot_.odometry.rate <= 0.0) continue;
      if (end_of(event) > now + 1e-9 || event.stamp >= best.stamp) continue;
      best = event;
      best_source = source;
    }
    if (best.laser != -2) ++next_[best_source];
    return best;
  }

 private:
  Event event_of(std::size_t source) const {
    const std::uint64_t number = next_[source];
    const double k = static_cast<double>(number);
    if (source == robot_.lasers.size()) {
      const double stamp = robot_.odometry.rate > 0.0 ? k / robot_.odometry.rate : 0.0;
      return {stamp, stamp, -1, number};
    }
    const LaserModel& model = robot_.lasers[source].model;
    const double start = k / model.scan_rate;
    return {start, start + model.sweep_time() / 2.0, static_cast<int>(source), number};
  }
  double end_of(const Event& e) const {
    if (e.laser < 0) return e.stamp;
    return e.start + robot_.lasers[static_cast<std::size_t>(e.laser)].model.sweep_time();
  }

  const Robot& robot_;
  std::vector<std::uint64_t> next_;  // number of each laser's next sweep; odometry last
};

class Recorder {
 public:
  Recorder(Simulation& simulation, Driver& driver, const RecorderOptions& options, const Rng& rng)
      : simulation_(simulation),
        driver_(driver),
        options_(options),
        rng_(rng),
        schedule_(simulation.robot()),
        reader_(simulation.robot().odometry, rng) {}

  Recording run() {
    Truth& truth = recording_.truth;
    truth.world = simulation_.world().name;
    truth.robot = simulation_.robot().name;
    truth.entities = simulation_.entities();
    for (const Material& m : simulation_.world().materials) truth.materials.push_back(m.name);

    take_readings();
    while (!driver_.is_done() && simulation_.now().time < options_.longest) {
      simulation_.step(driver_.command(simulation_.now().time));
      take_readings();
    }
    recording_.is_complete = driver_.is_done();
    return std::move(recording_);
  }

 private:
  void take_readings() {
    for (;;) {
      const Schedule::Event event = schedule_.next(simulation_.now().time);
      if (event.laser == -2) return;
      add_odometry(event.stamp);
      if (event.laser >= 0) add_sweep(event);
    }
  }

  void add_odometry(double stamp) {
    IdealOdometry reading = odometry_of(simulation_.at(stamp));
    reading.time += options_.first_stamp;
    if (!recording_.odometry.empty() && recording_.odometry.back().time == reading.time) return;
    recording_.odometry.push_back(reading);
    if (options_.tells_driver) driver_.add(reader_.read(reading));
  }

  void add_sweep(const Schedule::Event& event) {
    Simulation::Sweep sweep = simulation_.sweep(event.laser, event.start, event.number);
    // Exactly the stamp of the odometry reading that belongs to it.
    sweep.ideal.time = sweep.truth.time = recording_.odometry.back().time;
    if (options_.tells_driver) {
      const auto& laser = simulation_.robot().lasers[static_cast<std::size_t>(event.laser)];
      driver_.add(with_noise(sweep.ideal, laser, rng_));
    }
    recording_.scans.push_back(std::move(sweep.ideal));
    recording_.truth.scans.push_back(std::move(sweep.truth));
  }

  Simulation& simulation_;
  Driver& driver_;
  RecorderOptions options_;
  Rng rng_;
  Schedule schedule_;
  OdometryReader reader_;
  Recording recording_;
};

}  // namespace

Recording record(Simulation& simulation, Driver& driver, const RecorderOptions& options,
                 const Rng& rng) {
  return Recorder(simulation, driver, options, rng).run();
}

SensorLog with_noise(const Recording& recording, const Robot& robot, const Rng& rng) {
  const std::vector<Odometry> odometry = with_noise(recording.odometry, robot.odometry, rng);
  SensorLog log;
  log.reserve(odometry.size() + recording.scans.size());
  std::size_t scan = 0;
  const auto add_scans_before = [&](double time) {
    for (; scan < recording.scans.size() && recording.scans[scan].time < time; ++scan) {
      const IdealScan& ideal = recording.scans[scan];
      CHECK(static_cast<std::size_t>(ideal.laser) < robot.lasers.size());
      log.push_back(with_noise(ideal, robot.lasers[static_cast<std::size_t>(ideal.laser)], rng));
    }
  };
  for (const Odometry& reading : odometry) {
    add_scans_before(reading.time);
    log.push_back(reading);
  }
  add_scans_before(std::numeric_limits<double>::infinity());
  return log;
}

}  // namespace mapbed
