#include "sim/noise/rfid_noise.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

double power_of(double decibels) {
  return std::pow(10.0, decibels / 10.0);
}
double decibels_of(double power) {
  return 10.0 * std::log10(std::max(power, 1e-30));
}

// Q_1(a, b): a mixture of chi-square tails, by Poisson weights of mean a^2 / 2.
double marcum_q(double a, double b) {
  constexpr int kMostTerms = 10'000;
  const double mean = a * a / 2.0;
  const double limit = b * b / 2.0;
  double log_weight = -mean;  // of j in the Poisson of `mean`
  double log_term = -limit;   // of j in that of `limit`
  double tail = 0.0, sum = 0.0, weights = 0.0;
  for (int j = 0; j < kMostTerms && weights < 1.0 - 1e-12; ++j) {
    if (j > 0) {
      log_weight += std::log(mean / j);
      log_term += std::log(limit / j);
    }
    tail += std::exp(log_term);
    const double weight = std::exp(log_weight);
    weights += weight;
    sum += weight * std::min(1.0, tail);
    if (mean == 0.0) break;
  }
  return std::clamp(sum, 0.0, 1.0);
}

// All chance of one tag in one round, drawn in a fixed order.
struct Draws {
  explicit Draws(Rng rng) {
    fade = rng.normal();
    fade_aside = rng.normal();
    slot = rng.uniform();
    is_astray = rng.uniform();
    astray_to = rng.uniform();
    rssi = rng.normal();
    phase = rng.normal();
  }
  double fade, fade_aside, slot, is_astray, astray_to, rssi, phase;
};

// [dB] on top of the mean power.
double fading(const RfidNoise& noise, const Draws& draws) {
  if (noise.fading == Fading::off) return 0.0;
  if (noise.fading == Fading::threshold) return noise.read_sigma * draws.fade;
  const double k = power_of(noise.rice_factor);
  const double sigma = std::sqrt(0.5 / (k + 1.0));
  const double ahead = std::sqrt(k / (k + 1.0)) + sigma * draws.fade;
  const double aside = sigma * draws.fade_aside;
  return decibels_of(ahead * ahead + aside * aside);
}

int poisson(double mean, Rng& rng) {
  const double limit = std::exp(-mean);
  int count = 0;
  for (double product = rng.uniform(); product > limit; product *= rng.uniform()) ++count;
  return count;
}

RfidRead read_of(const RfidModel& model, double power, double phase, double rssi_draw,
                 double phase_draw) {
  const RfidNoise& noise = model.noise;
  RfidRead read;
  read.rssi = 2.0 * power - model.eirp + model.antenna_gain - model.modulation_loss +
              noise.rssi_sigma * rssi_draw;
  if (noise.rssi_step > 0.0) read.rssi = noise.rssi_step * std::round(read.rssi / noise.rssi_step);
  const double turn = 2.0 * kPi;
  const double noisy = phase + noise.phase_sigma * phase_draw;
  read.phase = std::floor(1e3 * (noisy - turn * std::floor(noisy / turn))) / 1e3;
  return read;
}

}  // namespace

struct RfidReader::Answer {
  const IdealTag* tag = nullptr;
  double power = 0.0;  // [dBm] with shadowing and fading
  int slot = 0;
  Draws draws;
};

double answer_probability(const RfidModel& model, double power) {
  const double over = power - model.threshold;  // [dB]
  const RfidNoise& noise = model.noise;
  if (noise.fading == Fading::rice) {
    const double k = power_of(noise.rice_factor);
    return marcum_q(std::sqrt(2.0 * k), std::sqrt(2.0 * (k + 1.0) * power_of(-over)));
  }
  if (noise.fading == Fading::off || noise.read_sigma == 0.0) return over > 0.0 ? 1.0 : 0.0;
  return 0.5 * std::erfc(-over / noise.read_sigma / std::sqrt(2.0));
}

RfidReader::RfidReader(const Robot& robot, const Rng& rng)
    : antennas_(antennas_of(robot)), strays_(antennas_.size()), rng_(rng) {}

