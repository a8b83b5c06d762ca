#include "sim/noise/rfid_noise.h"

#include <cmath>
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

Robot robot_with(const RfidModel& model, int antennas = 2) {
  Robot robot;
  for (int i = 0; i < antennas; ++i) {
    robot.sensors.push_back({"antenna " + std::to_string(i), "", {}, model});
  }
  return robot;
}

std::shared_ptr<const std::vector<std::string>> names(int count) {
  std::vector<std::string> list;
  for (int i = 0; i < count; ++i) list.push_back("tag_" + std::to_string(i));
  return std::make_shared<const std::vector<std::string>>(list);
}

// A round in which all tags receive so much.
IdealRfid ideal_round(std::uint64_t number, int tags, double power, int antenna = 0) {
  IdealRfid round{.time = 0.1 * static_cast<double>(number), .round = number, .antenna = antenna};
  round.names = names(tags);
  for (int i = 0; i < tags; ++i) {
    round.tags.push_back({.tag = i, .power = static_cast<float>(power)});
  }
  return round;
}

// Without any chance but what a test turns on.
RfidModel plain() {
  RfidModel model;
  model.noise.shadowing = 0.0;
  model.noise.fading = Fading::off;
  model.noise.collisions = false;
  model.noise.ghosts = model.noise.wrong_antenna = 0.0;
  model.noise.rssi_sigma = model.noise.phase_sigma = 0.0;
  return model;
}

std::vector<RfidRound> rounds(const RfidModel& model, int count, int tags, double power,
                              std::uint64_t seed = 1) {
  RfidReader reader(robot_with(model), Rng(seed));
  std::vector<RfidRound> result;
  for (int k = 0; k < count; ++k) {
    result.push_back(reader.read(ideal_round(static_cast<std::uint64_t>(k), tags, power, k % 2)));
  }
  return result;
}

// Reads by round and tag.
std::map<std::pair<std::size_t, int>, RfidRead> by_place(const std::vector<RfidRound>& told,
                                                         ReadMechanism mechanism) {
  std::map<std::pair<std::size_t, int>, RfidRead> result;
  for (std::size_t k = 0; k < told.size(); ++k) {
    for (std::size_t i = 0; i < told[k].reads.size(); ++i) {
      if (told[k].reads[i].mechanism != mechanism) continue;
      result[{k, told[k].reads[i].tag}] = told[k].detections.reads[i];
    }
  }
  return result;
}

bool are_alike(const RfidRead& a, const RfidRead& b) {
  return a.tag == b.tag && a.rssi == b.rssi && a.phase == b.phase;
}

TEST(RfidNoise, ProbabilitiesAreProbabilitiesAndGrowWithPower) {
  RfidModel model;
  for (const Fading fading : {Fading::off, Fading::threshold, Fading::rice}) {
    model.noise.fading = fading;
    double last = 0.0;
    for (double power = -100.0; power < 60.0; power += 0.25) {
      const double p = answer_probability(model, power);
      EXPECT_GE(p, last - 1e-9);
      EXPECT_LE(p, 1.0);
      last = p;
    }
    EXPECT_GT(last, 1.0 - 1e-7);  // Rice's power is next to nothing as seldom as that
  }
  model.noise.fading = Fading::threshold;
  EXPECT_NEAR(answer_probability(model, model.threshold), 0.5, 1e-12);
  // Phi(1) and Phi(-2).
  EXPECT_NEAR(answer_probability(model, model.threshold + 1.0), 0.841345, 1e-6);
  EXPECT_NEAR(answer_probability(model, model.threshold - 2.0), 0.022750, 1e-6);
}

// Without a constant part Rice's distribution is Rayleigh's: the power is exponential.
TEST(RfidNoise, RiceWithoutAConstantPartIsRayleigh) {
  RfidModel model;
  model.noise.fading = Fading::rice;
  model.noise.rice_factor = -30.0;
  for (const double over : {-6.0, 0.0, 6.0}) {
    EXPECT_NEAR(answer_probability(model, model.threshold + over),
                std::exp(-std::pow(10.0, -over / 10.0)), 2e-3);
  }
}

