#include "core/log/ros/ros_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;

const std::string kCdr("\0\1\0\0", 4);

TEST(RosInput, OfCdrHasNumbersAtMultiplesOfTheirSizeAndStringsThatEndInZero) {
  // A byte, three of padding, a number; "ab" with its zero; five of padding, 2.0.
  const std::string bytes = kCdr + std::string("\x05\0\0\0\x01\x02\0\0\x03\0\0\0ab\0", 15) +
                            std::string(1, '\0') + std::string("\0\0\0\0\0\0\0\x40", 8);
  RosInput in(bytes, RosEncoding::cdr);
  EXPECT_EQ(in.number<std::uint8_t>(), 5);
  EXPECT_EQ(in.number<std::uint32_t>(), 0x201u);
  EXPECT_EQ(in.text(), "ab");
  EXPECT_EQ(in.number<double>(), 2.0);
  EXPECT_TRUE(in.is_at_end());
}

TEST(RosInput, OfRos1HasNoGapsAndNoZeros) {
  const std::string bytes("\x05\x01\x02\0\0\x02\0\0\0ab\0\0\0\0\0\0\0\x40", 19);
  RosInput in(bytes, RosEncoding::ros1);
  EXPECT_EQ(in.number<std::uint8_t>(), 5);
  EXPECT_EQ(in.number<std::uint32_t>(), 0x201u);
  EXPECT_EQ(in.text(), "ab");
  EXPECT_EQ(in.number<double>(), 2.0);
  EXPECT_TRUE(in.is_at_end());
}

TEST(RosInput, ThatIsNotLittleEndianCdrIsForeign) {
  EXPECT_TRUE(RosInput(std::string(8, '\0'), RosEncoding::cdr).is_foreign());
  EXPECT_FALSE(RosInput(kCdr, RosEncoding::cdr).is_foreign());
}

TEST(RosInput, HasNoMoreElementsThanBytes) {
  const std::string bytes("\xff\xff\xff\xff\x01\x02", 6);
  RosInput in(bytes, RosEncoding::ros1);
  EXPECT_THAT(in.floats(), ElementsAre());
  EXPECT_FALSE(in.ok());
  EXPECT_EQ(in.number<double>(), 0.0);
}

TEST(RosInput, StampsKeepTheirNanosecondsAsFarAsADoubleDoes) {
  EXPECT_EQ(seconds_of(1'600'000'000'100'000'000), 1600000000.1);
  EXPECT_EQ(seconds_of(100'000'000), 0.1);
  EXPECT_EQ(seconds_of(2'500'000'175), 2.500000175);  // 2 + 0.500000175 is one bit less
}

}  // namespace
}  // namespace mapbed
