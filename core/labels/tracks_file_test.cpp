#include "core/labels/tracks_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

TrackState state_at(double time, double x, bool occluded) {
  TrackState state;
  state.time = time;
  state.position = {x, -1.25};
  state.velocity = {0.5, 1.0};
  state.covariance << 0.04, 0.01, 0.01, 0.09;
  state.occluded = occluded;
  return state;
}

TEST(TracksFile, IsReadAsItWasWritten) {
  const Tracks tracks{{3, {state_at(976052857.25, 1.5, false), state_at(976052857.5, 1.75, true)}},
                      {7, {state_at(976052857.5, 2.0, false)}}};
  const Tracks read = parse_tracks("t.csv", tracks_csv(tracks));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].id, 3);
  EXPECT_EQ(read[1].id, 7);
  ASSERT_EQ(read[0].states.size(), 2U);
  const TrackState& state = read[0].states[1];
  EXPECT_EQ(state.time, 976052857.5);
  EXPECT_EQ(state.position, Eigen::Vector2d(1.75, -1.25));
  EXPECT_EQ(state.velocity, Eigen::Vector2d(0.5, 1.0));
  EXPECT_EQ(state.covariance, state_at(0.0, 0.0, true).covariance);
  EXPECT_TRUE(state.occluded);
  EXPECT_FALSE(read[0].states[0].occluded);
}

TEST(TracksFile, OfNobodyHasNoTracks) {
  EXPECT_TRUE(parse_tracks("t.csv", tracks_csv({})).empty());
}

TEST(TracksFile, WhatIsNoneIsRefusedWithTheLine) {
  const std::string header = tracks_csv({});
  EXPECT_INPUT_ERROR(parse_tracks("t.csv", "a,b\n"), "t.csv:1: is no table of tracks");
  EXPECT_INPUT_ERROR(parse_tracks("t.csv", header + "1,2,x,4,5,6,7,8,9,0\n"),
                     "t.csv:2: 'x' is not a number");
  EXPECT_INPUT_ERROR(parse_tracks("t.csv", header + "1.5,2,3,4,5,6,7,8,9,0\n"),
                     "t.csv:2: '1.5' is not the number of a track");
  EXPECT_INPUT_ERROR(parse_tracks("t.csv", header + "1,2,3,4,5,6,7,8,9,0\n1,2,3,4,5,6,7,8,9,0\n"),
                     "t.csv:3: track 1 goes back in time");
}

}  // namespace
}  // namespace mapbed