TEST(RfidNoise, TagsAnswerAsOftenAsTheProbabilitySays) {
  for (const Fading fading : {Fading::threshold, Fading::rice}) {
    for (const double over : {-2.0, 0.0, 1.5}) {
      RfidModel model = plain();
      model.noise.fading = fading;
      const double p = answer_probability(model, model.threshold + over);
      constexpr int kRounds = 400, kTags = 50;
      std::size_t count = 0;
      for (const RfidRound& round : rounds(model, kRounds, kTags, model.threshold + over)) {
        count += round.reads.size();
      }
      const double n = kRounds * kTags;
      EXPECT_NEAR(static_cast<double>(count) / n, p, 5.0 * std::sqrt(p * (1.0 - p) / n) + 1e-4);
    }
  }
}

TEST(RfidNoise, ShadowingIsTheSameWheneverTheAntennaIsInTheSameSquare) {
  RfidModel model = plain();
  model.noise.shadowing = 3.0;
  RfidReader reader(robot_with(model), Rng(2));
  IdealRfid round = ideal_round(0, 200, model.threshold);
  const auto answering = [&](double x, double y) {
    round.place = {x, y};
    ++round.round;
    std::set<int> tags;
    for (const TruthRead& read : reader.read(round).reads) tags.insert(read.tag);
    return tags;
  };
  const std::set<int> here = answering(1.01, 1.01);
  EXPECT_EQ(answering(1.24, 1.24), here);
  EXPECT_NE(answering(1.26, 1.24), here);
  EXPECT_NE(answering(-1.01, 1.01), here);
  EXPECT_EQ(answering(1.1, 1.1), here);
  EXPECT_NEAR(static_cast<double>(here.size()), 100.0, 5.0 * std::sqrt(50.0));
}

// Framed slotted ALOHA: of n tags in L slots n (1 - 1/L)^(n - 1) are alone in theirs.
TEST(RfidNoise, AsManyTagsAreReadAsAreAloneInTheirSlots) {
  RfidModel model = plain();
  model.noise.collisions = true;
  model.slots = 16;
  constexpr int kRounds = 2000, kTags = 12;
  std::size_t count = 0;
  for (const RfidRound& round : rounds(model, kRounds, kTags, 0.0)) count += round.reads.size();
  const double expected = kTags * std::pow(1.0 - 1.0 / 16.0, kTags - 1);
  // A round's number of reads varies by less than that of independent tags would, 12 / 4.
  EXPECT_NEAR(static_cast<double>(count) / kRounds, expected, 5.0 * std::sqrt(3.0 / kRounds));
}

// There and back: 4 dB more at the tag are 8 dB at the reader.
TEST(RfidNoise, OfTwoInOneSlotTheOneThatIsMuchStrongerIsRead) {
  RfidModel model = plain();
  model.noise.collisions = true;
  model.slots = 1;
  RfidReader reader(robot_with(model), Rng(1));
  IdealRfid round = ideal_round(0, 2, 0.0);
  EXPECT_TRUE(reader.read(round).reads.empty());
  round.tags[1].power = 4.0F;
  const RfidRound told = reader.read(round);
  ASSERT_EQ(told.reads.size(), 1u);
  EXPECT_EQ(told.reads[0].tag, 1);
  round.tags[1].power = 2.0F;
  EXPECT_TRUE(reader.read(round).reads.empty());
}

TEST(RfidNoise, RssiIsThatOfTheWayThereAndBackInStepsAndPhaseIsThatOfTheIdealRound) {
  RfidModel model = plain();
  RfidReader reader(robot_with(model), Rng(1));
  IdealRfid round = ideal_round(0, 20, -10.0);
  for (IdealTag& tag : round.tags) tag.phase = 2.3456F;
  const RfidRound told = reader.read(round);
  ASSERT_EQ(told.reads.size(), 20u);
  for (const RfidRead& read : told.detections.reads) {
    // -10 - 6 sent back; 46 lost on the way as on the way there, 6 gained by the antenna.
    EXPECT_EQ(read.rssi, -62.0 + 6.0);
    EXPECT_EQ(read.phase, 2.345);
  }
  EXPECT_EQ(told.detections.reads[7].tag, "tag_7");
  EXPECT_EQ(told.detections.frequency, 915e6);
  EXPECT_EQ(told.reads[0].mechanism, ReadMechanism::direct);
}

