#include "algorithms/rfid/tag_mapper.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "algorithms/rfid/tag_answer.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

RfidDetections heard(std::vector<std::string> tags, double heading = 0.0) {
  RfidDetections round;
  round.robot_from_antenna.planar = {0.0, 0.0, heading};
  for (std::string& tag : tags) round.reads.push_back({std::move(tag)});
  return round;
}

const LearnedRfid kArc{PiecewiseAntenna{.opening = radians(91.0),
                                        .range = 4.0,
                                        .disc_radius = 0.5,
                                        .arc_rate = 0.9,
                                        .disc_rate = 0.9,
                                        .elsewhere_rate = 0.05}};

// What every position gets, by hand: the product of (7.1).
TEST(TagMapper, WeightsArePositionsUnderTheProductOfAllReadings) {
  TagMapper mapper(kArc, {.positions = 200}, Rng(3));
  const std::vector<Pose2> path{{0.0, 0.0, 0.0}, {1.0, 0.5, 1.0}, {2.0, 2.0, -2.0}};
  for (const Pose2& robot : path) mapper.add(heard({"a"}), robot);
  const TagBelief belief = mapper.belief("a");
  ASSERT_EQ(belief.positions.size(), 200u);
  std::vector<double> product(200, 1.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < 200; ++i) {
    for (const Pose2& robot : path) {
      // By the middle of the table's cell, which is what the model is asked for.
      Eigen::Vector2d tag = inverse(robot) * belief.positions[i];
      tag = (tag.array() / 0.1).floor() * 0.1 + 0.05;
      product[i] *= detection_probability(kArc[0], tag);
    }
    sum += product[i];
  }
  int off = 0;  // on the border of a cell, float and double may differ
  for (std::size_t i = 0; i < 200; ++i) {
    if (std::abs(belief.weights[i] - product[i] / sum) > 1e-5) ++off;
  }
  EXPECT_LE(off, 2);
}

TEST(TagMapper, PositionsLieInASquareAboutWhereTheTagWasFirstHeard) {
  TagMapper mapper(kArc, {.positions = 4000}, Rng(3));
  mapper.add(heard({"a"}), {10.0, 20.0, 0.7});
  const TagBelief belief = mapper.belief("a");
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Eigen::Vector2d& p : belief.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // Twice the reach of 4 m and the margin of 1 m.
  EXPECT_NEAR(low.x(), 5.0, 0.02);
  EXPECT_NEAR(high.x(), 15.0, 0.02);
  EXPECT_NEAR(low.y(), 15.0, 0.02);
  EXPECT_NEAR(high.y(), 25.0, 0.02);
}

const Eigen::Vector2d kTag(5.0, 2.0);

// The robot drives past the tag to its left, on one line or two, with an antenna that looks there.
TagAnswer answer_of_a_drive(int lines, const TagMapperOptions& options) {
  const double left = radians(90.0);
  TagMapper mapper(kArc, options, Rng(5));
  for (int i = 0; i < 101 * lines; ++i) {
    const Pose2 robot{0.1 * (i % 101), i <= 100 ? 0.0 : -1.0, 0.0};
    const Eigen::Vector2d in_antenna = inverse(robot * Pose2{0.0, 0.0, left}) * kTag;
    const bool answers = detection_probability(kArc[0], in_antenna) > 0.5;
    mapper.add(heard(answers ? std::vector<std::string>{"a"} : std::vector<std::string>{}, left),
               robot);
  }
  return answer_of(mapper.belief("a"));
}

TEST(TagMapper, FindsATagWherePassedOnTwoLines) {
  const TagAnswer answer = answer_of_a_drive(2, {.positions = 4000, .non_detections = true});
  EXPECT_LT((answer.most_likely - kTag).norm(), 0.35);  // positions are 0.16 m apart
  EXPECT_LT((answer.mean - kTag).norm(), 0.35);
  EXPECT_EQ(answer.modes, 1);
}

