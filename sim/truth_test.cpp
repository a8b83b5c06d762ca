#include "sim/truth.h"

#include <limits>

#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

Truth small_truth() {
  Truth truth;
  truth.world = "small room";
  truth.robot = "b21r";
  truth.materials = {"plaster", "safety glass"};
  truth.entities = {{0, "north wall", EntityKind::structure, {"block"}},
                    {1, "person 1", EntityKind::person, {"left leg", "right leg"}}};
  TruthScan& scan = truth.scans.emplace_back();
  scan.time = 12.25;
  scan.world_from_robot = {1.5, -2.25, 0.5};
  scan.tracked = {{1, {3.0, 4.0, -1.0}, true}};
  scan.beams = {{1.25F, 0, 0, 1, false},
                {0.5F, 1, 1, 0, true},
                {std::numeric_limits<float>::infinity(), -1, -1, -1, false}};
  return truth;
}

TEST(Truth, ComesBackAsItWasWritten) {
  const std::string text = truth_text(small_truth());
  const Truth back = parse_truth("test", text);
  EXPECT_EQ(truth_text(back), text);
  ASSERT_EQ(back.scans.size(), 1u);
  EXPECT_EQ(back.scans[0].time, 12.25);
  EXPECT_EQ(back.scans[0].world_from_robot, (Pose2{1.5, -2.25, 0.5}));
  EXPECT_EQ(back.entities[1].name, "person 1");
  EXPECT_EQ(back.entities[1].parts[1], "right leg");
  EXPECT_TRUE(back.entities[1].is_dynamic());
  EXPECT_FALSE(back.entities[0].is_dynamic());
  EXPECT_TRUE(back.scans[0].tracked[0].is_moving);
  EXPECT_EQ(back.scans[0].beams[1].part, 1);
}

TEST(Truth, DamagedFilesAreRefusedByLine) {
  EXPECT_INPUT_ERROR(parse_truth("t", "FLASER 3 1 2 3\n"), "t:1: not a truth file");
  EXPECT_INPUT_ERROR(parse_truth("t", ""), "not a truth file");
  EXPECT_INPUT_ERROR(parse_truth("t", "TRUTH 2\n"), "t:1: of another version");
  EXPECT_INPUT_ERROR(parse_truth("t", "TRUTH 1\nAT 1 0 0 0 0\n"), "t:2: no SCAN line before");
  EXPECT_INPUT_ERROR(parse_truth("t", "TRUTH 1\nSCAN 1 0 x 0 0\n"), "t:2: 'x' is no number");
  EXPECT_INPUT_ERROR(parse_truth("t", "TRUTH 1\nSCAN 1 0 0 0 0\nBEAMS 2 1.5,0,0,0,0\n"),
                     "t:3: the line was cut short");
  EXPECT_INPUT_ERROR(parse_truth("t", "TRUTH 1\nENTITY 0 ghost x\n"), "unknown kind 'ghost'");
}

}  // namespace
}  // namespace mapbed
