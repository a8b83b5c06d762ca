#include "sim/truth/truth_file.h"

#include <limits>

#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"
#include "sim/truth/columns.h"

namespace mapbed {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

// Two lasers, somebody of two parts who walks and a door, at more moments than a block holds.
Truth some_truth(int moments = 600) {
  Truth truth;
  truth.world = "small room";
  truth.robot = "b21r";
  truth.materials = {"plaster", "safety glass"};
  truth.entities = {{0, "north wall", EntityKind::structure, {"block"}},
                    {1, "door", EntityKind::door, {"leaf"}},
                    {2, "person 1", EntityKind::person, {"left leg", "right leg"}},
                    {3, "b21r", EntityKind::robot, {}}};
  for (int i = 0; i < moments; ++i) {
    const double t = 0.2 * i;
    const Pose3 leg{{1.0 + t, -2.0, 0.425}, rotation_of(0.3 * t, 0.1, -0.2)};
    truth.states.push_back(
        {12.25 + t,
         {0.1 * t, -2.25, normalized_angle(0.01 * t)},
         {{1, 0, upright({3.0, 4.0, 0.0}, 1.0), i < 5 ? Motion::moving : Motion::waiting},
          {2, 0, leg, Motion::moving},
          {2, 1, leg * upright({0.0, -0.2, 0.0}), Motion::moving}}});
    const auto range = static_cast<float>(1.25 + 0.001 * i);
    truth.beams.push_back({12.25 + t,
                           0,
                           {{range, 0, 0, 1, Motion::still},
                            {0.5F, 2, 1, 0, Motion::moving},
                            {kNothing, -1, -1, -1, Motion::still}}});
    if (i % 2 == 0)
      truth.beams.push_back({12.25 + t, 1, {{80.0F - range, 1, 0, 0, Motion::waiting}}});
  }
  return truth;
}

class TruthFile : public ::testing::Test {
 protected:
  std::string path() const { return folder_.file("a.truth.gz"); }
  // Writes some bytes in place of a truth file.
  std::string damaged(const std::string& bytes) const {
    write_file(folder_.file("damaged"), bytes);
    return folder_.file("damaged");
  }
  std::string bytes_of(const Truth& truth) const {
    write_truth(path(), truth);
    return read_text_file(path());
  }

