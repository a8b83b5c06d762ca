// `mapbed render` from the command line to the picture.

#include <filesystem>
#include <regex>

#include <gmock/gmock.h>

#include "algorithms/grid/map_file.h"
#include "algorithms/grid/map_image.h"
#include "algorithms/people/testing/people_in_a_room.h"
#include "bench/cli/testing/command_test.h"
#include "core/image/png.h"
#include "core/log/dialects/carmen_log.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

class RenderCommand : public CommandTest {
 protected:
  RenderCommand() {
    OccupancyMap map(GridFrame{.resolution = 0.1, .origin = {-2.0, 1.0}});
    for (int x = 0; x < 50; ++x) {
      for (int y = 0; y < 30; ++y) map.at({x, y}) = known(x == 0 ? 1.0 : 0.25 * (y % 2));
    }
    write_map(path("room"), map);
    write_png(path("room.png"), to_image(map));
    write("drive.txt", "0 -1 2 0\n1 2 3 0\n");
  }
};

TEST_F(RenderCommand, DrawsAWorldByItsNameAndByItsFile) {
  const Outcome by_name =
      call({"render", "corridor", "-o", "corridor.png", "--set", "length=12 m", "--set",
            "doors_a_side=2", "--camera", "width=64", "--camera", "height=48"});
  ASSERT_EQ(by_name.status, 0) << by_name.err;
  EXPECT_EQ(read_samples(path("corridor.png")).width, 64);
  write("lab.yaml", "shapes: [{name: crate, box: [1 m, 1 m, 1 m]}]\n");
  const Outcome by_file = call(
      {"render", "lab.yaml", "-o", "lab.png", "--camera", "width=32", "--camera", "height=32"});
  ASSERT_EQ(by_file.status, 0) << by_file.err;
  EXPECT_EQ(read_samples(path("lab.png")).height, 32);
}

TEST_F(RenderCommand, DrawsARobotOnItsWayThroughAWorld) {
  const std::vector<std::string> alone = {"render",   "corridor", "-o",       "alone.png",
                                          "--camera", "width=64", "--camera", "height=48"};
  std::vector<std::string> together = alone;
  together[3] = "together.png";
  together.insert(together.end(), {"--robot", "pioneer", "--after", "1 s"});
  ASSERT_EQ(call(alone).status, 0);
  const Outcome outcome = call(together);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(read_samples(path("alone.png")), read_samples(path("together.png")));
}

TEST_F(RenderCommand, DrawsSeveralMapsInOneFigureAsPngOrPdf) {
  const Outcome one = call({"render", "room.yaml", "-o", "one.png"});
  const Outcome two = call({"render", "room.yaml", "room.yaml", "-o", "two.png", "--name", "a"});
  ASSERT_EQ(two.status, 0) << two.err;
  EXPECT_GT(read_samples(path("two.png")).height, read_samples(path("one.png")).height + 200);
  const Outcome pdf = call({"render", "room.yaml", "room.yaml", "-o", "two.pdf"});
  ASSERT_EQ(pdf.status, 0) << pdf.err;
  EXPECT_EQ(text("two.pdf").substr(0, 5), "%PDF-");
  expect_refusal({"render", "room.yaml", "office", "-o", "x.png"}, "only maps are drawn together");
  expect_refusal({"render", "room.yaml", "room.yaml", "-o", "x.png", "--trajectory", "drive.txt"},
                 "--trajectory is drawn over one map");
}