// On one line a tag farther away, with less of the line in range, is heard as long: the arc's sides
// meet it at 45.5 degrees, its end at a distance of 4 m.
TEST(TagMapper, OnOneLineATagMayBeInTwoPlacesAndSilenceRulesOutAllOthers) {
  const TagAnswer both = answer_of_a_drive(1, {.positions = 4000, .non_detections = true});
  const TagAnswer heard_only = answer_of_a_drive(1, {.positions = 4000});
  EXPECT_EQ(both.modes, 2);
  const double farther = std::sqrt(16.0 - std::pow(2.0 * std::tan(radians(45.5)), 2));
  const double y = both.most_likely.y();
  EXPECT_LT(std::min(std::abs(y - kTag.y()), std::abs(y - farther)), 0.35);
  EXPECT_NE(heard_only.modes, 2);
}

TEST(TagMapper, OneTagSaysNothingOfAnother) {
  TagMapper alone(kArc, {}, Rng(3)), together(kArc, {}, Rng(3));
  alone.add(heard({"a"}), {});
  together.add(heard({"b", "a"}), {});
  alone.add(heard({"a"}), {1.0, 1.0, 1.0});
  together.add(heard({"b"}), {0.5, 0.0, 0.0});
  together.add(heard({"a", "c"}), {1.0, 1.0, 1.0});
  EXPECT_EQ(alone.belief("a").positions, together.belief("a").positions);
  EXPECT_EQ(alone.belief("a").weights, together.belief("a").weights);
  EXPECT_EQ(together.detections("b"), 2);
  EXPECT_EQ(together.detections("nobody"), 0);
}

TEST(TagMapper, ReadingsFromOnePlaceCountLessAndLessWhereFadingIsThePlaces) {
  TagMapper once(kArc, {.news_distance = 0.5}, Rng(3)), often(kArc, {.news_distance = 0.5}, Rng(3));
  TagMapper all(kArc, {}, Rng(3));
  for (int i = 0; i < 100; ++i) {
    if (i == 0) once.add(heard({"a"}), {});
    often.add(heard({"a"}), {});
    all.add(heard({"a"}), {});
  }
  const auto log_ratio = [](const TagMapper& mapper) {
    const TagBelief belief = mapper.belief("a");
    const auto [low, high] = std::minmax_element(belief.weights.begin(), belief.weights.end());
    return std::log(*high / *low);
  };
  const double one = std::log(0.9 / 0.05);
  double harmonic = 0.0;
  for (int i = 1; i <= 100; ++i) harmonic += 1.0 / i;
  EXPECT_NEAR(log_ratio(once), one, 1e-4);
  EXPECT_NEAR(log_ratio(often), harmonic * one, 1e-3);
  EXPECT_NEAR(log_ratio(all), 100.0 * one, 0.01);
}

TEST(TagMapper, RefusesWhatTheModelDoesNotKnow) {
  EXPECT_THROW(TagMapper(kArc, {.rssi = true}, Rng(1)), InputError);
  TagMapper mapper(kArc, {}, Rng(1));
  RfidDetections round = heard({"a"});
  round.antenna = 1;
  EXPECT_THROW(mapper.add(round, {}), InputError);
  round.antenna = -1;
  EXPECT_THROW(mapper.add(round, {}), InputError);
}

TEST(TagAnswer, TellsTwoPlacesApart) {
  TagBelief belief{"a", {}, {}};
  for (int i = 0; i < 10; ++i) {
    belief.positions.emplace_back(0.01 * i, 0.0);
    belief.weights.push_back(0.06);
    belief.positions.emplace_back(5.0, 0.01 * i);
    belief.weights.push_back(0.035);
    belief.positions.emplace_back(0.0, 5.0);
    belief.weights.push_back(0.005);
  }
  const TagAnswer answer = answer_of(belief);
  EXPECT_EQ(answer.modes, 2);  // the third holds a twentieth
  EXPECT_LT(answer.most_likely.norm(), 0.1);
  EXPECT_NEAR(answer.mean.x(), 0.6 * 0.045 + 0.35 * 5.0, 1e-9);
}

TEST(TagAnswer, OfOnePlaceIsThatPlace) {
  const TagAnswer answer = answer_of({"a", {{1.0, 2.0}}, {1.0}});
  EXPECT_EQ(answer.most_likely, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(answer.spread, 0.0);
  EXPECT_EQ(answer.modes, 1);
  EXPECT_EQ(answer_of({}).modes, 0);
}

}  // namespace
}  // namespace mapbed