  TemporaryFolder folder_;
};

TEST_F(TruthFile, ComesBackAsItWasWritten) {
  const Truth truth = some_truth();
  write_truth(path(), truth);
  const Truth back = load_truth(path());
  EXPECT_EQ(back.world, "small room");
  EXPECT_EQ(back.robot, "b21r");
  EXPECT_EQ(back.materials, truth.materials);
  ASSERT_EQ(back.entities.size(), truth.entities.size());
  EXPECT_EQ(back.entities[2].name, "person 1");
  EXPECT_EQ(back.entities[2].parts, truth.entities[2].parts);
  EXPECT_TRUE(back.entities[2].is_dynamic());
  EXPECT_FALSE(back.entities[0].is_dynamic());

  ASSERT_EQ(back.states.size(), truth.states.size());
  for (std::size_t i = 0; i < truth.states.size(); ++i) {
    ASSERT_EQ(back.states[i].time, truth.states[i].time);
    ASSERT_EQ(back.states[i].world_from_robot, truth.states[i].world_from_robot);
    ASSERT_EQ(back.states[i].moving.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      const MovingPose& a = truth.states[i].moving[k];
      const MovingPose& b = back.states[i].moving[k];
      ASSERT_EQ(std::tuple(b.entity, b.part, b.motion), std::tuple(a.entity, a.part, a.motion));
      // Half a step of 0.1 mm on each of three coordinates.
      ASSERT_LE((a.world_from_part.position - b.world_from_part.position).norm(), 0.9e-4);
      // Half a step of 1e-5 on each of four coordinates, and a rotation is twice its quaternion's.
      ASSERT_LE(angle_between(a.world_from_part, b.world_from_part), 2e-5);
    }
  }
  ASSERT_EQ(back.beams.size(), truth.beams.size());
  for (std::size_t i = 0; i < truth.beams.size(); ++i) {
    ASSERT_EQ(back.beams[i].time, truth.beams[i].time);
    ASSERT_EQ(back.beams[i].laser, truth.beams[i].laser);
    ASSERT_EQ(back.beams[i].beams.size(), truth.beams[i].beams.size());
    for (std::size_t k = 0; k < truth.beams[i].beams.size(); ++k) {
      const BeamTruth& a = truth.beams[i].beams[k];
      const BeamTruth& b = back.beams[i].beams[k];
      ASSERT_EQ(std::tuple(b.entity, b.part, b.material, b.motion),
                std::tuple(a.entity, a.part, a.material, a.motion));
      if (a.range == kNothing) {
        ASSERT_EQ(b.range, kNothing);
      } else {
        ASSERT_NEAR(b.range, a.range, 1e-6 + 4e-6);  // a step, and a float's own at 80 m
      }
    }
  }
}

TEST_F(TruthFile, WithoutAnythingThatMovesComesBackToo) {
  Truth truth;
  truth.world = "empty";
  truth.states = {{1.0, {}, {}}};
  truth.beams = {{1.0, 0, {}}};
  write_truth(path(), truth);
  const Truth back = load_truth(path());
  EXPECT_EQ(back.states.size(), 1u);
  EXPECT_TRUE(back.states[0].moving.empty());
  EXPECT_EQ(back.beams.size(), 1u);
}

TEST_F(TruthFile, IsReadAsAStream) {
  write_truth(path(), some_truth());
  int states = 0;
  int beams = 0;
  double last = 0.0;
  read_truth(path(), {.states =
                          [&](StampedStates&& s) {
                            EXPECT_GT(s.time, last);
                            last = s.time;
                            ++states;
                          },
                      .beams = [&](BeamTruthOfScan&&) { ++beams; }});
  EXPECT_EQ(states, 600);
  EXPECT_EQ(beams, 900);
}

TEST_F(TruthFile, TagsAndTheirReadsComeBackToo) {
  Truth truth = some_truth(2);
  truth.tags = {{"tag_1", {{1.5, -2.25, 1.1}, rotation_of(0.3, 0.1, -0.2)}, 1},
                {"tag_2", {{0.1, 0.2, 0.3}, rotation_of(0.0, 0.0, 0.0)}, -1}};
  for (int i = 0; i < 40'000; ++i) {  // more than a block holds
    truth.reads.push_back({12.25 + 0.125 * i, i % 3, i % 2, static_cast<ReadMechanism>(i % 4)});
  }
  write_truth(path(), truth);
  const Truth back = load_truth(path());
  ASSERT_EQ(back.tags.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.tags[i].id, truth.tags[i].id);
    EXPECT_EQ(back.tags[i].world_from_tag, truth.tags[i].world_from_tag);
    EXPECT_EQ(back.tags[i].material, truth.tags[i].material);
  }
  ASSERT_EQ(back.reads.size(), truth.reads.size());
  for (std::size_t i = 0; i < back.reads.size(); ++i) {
    const TruthRead& a = back.reads[i];
    const TruthRead& b = truth.reads[i];
    ASSERT_EQ(std::tuple(a.time, a.antenna, a.tag, a.mechanism),
              std::tuple(b.time, b.antenna, b.tag, b.mechanism));
  }
}

TEST_F(TruthFile, ATagThatIsNowhereAndAReadOfNoTagAreRefused) {
  Truth truth = some_truth(2);
  truth.tags = {{"tag_1", {}, -1}};
  truth.reads = {{1.0, 0, 1, ReadMechanism::direct}};
  EXPECT_INPUT_ERROR(load_truth(damaged(bytes_of(truth))), "(READ) is damaged");
  truth.reads.clear();
  for (const char* line : {"TAG tag_1 1 2 3", "TAG tag_1 1 2 x 0 0 0 1 -1",
                           "TAG tag_1 1 2 3 0 0 0 2 0", "TAG tag_1 1 2 3 0 0 0 1 7"}) {
    std::string bytes = bytes_of(truth);
    bytes.insert(bytes.find("BLOCKS\n"), std::string(line) + "\n");
    EXPECT_INPUT_ERROR(load_truth(damaged(bytes)), "a tag's line that does not say where it is");
  }
}

TEST_F(TruthFile, BlocksOfUnknownKindsArePassedOver) {
  std::string bytes = bytes_of(some_truth(2));
  std::string block = "WIND";
  append_number(block, 5);
  bytes.insert(bytes.find("BLOCKS\n") + 7, block + "12345");
  EXPECT_EQ(load_truth(damaged(bytes)).states.size(), 2u);
}

TEST_F(TruthFile, IsRefusedWhereverItIsCutShort) {
  const std::string bytes = bytes_of(some_truth(3));
  const std::size_t blocks = bytes.find("BLOCKS\n") + 7;
  const std::size_t first_line = bytes.find('\n');
  for (std::size_t size = 1; size < bytes.size(); size += 7) {
    const char* expected = size < first_line ? "truth file"
                           : size < blocks   ? "the file ends before its blocks"
                                             : "is cut short";
    EXPECT_INPUT_ERROR(load_truth(damaged(bytes.substr(0, size))), expected);
  }
}