TEST_F(RenderCommand, AFolderStandsForTheMapInItButForThoseCalledAsAWorld) {
  for (const char* folder : {"first", "second", "office"}) {
    fs::create_directory(path(folder));
    fs::copy_file(path("room.pgm"), path(std::string(folder) + "/map.pgm"));
    write(std::string(folder) + "/map.yaml",
          std::regex_replace(text("room.yaml"), std::regex("room"), "map"));
  }
  EXPECT_EQ(call({"render", "first", "-o", "a.png"}).status, 0);
  EXPECT_EQ(call({"render", "first/map.yaml", "-o", "b.png"}).status, 0);
  EXPECT_EQ(read_samples(path("a.png")), read_samples(path("b.png")));
  EXPECT_EQ(call({"render", "first", "second", "-o", "two.png"}).status, 0);
  EXPECT_EQ(call({"render", "room.yaml", "room.yaml", "-o", "same.png"}).status, 0);
  EXPECT_NE(read_samples(path("two.png")), read_samples(path("same.png"))) << "by their folders";
  EXPECT_EQ(call({"render", "office", "-o", "world.png"}).status, 0);
  EXPECT_NE(read_samples(path("world.png")), read_samples(path("a.png")));
  fs::create_directory(path("third"));
  expect_refusal({"render", "third", "-o", "x.png"},
                 "third: is a folder without a map.yaml, of which no picture is made; name a map "
                 "in it; a film of a run ends in .gif, .webp or .mp4");
}

TEST_F(RenderCommand, AFolderOfAMapShowsWhatMovedAndWhoWasFollowed) {
  RecordedLog log;
  std::vector<Eigen::Vector2d> positions(20, nowhere());
  walk(positions, {3.0, -2.5}, {3.0, 3.5});
  for (LaserScan scan : scans_of_somebody(positions)) {
    scan.time += 3.148e-7;  // [s] a log's stamps are finer than those of labels and path
    log.measurements.push_back(Odometry{.time = scan.time});
    log.measurements.push_back(scan);
  }
  write_carmen_log(path("walk.log"), log);
  ASSERT_EQ(call({"map", "walk.log", "--people-filter", "people", "-o", "walk"}).status, 0);
  const auto picture = [&](const std::string& name) {
    const Outcome outcome = call({"render", "walk", "-o", name});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_samples(path(name));
  };
  const Samples all = picture("all.png");
  fs::rename(path("walk/tracks.csv"), path("tracks.csv"));
  const Samples without_tracks = picture("without_tracks.png");
  EXPECT_NE(without_tracks, all);
  fs::rename(path("walk.log"), path("elsewhere.log"));
  const Samples without_log = picture("without_log.png");
  EXPECT_NE(without_log, without_tracks) << "where beams ended stands in the log";
  fs::remove(path("walk/labels.txt.gz"));
  EXPECT_EQ(picture("map_alone.png"), without_log);
  fs::rename(path("tracks.csv"), path("walk/tracks.csv"));
  write("walk/tracks.csv", "track,time\n");
  expect_refusal({"render", "walk", "-o", "x.png"}, "tracks.csv");
}

TEST_F(RenderCommand, SaysWhatIsWrongWithAWorld) {
  expect_refusal({"render", "offce", "-o", "x.png"}, "did you mean 'office'?");
  expect_refusal({"render", "office", "-o", "x.png", "--camera", "veiw=plan"}, "'view'");
  expect_refusal({"render", "office", "-o", "x.png", "--set", "sise=30 m"}, "'size'");
  expect_refusal({"render", "office", "-o", "x.png", "--robot", "b21r", "--path", "rign"},
                 "did you mean 'ring'?");
}

TEST_F(RenderCommand, DrawsWhatTagsReceiveOfAnAntenna) {
  const std::string world = "rfid_calibration";
  const auto drawn = [&](const std::string& antenna, const std::string& name) {
    const Outcome outcome = call({"render", world, "--antenna", antenna, "--size", "100",
                                  "--camera", "reach=3 m", "-o", name});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_samples(path(name));
  };
  const Samples ahead = drawn("8 m, 5 m, 0.6 m, 0 deg", "ahead.png");
  EXPECT_GT(ahead.width, 100);
  EXPECT_NE(ahead, drawn("8 m, 5 m, 0.6 m, 90 deg", "aside.png"));
  for (const auto& [antenna, message] : {std::pair("8 m, 5 m, 0.6 m", "write x, y, z, heading"),
                                         std::pair("8 m, 5, 0.6 m, 0 deg", "--antenna: "),
                                         std::pair("8 m, 5 m, 0.6 m, 1 m", "--antenna: ")}) {
    expect_refusal({"render", world, "--antenna", antenna, "-o", "x.png"}, message);
  }
  const std::string antenna = "8 m, 5 m, 0.6 m, 0 deg";
  expect_refusal({"render", world, "--antenna", antenna, "--sensor", "sick_lms200", "-o", "x.png"},
                 "sensor 'sick_lms200' is no RFID antenna");
  expect_refusal({"render", world, "--sensor", "alien_alr9780", "-o", "x.png"}, "--antenna");
  expect_refusal({"render", world, "--antenna", antenna, "--robot", "pioneer", "-o", "x.png"},
                 "leave out --robot");
}

