#include "bench/methods/command_text.h"

#include <gmock/gmock.h>

#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(CommandText, PutsValuesInPlace) {
  const Placeholders values{{"log", "/tmp/a b.log"}, {"seed", "7"}};
  EXPECT_EQ(filled("--in={log} -s{seed}", values), "--in=/tmp/a b.log -s7");
  EXPECT_EQ(filled("plain", values), "plain");
  EXPECT_EQ(filled("", values), "");
}

TEST(CommandText, FillsAValueOnce) {
  EXPECT_EQ(filled("{a}", {{"a", "{b}"}, {"b", "c"}}), "{b}");
}

TEST(CommandText, LeavesBracesAroundOtherThings) {
  const std::string awk = "awk '{print $1} {x=1;} {}' {Log} {";
  EXPECT_EQ(filled(awk, {}), awk);
  EXPECT_THAT(placeholders_in(awk), IsEmpty());
}

TEST(CommandText, TakesDoubledBracesAsTheTextsOwn) {
  EXPECT_EQ(filled("{{log}} {{", {{"log", "x"}}), "{log} {");
}

TEST(CommandText, KeepsAValueOneWordOfAShell) {
  EXPECT_EQ(filled_for_shell("cat {log}", {{"log", "a b'; rm -rf /; '"}}),
            "cat 'a b'\\''; rm -rf /; '\\'''");
}

TEST(CommandText, TellsWhichPlaceholderIsMeant) {
  EXPECT_THAT(placeholders_in("{log} {out}/{seed}"), ElementsAre("log", "out", "seed"));
  EXPECT_INPUT_ERROR(check_placeholders("{lgo}", {"log", "out"}, {"my.yaml", 3}),
                     "my.yaml:3: unknown placeholder '{lgo}'; did you mean 'log'?");
  check_placeholders("{log}", {"log"}, {});
}

}  // namespace
}  // namespace mapbed
