#include "bench/process/version.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(Version, NamesRevisionCompilerAndLibraries) {
  EXPECT_FALSE(version().revision.empty());
  EXPECT_THAT(version_text(), StartsWith("mapbed " + version().program + " (revision "));
  EXPECT_THAT(version_text(), HasSubstr("\n  Eigen3 3."));
  EXPECT_THAT(version_text(), Not(HasSubstr("@")));
}

TEST(Version, GivesALibraryANumberOrLeavesItOut) {
  EXPECT_THAT(version().libraries, Not(Contains(Field(&LibraryVersion::version, ""))));
  EXPECT_THAT(version().libraries, Not(Contains(Field(&LibraryVersion::name, "GTest"))));
}

}  // namespace
}  // namespace mapbed