double RfidReader::shadowing(const IdealRfid& ideal, int tag, const RfidNoise& noise) const {
  if (noise.shadowing == 0.0) return 0.0;
  const auto cell = [&](double place) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(static_cast<std::int32_t>(
        std::floor(std::clamp(place / noise.shadowing_cell, -2e9, 2e9)))));
  };
  const std::uint64_t square = cell(ideal.place.x()) << 32 | cell(ideal.place.y());
  return noise.shadowing *
         rng_.stream("rfid shadowing", static_cast<std::uint64_t>(tag), square).normal();
}

// Of all tags with power enough.
std::vector<RfidReader::Answer> RfidReader::answers(const IdealRfid& ideal,
                                                    const RfidModel& model) const {
  std::vector<Answer> result;
  for (const IdealTag& tag : ideal.tags) {
    const std::uint64_t key =
        static_cast<std::uint64_t>(ideal.antenna) << 32 | static_cast<std::uint64_t>(tag.tag);
    const Draws draws(rng_.stream("rfid", key, ideal.round));
    const double power =
        tag.power + shadowing(ideal, tag.tag, model.noise) + fading(model.noise, draws);
    if (power < model.threshold) continue;
    const int slot = std::min(model.slots - 1, static_cast<int>(draws.slot * model.slots));
    result.push_back({&tag, power, slot, draws});
  }
  if (!model.noise.collisions) return result;
  std::vector<Answer> read;
  for (const Answer& answer : result) {
    double others = 0.0;
    for (const Answer& other : result) {
      if (&other != &answer && other.slot == answer.slot) others += power_of(2.0 * other.power);
    }
    const bool is_heard =
        others == 0.0 || 2.0 * answer.power > decibels_of(others) + model.noise.capture;
    if (is_heard) read.push_back(answer);
  }
  return read;
}

// Each tag once a round.
void RfidReader::tell(RfidRound& round, const IdealRfid& ideal, int tag, ReadMechanism mechanism,
                      const RfidRead& read) const {
  for (const TruthRead& told : round.reads) {
    if (told.tag == tag) return;
  }
  round.reads.push_back({ideal.time, ideal.antenna, tag, mechanism});
  round.detections.reads.push_back(read);
  round.detections.reads.back().tag = (*ideal.names)[static_cast<std::size_t>(tag)];
}

RfidRound RfidReader::read(const IdealRfid& ideal) {
  CHECK(ideal.antenna >= 0 && static_cast<std::size_t>(ideal.antenna) < antennas_.size());
  const auto index = static_cast<std::size_t>(ideal.antenna);
  const MountedAntenna& antenna = antennas_[index];
  const RfidModel& model = antenna.model;
  const RfidNoise& noise = model.noise;
  RfidRound round;
  round.detections.time = ideal.time;
  round.detections.antenna = ideal.antenna;
  round.detections.robot_from_antenna = antenna.robot_from_antenna;
  round.detections.frequency = model.frequency;

  std::vector<Stray> astray;
  astray.swap(strays_[index]);
  const std::size_t others = antennas_.size() - 1;
  for (const Answer& answer : answers(ideal, model)) {
    const RfidRead read =
        read_of(model, answer.power, answer.tag->phase, answer.draws.rssi, answer.draws.phase);
    if (others > 0 && answer.draws.is_astray < noise.wrong_antenna) {
      const auto step = std::min(others - 1, static_cast<std::size_t>(answer.draws.astray_to *
                                                                      static_cast<double>(others)));
      strays_[(index + 1 + step) % antennas_.size()].push_back({answer.tag->tag, read});
      continue;
    }
    tell(round, ideal, answer.tag->tag,
         answer.tag->is_reflection ? ReadMechanism::reflection : ReadMechanism::direct, read);
  }
  for (const Stray& stray : astray) {
    tell(round, ideal, stray.tag, ReadMechanism::wrong_antenna, stray.read);
  }
  Rng rng = rng_.stream("rfid ghosts", index, ideal.round);
  const int ghosts = ideal.names->empty() ? 0 : poisson(noise.ghosts, rng);
  for (int k = 0; k < ghosts; ++k) {
    const int tag = static_cast<int>(rng.index(ideal.names->size()));
    const double phase = rng.uniform(0.0, 2.0 * kPi);
    tell(round, ideal, tag, ReadMechanism::ghost,
         read_of(model, model.threshold, phase, rng.normal(), 0.0));
  }
  return round;
}

}  // namespace mapbed
