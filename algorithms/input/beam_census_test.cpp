#include "algorithms/input/beam_census.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/remark_texts.h"
#include "core/random.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Of 30 scans with so many beams; `fails` says which.
template <class Fails>
std::vector<std::string> told_of(std::size_t beams, Fails&& fails) {
  BeamCensus census;
  for (int i = 0; i < 30; ++i) {
    LaserScan scan{.max_range = 8.0};
    for (std::size_t beam = 0; beam < beams; ++beam) {
      scan.ranges.push_back(fails(beam) ? 0.0 : 2.0);
    }
    census.add(scan);
  }
  return texts_of(census.remarks());
}

TEST(BeamCensus, TellsOfFewBeams) {
  const auto none = [](std::size_t) { return false; };
  EXPECT_THAT(told_of(19, none), ElementsAre(HasSubstr("laser 0 has 19 beams a scan")));
  EXPECT_THAT(told_of(8, none), ElementsAre(HasSubstr("8 beams a scan")));
  EXPECT_THAT(told_of(90, none), IsEmpty());
}

TEST(BeamCensus, TellsOfBeamsThatFailHereAndThere) {
  for (const double fraction : {0.3, 0.7}) {
    Rng rng(1);
    EXPECT_THAT(told_of(181, [&](std::size_t) { return rng.uniform() < fraction; }),
                ElementsAre(HasSubstr("% of the beams of laser 0 fail")));
  }
  Rng rng(1);
  EXPECT_THAT(told_of(181, [&](std::size_t) { return rng.uniform() < 0.05; }), IsEmpty());
}

// As lasers do that tell 0 of what gives no return.
TEST(BeamCensus, DoesNotMindBeamsThatFailTogether) {
  EXPECT_THAT(told_of(181, [](std::size_t beam) { return beam > 60; }), IsEmpty());
}

}  // namespace
}  // namespace mapbed
