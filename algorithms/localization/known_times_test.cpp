#include "algorithms/localization/known_times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/remark_texts.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(KnownTimes, TellWhenAndWhyThePlaceWasNotKnown) {
  KnownTimes times;
  for (const double t : {10.0, 11.0, 12.0}) times.add(t, Unknown::several);
  for (const double t : {13.0, 14.0}) times.add(t, Unknown::none);
  times.add(15.0, Unknown::several);
  for (const double t : {16.0, 17.0}) times.add(t, Unknown::nowhere);
  EXPECT_THAT(times.lost(), ElementsAre(TimeInterval{10.0, 12.0}, TimeInterval{15.0, 17.0}));
  EXPECT_THAT(
      texts_of(times.remarks(10.0)),
      ElementsAre("the place on the map is not known from 0.0 s to 2.0 s: scans fit it in several "
                  "places",
                  "the place on the map is known from 3.0 s on",
                  "the place on the map is not known from 5.0 s to 7.0 s: scans do not fit it "
                  "where the robot should be"));
}

TEST(KnownTimes, SayNothingWhereItWasKnownAllAlong) {
  KnownTimes times;
  times.add(10.0, Unknown::none);
  EXPECT_THAT(times.lost(), IsEmpty());
  EXPECT_THAT(times.remarks(10.0), IsEmpty());
}

}  // namespace
}  // namespace mapbed
