// `mapbed list` and `mapbed describe`: names, options and every kind of file that is read.

#include <filesystem>

#include <gmock/gmock.h>

#include "bench/cli/testing/command_test.h"
#include "core/testing/source_tree.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

class Describe : public CommandTest {
 protected:
  std::string described(const std::string& name) const {
    const Outcome outcome = call({"describe", name});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  }
};

TEST_F(Describe, WordsThatFilesUseAreListedAndDescribed) {
  EXPECT_THAT(call({"list", "materials"}).out, AllOf(HasSubstr("glass "), HasSubstr("plaster ")));
  EXPECT_THAT(call({"list", "metrics"}).out, HasSubstr("translation_error "));
  EXPECT_THAT(call({"list", "plots"}).out, HasSubstr("heat_map "));
  EXPECT_THAT(described("glass"),
              AllOf(HasSubstr("glass (material)"), HasSubstr("transmittance: 0.7")));
  EXPECT_THAT(described("failures"), AllOf(HasSubstr("(metric)"), HasSubstr("experiment slam")));
  EXPECT_THAT(described("matrix"), HasSubstr("kind: matrix"));
  for (const char* drive : {"differential", "omni", "ackermann", "synchro", "skid_steer"}) {
    EXPECT_THAT(described(drive), AllOf(HasSubstr(std::string(drive) + " (drive)"),
                                        HasSubstr("  kind: " + std::string(drive) + "  # ")));
  }
  EXPECT_THAT(described("laser"), AllOf(HasSubstr("(kind of sensors)"), HasSubstr("max_range: ")));
  EXPECT_THAT(described("end_points_odds"), HasSubstr("map.model=end_points_odds"));
  EXPECT_THAT(described("at_most"), HasSubstr("(word of claims)"));
}

TEST_F(Describe, OptionsTellWhatMayStandThere) {
  EXPECT_THAT(described("map"), HasSubstr("; one of counting, odds, "));
  EXPECT_THAT(described("map"), HasSubstr("side of a cell; from 0.005 m to 10 m\n"));
  EXPECT_THAT(described("usable_range"), HasSubstr("setting map: beams.usable_range: "));
}

TEST_F(Describe, AWorldTellsItsPathsAndDoors) {
  EXPECT_THAT(described("office"),
              AllOf(HasSubstr("paths:\n  - ring: "), HasSubstr("  - long_tour: "),
                    HasSubstr("  - room "), HasSubstr("options:\n")));
  EXPECT_THAT(described("workshop"), HasSubstr("  - round: 20.0 m by 5 points from (1.5, 1.5)"));
  EXPECT_THAT(described("world_file"),
              HasSubstr("the distance from the wall's start (from) to the opening's middle"));
}

TEST_F(Describe, TheFormOfAWorldFileIsAWorldFile) {
  const std::string form = described("world_file");
  write("lab.yaml", form.substr(form.find('\n') + 1));
  EXPECT_THAT(described("lab.yaml"),
              AllOf(HasSubstr("lab.yaml (world)"), HasSubstr("  - across: 6.0 m")));
}

TEST_F(Describe, ATrajectoryTellsItsLengthAndBox) {
  write("a.tum", "0 0 0 0 0 0 0 1\n1 3 0 0 0 0 0 1\n2 3 4 0 0 0 0 1\n");
  EXPECT_THAT(described("a.tum"),
              AllOf(HasSubstr("(trajectory)\nposes: 3 in 2.0 s"), HasSubstr("path length: 7.00 m"),
                    HasSubstr("3.00 m x 4.00 m")));
  write("b.relations", "0 1 3 4 0 0 0 0.1\n1 5 1 0 0 0 0 0\n");
  EXPECT_THAT(described("b.relations"),
              AllOf(HasSubstr("(relations)\nrelations: 2 between stamps from 0.000000 to 5.000000"),
                    HasSubstr("longest: 5.00 m")));
}

TEST_F(Describe, TracksTellHowLongPeopleWereFollowedAndLabelsHowMuchIsDynamic) {
  // Number 1 for 2 s, hidden in one of three scans; number 2 begins 0.5 s later 1 m away, number 3
  // elsewhere.
  write("tracks.csv",
        "track,time,x,y,vx,vy,sxx,sxy,syy,occluded\n"
        "1,0,0,0,0,0,0.01,0,0.01,0\n1,1,1,0,0,0,0.01,0,0.01,1\n1,2,2,0,0,0,0.01,0,0.01,0\n"
        "2,2.5,3,0,0,0,0.01,0,0.01,0\n2,6.5,3,4,0,0,0.01,0,0.01,0\n"
        "3,2.5,9,0,0,0,0.01,0,0.01,0\n");
  EXPECT_THAT(
      described("tracks.csv"),
      AllOf(HasSubstr("(tracks)\ntracks: 3, in 2 scans each"),
            HasSubstr("length: 2.0 s in the median, 4.0 s the longest; 6.0 m of way in all"),
            HasSubstr("not seen: in 16.7 % of these"), HasSubstr("lost and found: 1 end where")));
  write("labels.txt", "# MAPBED LABELS 1\n0.5 0 4 99 - 10 100\n0.6 0 1 50\n");
  EXPECT_THAT(described("labels.txt"),
              AllOf(HasSubstr("(labels of beams)\nscans: 2\nbeams: 5, 4 of them with a label"),
                    HasSubstr("dynamic: 1, 25.00 %")));
}

