// `mapbed render RUN --figure NAME` from the command line to the picture.

#include <filesystem>

#include <gmock/gmock.h>

#include "bench/cli/testing/command_test.h"
#include "core/image/samples.h"
#include "core/log/dialects/carmen_log.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

class RenderFigure : public CommandTest {
 protected:
  RenderFigure() {
    write("drives.yaml",
          "world: office\nrobot: pioneer\npeople: 2\nrecorder.longest: 2 s\n"
          "compare:\n  raw: {estimator: odometry}\n"
          "  filter: {estimator: odometry, people_filter: people}\n"
          "seeds: 2\nmetrics: [largest_error]\n");
  }
  Outcome figure(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"-o", "figure.png", "--size", "300"});
    return call(arguments);
  }
  int width() const { return read_samples(path("figure.png")).width; }
};

TEST_F(RenderFigure, OfPeopleInAScenariosRun) {
  for (const char* name : {"scan", "difference", "tracking", "weights"}) {
    const Outcome outcome = figure({"./drives.yaml", "--run", "1", "--figure", name, "--at",
                                    "1.5 s", "--set", "tracker.particles=20"});
    ASSERT_EQ(outcome.status, 0) << name << outcome.err;
    EXPECT_GT(width(), 300);
  }
}

TEST_F(RenderFigure, OfTheMapsOfAllVariantsOrOfSome) {
  ASSERT_EQ(figure({"./drives.yaml", "--figure", "maps", "--variant", "raw"}).status, 0);
  const int of_one = width();
  const Outcome both = figure({"./drives.yaml", "--figure", "maps", "--run", "3"});
  ASSERT_EQ(both.status, 0) << both.err;
  EXPECT_GE(width(), of_one);
  EXPECT_THAT(both.out, HasSubstr("figure.png"));
  const Samples maps = read_samples(path("figure.png"));
  ASSERT_EQ(figure({"./drives.yaml", "--figure", "labels", "--run", "2"}).status, 0);
  EXPECT_GE(read_samples(path("figure.png")).height, maps.height);
}

TEST_F(RenderFigure, OfPeopleInTheLogOfAMap) {
  write_carmen_log(path("room.log"), drive_through(rectangular_room(6.0, 4.0),
                                                   {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1)));
  ASSERT_EQ(call({"map", "room.log", "-o", "m"}).status, 0);
  const Outcome outcome = figure({"m", "--figure", "scan"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expect_refused(figure({"m", "--figure", "maps"}), "m: holds one map, and no variants");
}

TEST_F(RenderFigure, SaysWhatIsWrong) {
  const auto expect = [this](const std::vector<std::string>& arguments,
                             const std::string& message) {
    expect_refused(figure(arguments), message);
    EXPECT_FALSE(fs::exists(path("figure.png")));
  };
  expect({"./drives.yaml", "--figure", "scam"}, "unknown figure 'scam'");
  expect({"./drives.yaml", "--figure", "maps", "--variant", "fitter"}, "did you mean 'filter'");
  expect({"./drives.yaml", "--figure", "scan", "--at", "50 s"},
         "--at 50 s is behind the last scan");
  expect({"./drives.yaml", "--figure", "scan", "--at", "-1 s"}, "--at: must not be negative");
  expect({"./drives.yaml", "--figure", "scan", "--set", "legs=3"}, "legs");
  expect({"./drives.yaml", "--figure", "scan", "--variant", "raw"}, "--variant");
  expect({"./drives.yaml", "--figure", "maps", "--at", "1 s"}, "--at");
  expect({"./drives.yaml", "--figure", "scan", "--camera", "view=plan"}, "--camera says nothing");
  expect({"office", "--at", "1 s"}, "--at is of a figure");
  expect({"./drives.yaml", "./drives.yaml", "--figure", "scan"}, "a figure is of one run");
}

}  // namespace
}  // namespace mapbed
