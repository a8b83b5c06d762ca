#include "bench/metrics/entropy.h"

#include <cmath>

#include <gmock/gmock.h>

namespace mapbed {
namespace {

TEST(MeanEntropy, IsNoneWhereAllIsSureAndOneBitWhereNothingIs) {
  OccupancyMap map(1.0);
  map.at({0, 0}) = known(0.0);
  map.at({1, 0}) = known(1.0);
  EXPECT_DOUBLE_EQ(mean_entropy(map), 0.0);
  map.at({0, 0}) = map.at({1, 0}) = known(0.5);
  EXPECT_DOUBLE_EQ(mean_entropy(map), 1.0);
}

TEST(MeanEntropy, IsOverTheKnownCellsAlone) {
  OccupancyMap map(1.0);
  EXPECT_TRUE(std::isnan(mean_entropy(map)));
  map.at({0, 0}) = known(0.5);
  map.at({40, 40}) = known(1.0);
  EXPECT_DOUBLE_EQ(mean_entropy(map), 0.5);
}

}  // namespace
}  // namespace mapbed
