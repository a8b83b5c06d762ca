#include "sim/truth/columns.h"

#include <limits>

namespace mapbed {
namespace {

TEST(Columns, ComeBackAsTheyWereWritten) {
  const std::vector<double> numbers{0.0, -1.5, 1e300, 0.1};
  const std::vector<std::int32_t> planes{0, 1, -1, std::numeric_limits<std::int32_t>::min(),
                                         70'000};
  std::string bytes;
  append_number(bytes, 4'000'000'000U);
  append_numbers(bytes, numbers);
  append_planes(bytes, planes);
  ASSERT_EQ(bytes.size(), 4 + 8 * numbers.size() + 1 + 4 * planes.size());

  ColumnReader reader(bytes);
  EXPECT_EQ(reader.number(), 4'000'000'000U);
  EXPECT_EQ(reader.numbers(4), numbers);
  EXPECT_EQ(reader.planes(5), planes);
  EXPECT_TRUE(reader.ok());
  EXPECT_TRUE(reader.at_end());
}

TEST(Columns, PlanesAreTheLowestBytesFirst) {
  std::string bytes;
  append_planes(bytes, std::vector<std::int32_t>{0x04030201, 0x14131211});
  EXPECT_EQ(bytes, "\x04\x01\x11\x02\x12\x03\x13\x04\x14");
}

TEST(Columns, HaveAsManyPlanesAsTheirLargestNumberNeeds) {
  for (const auto& [number, planes] : {std::pair{0, 1},
                                       {127, 1},
                                       {128, 2},
                                       {-128, 1},
                                       {-129, 2},
                                       {32'767, 2},
                                       {32'768, 3},
                                       {-8'388'608, 3},
                                       {8'388'608, 4}}) {
    std::string bytes;
    append_planes(bytes, std::vector<std::int32_t>{number, -1});
    EXPECT_EQ(bytes.size(), 1u + 2u * static_cast<std::size_t>(planes)) << number;
    EXPECT_EQ(ColumnReader(bytes).planes(2), (std::vector<std::int32_t>{number, -1}));
  }
}

TEST(Columns, DifferencesAddUpAgainEvenWhereTheyWrap) {
  const std::vector<std::int32_t> given{
      5, 7, 7, std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min(),
      0};
  std::vector<std::int32_t> numbers = given;
  difference(numbers, 3);
  EXPECT_EQ((std::vector<std::int32_t>{numbers[0], numbers[1], numbers[2]}),
            (std::vector<std::int32_t>{5, 2, 0}));
  EXPECT_EQ(numbers[3], given[3]);  // each run begins anew
  accumulate(numbers, 3);
  EXPECT_EQ(numbers, given);
}

TEST(Columns, MoreThanThereIsIsNotOk) {
  for (const std::size_t count : {std::size_t{2}, std::numeric_limits<std::size_t>::max()}) {
    ColumnReader reader(
        "\x02"
        "123");
    EXPECT_TRUE(reader.planes(count).empty());
    EXPECT_FALSE(reader.ok());
    EXPECT_EQ(reader.number(), 0U);  // and stays so
  }
}

}  // namespace
}  // namespace mapbed