TEST_F(RenderCommand, DrawsAMapWithItsTrajectory) {
  const Outcome plain = call({"render", "room.yaml", "-o", "plain.png"});
  ASSERT_EQ(plain.status, 0) << plain.err;
  const Outcome drawn = call({"render", "room.yaml", "--output", "drawn.png", "--trajectory",
                              "drive.txt", "--name", "by odometry"});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  const Samples a = read_samples(path("plain.png"));
  const Samples b = read_samples(path("drawn.png"));
  EXPECT_GE(a.width, 50 * 12);
  EXPECT_NE(a, b);
}

TEST_F(RenderCommand, ATrajectoryOfAnotherFrameIsRemarkedOn) {
  write("away.txt", "0 40 2 0\n1 41 3 0\n2 1 2 0\n");
  const auto draw = [&](const char* trajectory) {
    return call({"render", "room.yaml", "-o", "drawn.png", "--trajectory", trajectory});
  };
  EXPECT_THAT(draw("away.txt").err,
              ::testing::HasSubstr("remark: away.txt: 2 of 3 poses lie where the map knows "
                                   "nothing"));
  EXPECT_EQ(draw("drive.txt").err, "");
}

TEST_F(RenderCommand, APictureKeepsItsGreysAndTakesItsPlaceFromTheFileBesideIt) {
  const Outcome outcome = call({"render", "room.png", "-o", "a.png", "--trajectory", "drive.txt"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  fs::remove(path("room.yaml"));
  expect_refusal({"render", "room.png", "-o", "b.png"}, "give --resolution");
  EXPECT_EQ(call({"render", "room.png", "-o", "b.png", "--resolution", "10 cm"}).status, 0);
}

TEST_F(RenderCommand, ReplacesItsOwnPicturesAndNoOthers) {
  const std::string photo = text("room.png");
  expect_refusal({"render", "room.yaml", "-o", "room.png"}, "room.png: was not written by mapbed");
  EXPECT_EQ(text("room.png"), photo);
  write("notes.pdf", "of my own");
  expect_refusal({"render", "room.yaml", "--out", "notes.pdf"}, "notes.pdf: was not written");
  for (const char* once : {"at first", "again"}) {
    EXPECT_EQ(call({"render", "room.yaml", "-o", "own.png"}).status, 0) << once;
  }
  EXPECT_GT(read_samples(path("own.png")).width, 0);
}

TEST_F(RenderCommand, SaysWhatIsWrong) {
  write("text.png", "no picture");
  write("half.yaml", "image: room.pgm\n");
  expect_refusal({"render", "room.yaml"}, "--out is required");
  expect_refusal({"render", "absent.yaml", "-o", "x.png"}, "absent.yaml");
  expect_refusal({"render", "drive.txt", "-o", "x.png"},
                 "drive.txt: is neither a PNG nor a PGM picture");
  expect_refusal({"render", "text.png", "-o", "x.png", "--resolution", "1 m"}, "text.png");
  expect_refusal({"render", "half.yaml", "-o", "x.png"}, "half.yaml");
  expect_refusal({"render", "room.png", "-o", "x.png", "--resolution", "3 kg"},
                 "'3 kg' is not a length");
  expect_refusal({"render", "room.yaml", "-o", "x.png", "--trajectory", "absent.tum"},
                 "absent.tum");
  expect_refusal({"render", "room.yaml", "-o", "/dev/null/x.png"}, "/dev/null/x.png");
  expect_refusal({"render", "room.yaml", "-o", "x.png", "--size", "0"}, "--size");
}

}  // namespace
}  // namespace mapbed