TEST_F(Describe, AMapTellsItsSizeAndHowMuchIsKnown) {
  write("m.pgm", std::string("P5\n4 2\n255\n") + std::string("\xFE\xFE\xCD\xCD", 4) +
                     std::string("\x00\x00\xCD\xCD", 4));
  write("m.yaml",
        "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
        "free_thresh: 0.196\n");
  for (const char* name : {"m.yaml", "m.pgm"}) {
    EXPECT_THAT(described(name),
                AllOf(HasSubstr("(map)"), HasSubstr("4 x 2 cells of 0.5 m, 2.0 m x 1.0 m"),
                      HasSubstr("known: 50.0 % of the cells; 25.0 % occupied, 25.0 % free")));
  }
}

TEST_F(Describe, WhatOurCommandsWriteIsKnown) {
  ASSERT_EQ(call({"simulate", "--world", "corridor", "--robot", "pioneer", "--people", "0", "--set",
                  "recorder.longest=10 s", "-o", "a.log"})
                .status,
            0);
  EXPECT_THAT(described("a.log"), AllOf(HasSubstr("(log)"), HasSubstr("format: CARMEN")));
  EXPECT_THAT(described("a.truth.gz"),
              AllOf(HasSubstr("(truth)\nworld: corridor\nrobot: pioneer\n")));
  EXPECT_THAT(described("a.tum"), HasSubstr("(trajectory)"));
  EXPECT_THAT(described("a_map.yaml"), HasSubstr("(map)"));
  EXPECT_THAT(described("a.config.yaml"), HasSubstr("(scenario)"));
  ASSERT_EQ(call({"map", "a.log", "--method", "odometry", "-o", "m"}).status, 0);
  EXPECT_THAT(described("m"), AllOf(HasSubstr("(map of a log)"), HasSubstr("method: odometry")));
  EXPECT_THAT(described("m/config.yaml"), HasSubstr("method: odometry"));
  EXPECT_THAT(described("m/map.png"), HasSubstr("(map)"));
  write("s.yaml",
        "about: a short drive\nlog: a.log\ncompare: {raw: {estimator: odometry}}\nseeds: 1\n"
        "metrics: [path_length]\n");
  EXPECT_THAT(described("s.yaml"),
              AllOf(HasSubstr("(scenario)\nabout: a short drive"), HasSubstr("runs: 1 at most")));
  ASSERT_EQ(call({"run", "./s.yaml", "-o", "r"}).status, 0);
  for (const char* name : {"r", "r/config.yaml"}) {
    EXPECT_THAT(described(name),
                AllOf(HasSubstr("(results)\nscenario: s\n"), HasSubstr("runs: 1, 0 of them failed"),
                      HasSubstr("made by: mapbed ")));
  }
  EXPECT_THAT(described("r/runs.csv"),
              AllOf(HasSubstr("(table)\nrows: 1\n"), HasSubstr("  - seed\n")));
}

TEST_F(Describe, YamlFilesOfTheShelvesAreKnownByTheirPaths) {
  const auto of = [&](const char* file) { return described(source_tree() + "/" + file); };
  EXPECT_THAT(of("robots/pioneer.yaml"), HasSubstr("(robot)"));
  EXPECT_THAT(of("robots/sensors/sick_lms200.yaml"), HasSubstr("(sensor)"));
  EXPECT_THAT(of("worlds/workshop.yaml"), HasSubstr("(world)"));
  EXPECT_THAT(of("scenarios/ch2_raw_odometry.yaml"), HasSubstr("(scenario)"));
}

TEST_F(Describe, WhatIsNoneOfTheseIsToldWhatIsRead) {
  write("notes.txt", "once upon a time\n");
  write("odd.yaml", "shopping: [milk]\n");
  fs::create_directory(path("empty"));
  for (const char* name : {"notes.txt", "odd.yaml", "empty"}) {
    expect_refusal({"describe", name}, "read are: logs (CARMEN, ");
    expect_refusal({"describe", name}, name);
  }
  expect_refusal({"describe", "pioner"}, "did you mean 'pioneer'?");
  expect_refusal({"describe", "no/such.file"}, "'mapbed list' shows all names");
  expect_refusal({"list", "metals"}, "there are no 'metals' to list");
}

}  // namespace
}  // namespace mapbed