TEST_F(TruthFile, NumbersThatMeanNothingAreRefusedWithBlockAndByte) {
  const Truth truth = some_truth(2);
  const std::size_t first = bytes_of(truth).find("BLOCKS\n") + 7;
  Truth wrong = truth;
  wrong.states[1].moving[0].entity = wrong.states[0].moving[0].entity = 9;
  EXPECT_INPUT_ERROR(load_truth(damaged(bytes_of(wrong))),
                     "block 1 at byte " + std::to_string(first) + " (STAT) is damaged");
  wrong = truth;
  wrong.states[1].time = 1.0;  // before the first one
  EXPECT_INPUT_ERROR(load_truth(damaged(bytes_of(wrong))), "(STAT) is damaged");
  wrong = truth;
  wrong.beams[0].beams[0].part = 1;
  EXPECT_INPUT_ERROR(load_truth(damaged(bytes_of(wrong))), "(BEAM) is damaged");
  wrong = truth;
  wrong.beams[0].beams[0].material = 2;
  EXPECT_INPUT_ERROR(load_truth(damaged(bytes_of(wrong))), "(BEAM) is damaged");
}

TEST_F(TruthFile, CountsThatTheBlockCannotHoldAreRefused) {
  std::string bytes = bytes_of(some_truth(2));
  const std::size_t first = bytes.find("BLOCKS\n") + 7;
  for (const std::size_t at : {first + 8, first + 12}) {  // n and m
    std::string wrong = bytes;
    wrong.replace(at, 4, "\xff\xff\xff\xff");
    EXPECT_INPUT_ERROR(load_truth(damaged(wrong)), "(STAT) is damaged");
  }
  std::string wrong = bytes;
  wrong.replace(first + 4, 4, "\xff\xff\xff\xff");  // length
  EXPECT_INPUT_ERROR(load_truth(damaged(wrong)), "is too long");
  EXPECT_INPUT_ERROR(load_truth(damaged(bytes + "x")), "is followed by more");
}

TEST_F(TruthFile, IsRefusedWhereItTakesMoreMemoryThanWasAllowed) {
  const char* message = "GB of memory; is it a truth file of a drive?";
  Truth truth = some_truth(100);
  truth.beams.clear();
  write_truth(path(), truth);
  const std::size_t poses = 100 * 3 * sizeof(MovingPose);
  EXPECT_EQ(load_truth(path(), 10 * poses).states.size(), 100u);
  EXPECT_INPUT_ERROR(load_truth(path(), poses), message);

  truth.states.clear();
  truth.beams = {{.beams = std::vector<BeamTruth>(500, BeamTruth{.range = kNothing})}};
  write_truth(path(), truth);
  EXPECT_EQ(load_truth(path(), 10 * 500 * sizeof(BeamTruth)).beams.size(), 1u);
  EXPECT_INPUT_ERROR(load_truth(path(), 500 * sizeof(BeamTruth)), message);
}

TEST_F(TruthFile, OtherFilesAndOtherVersionsAreRefused) {
  EXPECT_INPUT_ERROR(load_truth(damaged("FLASER 3 1 2 3\n")), ":1: not a truth file");
  EXPECT_INPUT_ERROR(load_truth(damaged("")), ":1: the file ends before its blocks");
  EXPECT_INPUT_ERROR(load_truth(damaged("\n\n")), ":1: not a truth file");
  EXPECT_INPUT_ERROR(load_truth(damaged("TRUTH 1\nWORLD museum\n")),
                     ":1: a truth file of an older version, which was all text; record it again");
  EXPECT_INPUT_ERROR(load_truth(damaged("MAPBED TRUTH 3\n")),
                     ":1: a truth file of another version");
  EXPECT_INPUT_ERROR(load_truth(damaged("MAPBED TRUTH 2\nENTITY 0 ghost x\n")),
                     ":2: unknown kind 'ghost' of an entity");
  EXPECT_INPUT_ERROR(load_truth(damaged("MAPBED TRUTH 2\nMATERIAL 1 x\n")),
                     ":2: '1' stands where 0 comes next");
  EXPECT_INPUT_ERROR(load_truth(damaged("MAPBED TRUTH 2\nPART 0 0 x\n")),
                     ":2: a part before any entity");
  EXPECT_INPUT_ERROR(load_truth(damaged("MAPBED TRUTH 2\nSCAN 1\n")), ":2: unknown line 'SCAN'");
}

}  // namespace
}  // namespace mapbed
