// Every file that the runs are made of decides whether earlier rows may be kept.

#include "bench/scenario/identity.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/scenario/run_scenario.h"
#include "bench/scenario/testing/own_files.h"
#include "bench/sources/files_record.h"
#include "core/data_path.h"
#include "core/file/hash.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class Identity : public OwnFiles {
 protected:
  // Adds what changes the bytes of a file and not what it says, and checks that this is noticed.
  void expect_noticed(const std::string& scenario, const std::string& file,
                      const std::string& addition) const {
    SCOPED_TRACE(file);
    const ScenarioPlan before = planned(scenario);
    const std::string config = write("config.yaml", before.results.config_yaml);
    EXPECT_EQ(changed_files(config, input_files(before)), std::vector<std::string>{});
    std::ofstream(path(file), std::ios::app) << addition;
    const ScenarioPlan after = planned(scenario);
    EXPECT_NE(identity_of(after), identity_of(before));
    EXPECT_THAT(changed_files(config, input_files(after)), ElementsAre(portable_path(path(file))));
  }
};

TEST_F(Identity, HoldsWorldMeshRobotSensorAndLearnedParameters) {
  const std::string x = scenario("room.yaml");
  for (const char* file :
       {"room.yaml", "meshes/tent.obj", "ours.yaml", "sensors/laser.yaml", "errors.yaml"}) {
    expect_noticed(x, file, "# edited\n");
  }
}

TEST_F(Identity, HoldsThePlanAndItsPicture) {
  const std::string x = scenario("planned.yaml");
  expect_noticed(x, "planned.yaml", "# edited\n");
  expect_noticed(x, "plan.yaml", "# edited\n");
  expect_noticed(x, "plan.pgm", "\n");
}

TEST_F(Identity, HoldsTheFilesThatExperimentsName) {
  expect_noticed(write("y.yaml",
                       "experiment: laser_readings\nsensor: sensors/laser.yaml\n"
                       "metrics: [chi_square_score]\n"),
                 "sensors/laser.yaml", "# edited\n");
  expect_noticed(write("y.yaml",
                       "experiment: motion_models\nworld: corridor\nrobot: pioneer\n"
                       "odometry_file: errors.yaml\nmetrics: [motions]\n"),
                 "errors.yaml", "# edited\n");
}

TEST_F(Identity, HoldsTheShippedFilesByNamesThatAreTheSameEverywhere) {
  const ScenarioPlan plan = planned(scenario("workshop", "driver.speed: 0.3 m/s\n"));
  EXPECT_THAT(plan.results.config_yaml, HasSubstr("  - {path: worlds/workshop.yaml, sha256: "));
  EXPECT_THAT(plan.results.config_yaml,
              HasSubstr("  - {path: " + portable_path(path("ours.yaml")) + ", sha"));
}

TEST_F(Identity, HoldsTheFilesOfEveryLevelAndVariant) {
  write("theirs.yaml", text("ours.yaml"));
  const std::string x =
      write("y.yaml",
            "world: room.yaml\nrecorder.longest: 1 s\nmetrics: [path_length]\n"
            "sweep: {robot: [ours.yaml, theirs.yaml]}\n"
            "compare: {a: {estimator: odometry}, b: {estimator: odometry, world: planned.yaml}}\n");
  expect_noticed(x, "theirs.yaml", "# edited\n");
  expect_noticed(x, "planned.yaml", "# edited\n");
}

TEST_F(Identity, HoldsTheOptionsOfEveryLevel) {
  const auto identity = [&](const std::string& range) {
    return identity_of(planned(write("y.yaml",
                                     "world: corridor\nrobot: ours.yaml\nmetrics: [path_length]\n"
                                     "sweep: {estimator: [odometry, scan_matching]}\n"
                                     "scan_matching.local_map.min_distance: " +
                                         range + "\n")));
  };
  EXPECT_NE(identity("10 cm"), identity("20 cm"));
  EXPECT_EQ(identity("10 cm"), identity("0.1 m"));
}

TEST_F(Identity, HoldsWhatIsSetInAWorldThatStartsFromAnotherOne) {
  const std::string x = scenario("started.yaml");
  const ScenarioPlan shorter = planned(x, {"world.length=14 m"});
  const ScenarioPlan longer = planned(x, {"world.length=16 m"});
  EXPECT_NE(identity_of(shorter), identity_of(longer));
  EXPECT_THAT(longer.results.config_yaml, HasSubstr("world.length: 16 m"));
}

TEST_F(Identity, WorldsThatStartFromAnotherOneDifferFromLevelToLevel) {
  const ScenarioPlan plan =
      planned(write("y.yaml",
                    "world: started.yaml\nrobot: ours.yaml\nmetrics: [path_length]\n"
                    "sweep: {world.length: [14 m, 16 m]}\nestimator: odometry\n"));
  const auto world_of = [&](std::size_t i) {
    return std::get<PreparedSimulation>(plan.planned.at(i).sources.front()->origin).world;
  };
  EXPECT_NEAR(path_by_name(*world_of(0), "one_way").points[1].position.x() + 2.0,
              path_by_name(*world_of(1), "one_way").points[1].position.x(), 1e-9);
}

TEST_F(Identity, AConfigurationThatCannotBeReadSaysNothingOfItsFiles) {
  const InputFiles files = input_files(planned(scenario("room.yaml")));
  for (const char* text : {"files: 3\n", "files: [{path: a}]\n", "a: [", "- b\n"}) {
    EXPECT_TRUE(changed_files(write("config.yaml", text), files).empty());
  }
}

