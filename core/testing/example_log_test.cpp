#include "core/testing/example_log.h"

#include <gtest/gtest.h>

#include "core/file/text_file.h"
#include "core/log/dialects/carmen_log.h"
#include "core/testing/source_tree.h"

namespace mapbed {
namespace {

const std::string kShipped = source_tree() + "/scenarios/logs/example.log.gz";

TEST(ExampleLog, IsWhatItsGeneratorMakes) {
  // If this fails after a deliberate change: make_example_log scenarios/logs/example.log.gz
  EXPECT_TRUE(read_text_file(kShipped) == carmen_text(example_log()));
}

TEST(ExampleLog, HoldsAFewHundredScansWithTruth) {
  const RecordedLog log = load_log(kShipped);
  EXPECT_GT(log.true_poses.size(), 300u);
  EXPECT_EQ(log.measurements.size(), 2 * log.true_poses.size());
  EXPECT_TRUE(log.warnings.empty());
}

}  // namespace
}  // namespace mapbed
