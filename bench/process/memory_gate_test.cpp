#include "bench/process/memory_gate.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(MemoryGate, LetsInAsManyAsThereIsRoomFor) {
  double available = 1000.0;
  double taken = 50.0;
  MemoryGate gate([&] { return available; }, [&] { return taken; });
  gate.enter();
  taken = 450.0;  // the job takes 400
  available = 850.0;
  EXPECT_TRUE(gate.has_room());
  available = 750.0;
  EXPECT_FALSE(gate.has_room());
  gate.leave();
  EXPECT_TRUE(gate.has_room());  // one can always work
}

}  // namespace
}  // namespace mapbed