TEST_F(Identity, HoldsTheContentOfALog) {
  write_log("drive.log");
  const std::string x = write("y.yaml", "log: drive.log\nmetrics: [path_length]\n");
  expect_noticed(x, "drive.log", "# edited\n");
}

// Described by a file of its own, with measured relations and poses that reach their stamps.
class DescribedLog : public Identity {
 protected:
  DescribedLog() {
    write_log("drive.log");
    describe();
    write("y.yaml", "log: drive.yaml\nmetrics: [relations_translation]\n");
  }
  void describe() const {
    const auto sha256 = [&](const char* name) { return sha256_of_file(path(name)); };
    write("drive.yaml",
          fmt::format("about: a\nfile: drive.log\nsha256: {}\nsource: s\nlicence: l\nfetch: f\n"
                      "robot: r\nlaser: x\nrelations: {{file: drive.relations, sha256: {},\n"
                      "  odometry: {{file: drive.tum, sha256: {}}}}}\n",
                      sha256("drive.log"), sha256("drive.relations"), sha256("drive.tum")));
  }
};

TEST_F(DescribedLog, AllItsFilesCount) {
  EXPECT_EQ(input_files(planned(path("y.yaml"))).size(), 4u);
  expect_noticed(path("y.yaml"), "drive.yaml", "# edited\n");
}

TEST_F(DescribedLog, AnEditIsNoticedBeforeARun) {
  for (const char* name : {"drive.log", "drive.relations", "drive.tum"}) {
    std::ofstream(path(name), std::ios::app) << "# edited\n";
    EXPECT_INPUT_ERROR(planned(path("y.yaml")),
                       std::string(name) + ": is not the file that drive.yaml describes");
    const ScenarioPlan edited = (describe(), planned(path("y.yaml")));
    EXPECT_NE(identity_of(edited), "");
  }
}

TEST_F(DescribedLog, AnEditThatIsDescribedGivesOtherRuns) {
  const ScenarioPlan before = planned(path("y.yaml"));
  std::ofstream(path("drive.log"), std::ios::app) << "# edited\n";
  describe();
  EXPECT_NE(identity_of(planned(path("y.yaml"))), identity_of(before));
}

TEST_F(DescribedLog, RelationsThatChangeAfterThePlanStopAllRuns) {
  const ScenarioPlan plan = planned(path("y.yaml"));
  std::ofstream(path("drive.relations"), std::ios::app) << "# edited\n";
  EXPECT_INPUT_ERROR(run(plan, "r"), "drive.relations: has changed since the runs were planned");
}

TEST_F(Identity, ALogThatChangesAfterThePlanStopsAllRuns) {
  write_log("drive.log");
  const ScenarioPlan plan =
      planned(write("y.yaml", "log: drive.log\nseeds: 3\nmetrics: [path_length]\n"));
  std::ofstream(path("drive.log"), std::ios::app) << "# edited\n";
  EXPECT_INPUT_ERROR(run(plan, "r"), "drive.log: has changed since the runs were planned");
  EXPECT_FALSE(std::filesystem::exists(path("r/runs.csv")));
}

TEST_F(Identity, UnfinishedRunsSayWhatTheyWereMadeOf) {
  const ScenarioPlan plan = planned(scenario("room.yaml"));
  std::filesystem::create_directory(path("r"));
  const ScenarioRunOptions options{.folder = path("r")};
  const auto stops_soon = [](std::size_t done, std::size_t) { return done < 1; };
  EXPECT_FALSE(run_scenario(plan, options, stops_soon).complete);
  std::ofstream(path("room.yaml"), std::ios::app) << "# edited\n";
  const ScenarioPlan edited = planned(path("x.yaml"));
  EXPECT_THAT(changed_files(path("r/runs/tables/config.yaml"), input_files(edited)),
              ElementsAre(portable_path(path("room.yaml"))));
  EXPECT_INPUT_ERROR(run_scenario(edited, options, stops_soon),
                     "these unfinished runs are of another configuration");
}

TEST_F(Identity, WordsPlotsAndClaimsAreNoPartOfIt) {
  const std::string before = identity_of(planned(scenario("room.yaml")));
  write("z.yaml", "base: x.yaml\nabout: in other words\nplots: []\nclaims: []\n");
  EXPECT_EQ(identity_of(planned(path("z.yaml"))), before);
  write("z.yaml", "base: x.yaml\nrecorder.longest: 2 s\n");
  EXPECT_NE(identity_of(planned(path("z.yaml"))), before);
}

// Paths count from the file that names them: the same scenario in two folders is two scenarios.
TEST_F(Identity, FilesAreFoundBesideTheFileThatNamesThem) {
  std::filesystem::create_directory(path("inner"));
  write("inner/room.yaml", text("planned.yaml"));
  write("inner/plan.yaml", text("plan.yaml"));
  write("inner/plan.pgm", text("plan.pgm"));
  write("inner/y.yaml",
        "base: ../base.yaml\nworld: room.yaml\nmetrics: [path_length]\nestimator: odometry\n");
  write("base.yaml", "robot: ours.yaml\n");
  std::vector<std::string> names;
  for (const InputFile& file : input_files(planned(path("inner/y.yaml")))) {
    names.push_back(file.path);
  }
  EXPECT_THAT(names, Contains(path("inner/room.yaml")));
  EXPECT_THAT(names, Contains(path("inner/plan.pgm")));
  EXPECT_THAT(names, Contains(path("ours.yaml")));
  EXPECT_THAT(names, Not(Contains(path("room.yaml"))));
}

}  // namespace
}  // namespace mapbed
