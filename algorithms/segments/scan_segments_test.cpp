#include "algorithms/segments/scan_segments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/people/testing/people_in_a_room.h"

namespace mapbed {
namespace {

using ::testing::SizeIs;

ScanView seen(const TestRoom& room, double time) {
  return ScanView(scan_of(room, {}, round_laser(), time));
}

// Four scans of a room, 0.5 s apart.
RecentScans past_of(const TestRoom& room) {
  RecentScans past({});
  for (int k = 0; k < 4; ++k) {
    const ScanView view = seen(room, 0.5 * k);
    past.add(view, {}, std::vector<bool>(view.scan().ranges.size(), false));
  }
  return past;
}

std::vector<ScanSegment> free_ones(std::vector<ScanSegment> segments) {
  std::erase_if(segments, [](const ScanSegment& s) { return s.before != SeenBefore::free; });
  return segments;
}

TEST(ScanSegments, OfAnEmptyRoomAreItsWallsWhichStoodThere) {
  const TestRoom room = rectangular_room(8.0, 6.0);
  const std::vector<ScanSegment> segments =
      segments_of(seen(room, 2.0), {}, past_of(room), ScanSegmentOptions{});
  ASSERT_THAT(segments, SizeIs(1)) << "corners are no jumps";
  EXPECT_EQ(segments[0].before, SeenBefore::same);
  EXPECT_THAT(segments[0].beams, SizeIs(271));
  EXPECT_NEAR(segments[0].box.sizes().y(), 6.0, 0.2);
}

TEST(ScanSegments, WhatCameIsOneOfItsOwn) {
  const TestRoom empty = rectangular_room(8.0, 6.0);
  TestRoom room = empty;
  room.add_box({2.0, 0.0}, 0.4, 0.4);
  const std::vector<ScanSegment> segments =
      free_ones(segments_of(seen(room, 2.0), {}, past_of(empty), {}));
  ASSERT_THAT(segments, SizeIs(1));
  // Its near side of 0.4 m at 1.8 m: beams up to 6.34 deg to each side, 13 in all.
  EXPECT_THAT(segments[0].beams, SizeIs(13));
  EXPECT_NEAR(segments[0].box.center().x(), 1.8, 0.01);
  EXPECT_NEAR(segments[0].box.center().y(), 0.0, 0.01);
}

TEST(ScanSegments, EndWhereRangesJumpAlsoWhereAllStoodThere) {
  TestRoom room = rectangular_room(8.0, 6.0);
  room.add_box({2.0, 0.0}, 0.4, 0.4);
  const std::vector<ScanSegment> segments = segments_of(seen(room, 2.0), {}, past_of(room), {});
  ASSERT_THAT(segments, SizeIs(3)) << "the wall to either side, and the box";
  EXPECT_THAT(segments[1].beams, SizeIs(13));
  EXPECT_NE(segments[0].piece, segments[1].piece);
  EXPECT_NE(segments[1].piece, segments[2].piece);
}

// No range jumps where something touches the wall; what stood there before ends.
TEST(ScanSegments, WhoLeansOnAWallIsAnotherThanTheWall) {
  const TestRoom empty = rectangular_room(8.0, 6.0);
  TestRoom room = empty;
  room.add({{4.0, -0.5}, {3.5, 0.0}});
  room.add({{3.5, 0.0}, {4.0, 0.5}});
  const std::vector<ScanSegment> segments =
      free_ones(segments_of(seen(room, 2.0), {}, past_of(empty), {}));
  ASSERT_THAT(segments, SizeIs(1));
  EXPECT_NEAR(segments[0].box.min().x(), 3.5, 0.01);
  EXPECT_LT(segments[0].box.sizes().y(), 1.0);
}

TEST(ScanSegments, WhereNobodyLookedBeforeNothingIsKnown) {
  const TestRoom room = rectangular_room(8.0, 6.0);
  const std::vector<ScanSegment> segments = segments_of(seen(room, 2.0), {}, RecentScans({}), {});
  ASSERT_THAT(segments, SizeIs(1));
  EXPECT_EQ(segments[0].before, SeenBefore::nothing);
}

}  // namespace
}  // namespace mapbed