TEST(RfidNoise, GhostsAndStraysAreAsOftenAsWasAskedFor) {
  RfidModel model = plain();
  model.noise.ghosts = 0.05;
  constexpr int kRounds = 20'000;
  const std::vector<RfidRound> ghostly = rounds(model, kRounds, 40, -100.0);
  const auto ghosts = by_place(ghostly, ReadMechanism::ghost);
  EXPECT_NEAR(static_cast<double>(ghosts.size()), 1000.0, 5.0 * std::sqrt(1000.0));
  std::set<int> tags;
  for (const auto& [place, read] : ghosts) tags.insert(place.second);
  EXPECT_EQ(tags.size(), 40u) << "every tag of the world";

  model = plain();
  model.noise.wrong_antenna = 0.1;
  const std::vector<RfidRound> told = rounds(model, 1000, 10, 0.0);
  std::size_t direct = by_place(told, ReadMechanism::direct).size();
  EXPECT_NEAR(static_cast<double>(direct), 9000.0, 5.0 * std::sqrt(900.0));
  // What one antenna's tags say that the other reads as well anyway is told once: 0.1 of the 0.1.
  const auto strays = by_place(told, ReadMechanism::wrong_antenna);
  EXPECT_NEAR(static_cast<double>(strays.size()), 100.0, 5.0 * std::sqrt(100.0));
}

TEST(RfidNoise, OfARobotWithOneAntennaNoneIsWrong) {
  RfidModel model = plain();
  model.noise.wrong_antenna = 1.0;
  RfidReader reader(robot_with(model, 1), Rng(1));
  EXPECT_EQ(reader.read(ideal_round(0, 5, 0.0)).reads.size(), 5u);
}

// Common random numbers: what is turned off takes its own reads away and leaves all others alone.
TEST(RfidNoise, EachMechanismTurnedOffChangesNothingElse) {
  RfidModel all;
  all.noise.ghosts = 0.2;
  all.noise.wrong_antenna = 0.1;
  all.slots = 8;
  const auto told = [&](const RfidModel& model) { return rounds(model, 500, 10, -13.0); };
  const auto base = by_place(told(all), ReadMechanism::direct);
  ASSERT_GT(base.size(), 300u);

  RfidModel model = all;
  model.noise.ghosts = 0.0;
  const auto without_ghosts = told(model);
  EXPECT_TRUE(by_place(without_ghosts, ReadMechanism::ghost).empty());
  const auto rest = by_place(without_ghosts, ReadMechanism::direct);
  ASSERT_EQ(rest.size(), base.size());
  for (const auto& [place, read] : base) EXPECT_TRUE(are_alike(rest.at(place), read));

  // Without strays or collisions all that was read before is read again, and more.
  for (const bool strays : {false, true}) {
    model = all;
    if (strays)
      model.noise.wrong_antenna = 0.0;
    else
      model.noise.collisions = false;
    const auto more = by_place(told(model), ReadMechanism::direct);
    EXPECT_GT(more.size(), base.size());
    for (const auto& [place, read] : base) EXPECT_TRUE(are_alike(more.at(place), read));
  }

  // Errors of power and phase do not change who is read.
  model = all;
  model.noise.rssi_sigma = model.noise.phase_sigma = 0.0;
  const auto exact = by_place(told(model), ReadMechanism::direct);
  ASSERT_EQ(exact.size(), base.size());
  for (const auto& [place, read] : exact) EXPECT_TRUE(base.contains(place));

  // Without shadowing or fading other tags answer, each as it draws.
  for (const bool shadowing : {false, true}) {
    model = all;
    if (shadowing)
      model.noise.shadowing = 0.0;
    else
      model.noise.fading = Fading::off;
    const auto other = by_place(told(model), ReadMechanism::direct);
    EXPECT_NE(other.size(), base.size());
  }
}

TEST(RfidNoise, TheSameSeedDrawsTheSameAndAnotherAnother) {
  const RfidModel model;
  const auto a = by_place(rounds(model, 50, 20, -12.0, 1), ReadMechanism::direct);
  const auto b = by_place(rounds(model, 50, 20, -12.0, 1), ReadMechanism::direct);
  const auto c = by_place(rounds(model, 50, 20, -12.0, 2), ReadMechanism::direct);
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [place, read] : a) EXPECT_TRUE(are_alike(b.at(place), read));
  EXPECT_NE(a.size(), c.size());
}

}  // namespace
}  // namespace mapbed
