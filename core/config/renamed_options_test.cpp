#include "core/config/renamed_options.h"

#include <gtest/gtest.h>

#include "core/config/config_node.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

constexpr RenamedOption kRows[] = {{"settling", "refinement"},
                                   {"settling.share", "refinement.fraction"},
                                   {"robot.front", "robot.sensors.front"}};

TEST(RenamedOptions, AGroupIsRenamedWhereverItStands) {
  EXPECT_EQ(new_path_of("settling", kRows), "refinement");
  EXPECT_EQ(new_path_of("settling.rounds", kRows), "refinement.rounds");
  EXPECT_EQ(new_path_of("rbpf.settling.rounds", kRows), "rbpf.refinement.rounds");
}

TEST(RenamedOptions, TheRowThatSaysMostHolds) {
  EXPECT_EQ(new_path_of("rbpf.settling.share", kRows), "rbpf.refinement.fraction");
}

TEST(RenamedOptions, PartsOfWordsAreOtherWords) {
  EXPECT_EQ(new_path_of("unsettling.rounds", kRows), std::nullopt);
  EXPECT_EQ(new_path_of("settlings", kRows), std::nullopt);
  EXPECT_EQ(new_path_of("front.noise", kRows), std::nullopt);
  EXPECT_EQ(new_path_of("", kRows), std::nullopt);
}

TEST(RenamedOptions, EveryRowOfTheTableGivesAnotherName) {
  for (const RenamedOption& row : renamed_options()) {
    EXPECT_EQ(new_path_of(row.old_path), row.new_path);
    EXPECT_NE(row.old_path, row.new_path);
  }
}

struct Refinement {
  int rounds = 1;
};

struct Filter {
  Refinement refinement;
};

template <class Visitor>
void visit_fields(Refinement& o, Visitor&& visit) {
  visit("rounds", o.rounds, "how often");
}

template <class Visitor>
void visit_fields(Filter& o, Visitor&& visit) {
  visit("refinement", o.refinement, "of the path");
}

TEST(RenamedOptions, AnOldNameIsRefusedWithTheNewOne) {
  Filter filter;
  const ConfigNode file = parse_config("\nsettling:\n  rounds: 3", {"scenarios/x.yaml", 1});
  EXPECT_INPUT_ERROR(apply(settings_of(file), options_of(filter), "rbpf"),
                     "scenarios/x.yaml:3: 'settling.rounds' is now 'refinement.rounds'");
  const ConfigNode other = parse_config("\nsettling:\n  rounds: 3", {"robots/x.yaml", 1});
  read_options(other, options_of(filter));
  EXPECT_INPUT_ERROR(other.check_all_used("robot"),
                     "robots/x.yaml:3: 'robot.settling' is now 'robot.refinement'");
}

TEST(FixedOptions, AreRefusedWithWhatToDo) {
  EXPECT_EQ(renaming_of("matcher.climb.first_step", "rbpf"),
            "'matcher.climb.first_step' is no option any more; try such values with the method "
            "scan_matching, where it is one");
}

}  // namespace
}  // namespace mapbed
