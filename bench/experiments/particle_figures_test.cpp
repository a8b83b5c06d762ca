#include "bench/experiments/particle_figures.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "bench/plot/testing/well_formed.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

// Two particles that have gone 1 m together and then apart.
Hypotheses two_particles() {
  Hypotheses hypotheses;
  hypotheses.branches = {{{10.0, {0, 0, 0}}, {11.0, {1, 0, 0}}, {12.0, {2, 0.5, 0}}},
                         {{11.0, {1, 0, 0}}, {12.0, {2, -0.5, 0}}}};
  hypotheses.diversity = {{10.0, 1, 2.0, false}, {11.0, 1, 1.2, true}, {12.0, 2, 1.9, false}};
  return hypotheses;
}

TEST(ParticleFigures, OfAMethodWithoutParticlesAreNone) {
  EXPECT_TRUE(path_figure({}, {}, {}, 1.0, "").empty());
}

TEST(ParticleFigures, ShowAllPathsInTheWorldUpToNow) {
  const Trajectory truth{{10.0, {5, 5, 0}}, {12.0, {7, 5, 0}}, {99.0, {50, 50, 0}}};
  const auto files = path_figure(two_particles(), truth, {5.0, 5.0, 0.0}, 2.0, "few, noise = 2");
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].path, "figures/paths_after_2_s.svg");
  EXPECT_TRUE(is_well_formed(files[0].content));
  EXPECT_THAT(files[0].content, HasSubstr("What 2 particles hold possible after 2 s"));
  EXPECT_THAT(files[0].content, HasSubstr("few, noise = 2; the first seed"));
  EXPECT_THAT(files[1].content, HasSubstr("7,5.5"));
  EXPECT_THAT(files[1].content, HasSubstr("7,4.5"));
  EXPECT_THAT(files[1].content, ::testing::Not(HasSubstr("50,50")));  // true, but later
}

TEST(ParticleFigures, LeaveOutWhatNobodyWouldSee) {
  Hypotheses along_a_corner;
  Trajectory path;
  for (int i = 0; i <= 100; ++i)
    path.push_back({0.0 + i, {0.1 * i, i % 2 == 0 ? 0.0 : 0.005, 0.0}});
  for (int i = 1; i <= 100; ++i) path.push_back({100.0 + i, {10.0, 0.1 * i, 0.0}});
  along_a_corner.branches = {path};
  const std::string csv = path_figure(along_a_corner, {}, {}, 200.0, "")[1].content;
  EXPECT_THAT(csv, HasSubstr(",0,0,,\n"));
  EXPECT_THAT(csv, HasSubstr(",10,0,,\n"));  // the corner
  EXPECT_THAT(csv, HasSubstr(",10,10,,\n"));
  EXPECT_LE(std::count(csv.begin(), csv.end(), '\n'), 6);  // with the head and the gap's line
}

}  // namespace
}  // namespace mapbed
