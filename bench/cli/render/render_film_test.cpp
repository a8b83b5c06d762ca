// `mapbed render` from the command line to the film of a run.

#include <filesystem>

#include <gmock/gmock.h>

#include "bench/cli/testing/command_test.h"
#include "core/log/dialects/carmen_log.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace fs = std::filesystem;

class RenderFilm : public CommandTest {
 protected:
  RenderFilm() {
    write("drives.yaml",
          "world: office\nrobot: pioneer\npeople: 2\nrecorder.longest: 2 s\n"
          "compare: {raw: {estimator: odometry}, filter: {estimator: rbpf, rbpf.particles: 3}}\n"
          "seeds: 2\nmetrics: [largest_error]\n");
  }
  Outcome film(std::vector<std::string> arguments, const std::string& output = "film.gif") const {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"-o", output, "--size", "100", "--fps", "5"});
    return call(arguments);
  }
  void expect_no_film(const std::vector<std::string>& arguments, const std::string& message,
                      const std::string& output = "film.gif") const {
    expect_refused(film(arguments, output), message);
    EXPECT_FALSE(fs::exists(path(output)));
  }
  void make_map() const {
    write_carmen_log(path("room.log"), drive_through(rectangular_room(6.0, 4.0),
                                                     {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1)));
    ASSERT_EQ(call({"map", "room.log", "-o", "m"}).status, 0);
  }
};

TEST_F(RenderFilm, OfAScenariosRunByItsNumber) {
  const Outcome outcome = film({"./drives.yaml", "--run", "3"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("film.gif: run 3 of drives, 100 x "));
  EXPECT_THAT(text("film.gif"), StartsWith("GIF89a"));
}

TEST_F(RenderFilm, OfTheFolderOfASingleRun) {
  ASSERT_EQ(call({"run", "./drives.yaml", "--run", "2", "--out", "one"}).status, 0);
  const Outcome outcome = film({"one"}, "film.webp");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("run 2 of drives"));
  EXPECT_THAT(text("film.webp"), StartsWith("RIFF"));
}

TEST_F(RenderFilm, OfAMap) {
  make_map();
  const Outcome outcome = film({"m", "--from", "1 s", "--to", "2 s", "--speed", "0.5"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  // Two seconds of film and their beginning, and two seconds of rest, at 5 frames a second.
  EXPECT_THAT(outcome.out, HasSubstr("scan_matching on room.log, "));
  EXPECT_THAT(outcome.out, HasSubstr("21 frames, 4.2 s, 0.5 times real time"));
}

// What em finds comes at its end, and the film's legend says so: the first one has that.
TEST_F(RenderFilm, OfAWholeRunEndsWithWhatCameOfIt) {
  write("em.yaml",
        "world: office\nrobot: pioneer\npeople: 2\nrecorder.longest: 2 s\n"
        "compare: {em: {estimator: em, em.iterations: 1}}\nseeds: 1\nmetrics: [largest_error]\n");
  ASSERT_EQ(film({"./em.yaml"}, "whole.gif").status, 0);
  // Ten scans, 0.2 s apart.
  ASSERT_EQ(film({"./em.yaml", "--to", "1.8 s"}, "part.gif").status, 0);
  EXPECT_NE(text("whole.gif"), text("part.gif"));
}

TEST_F(RenderFilm, TakesThePlaceOfAFilmOfOursAlone) {
  make_map();
  write("film.gif", "somebody's");
  expect_refused(film({"m"}), "film.gif: was not written by mapbed");
  EXPECT_EQ(text("film.gif"), "somebody's");
  fs::remove(path("film.gif"));
  EXPECT_EQ(film({"m"}).status, 0);
  EXPECT_EQ(film({"m"}).status, 0) << "again";
}

TEST_F(RenderFilm, SaysWhichEndingsThereAre) {
  for (const char* name : {"film.avi", "film.gifv", "film", "picture.jpg"}) {
    expect_no_film({"office"}, std::string(name) + ": has none of the endings", name);
  }
}

TEST_F(RenderFilm, SaysThatFfmpegIsMissing) {
  const Outcome outcome =
      run_shell("PATH= exec \"$MAPBED\" render ./drives.yaml -o film.mp4", path());
  expect_refused(outcome, "film.mp4: needs the program ffmpeg, which is not installed; apt-get");
  EXPECT_FALSE(fs::exists(path("film.mp4")));
}

TEST_F(RenderFilm, TellsWhatFfmpegSaysWhereItFails) {
  write("ffmpeg", "#!/bin/sh\necho 'no such codec' >&2; exit 3\n");
  fs::permissions(path("ffmpeg"), fs::perms::owner_all);
  const Outcome outcome =
      run_shell("PATH=.:/usr/bin:/bin exec \"$MAPBED\" render ./drives.yaml -o film.mp4", path());
  expect_refused(outcome, "ffmpeg ended with exit status 3; it said 'no such codec'");
  EXPECT_FALSE(fs::exists(path("film.mp4")));
}

TEST_F(RenderFilm, SaysThatThereIsNoRun) {
  fs::create_directory(path("empty"));
  expect_no_film({"empty"}, "empty: holds no run");
  expect_no_film({"absent"}, "'absent'");
  expect_no_film({"./drives.yaml", "--run", "4"}, "there is no run 4; this scenario has 0 to 3");
  expect_no_film({"ch2_matching_basin"}, "the experiment 'matching_basin' shows no method at work");
  make_map();
  expect_no_film({"m", "--run", "2"}, "--run chooses one of a scenario's runs");
  expect_no_film({"m", "m"}, "a film is of one run");
}

TEST_F(RenderFilm, SaysWhatIsWrongWithItsTime) {
  expect_no_film({"./drives.yaml", "--from", "3 s", "--to", "2 s"},
                 "between --from 3 s and --to 2 s there is nothing to be shown");
  expect_no_film({"./drives.yaml", "--to", "0 s"}, "there is nothing to be shown");
  // Ten scans, 0.2 s apart.
  expect_no_film({"./drives.yaml", "--from", "50 s"},
                 "--from 50 s is behind the end: the log is 1.8 s long");
  expect_no_film({"./drives.yaml", "--from", "-1 s"}, "--from: must not be negative");
  expect_no_film({"./drives.yaml", "--to", "3"}, "--to");
}

TEST_F(RenderFilm, SaysWhatIsWrongWithItsOptions) {
  const auto expect = [this](std::vector<std::string> arguments, const std::string& message) {
    arguments.insert(arguments.begin(), {"render", "./drives.yaml", "-o"});
    expect_refusal(arguments, message);
  };
  expect({"film.gif", "--size", "99"}, "--size");
  expect({"film.gif", "--size", "5000"}, "--size of a film must be 100 to 4096");
  expect({"film.gif", "--fps", "51"}, "--fps of a film must be 1 to 50");
  expect({"film.gif", "--fps", "nan"}, "--fps");
  expect({"film.gif", "--speed", "-2"}, "--speed");
  expect({"film.gif", "--camera", "view=plan"}, "--camera says nothing of a film");
  expect({"plan.png", "--speed", "2"}, "--speed is of a film");
  expect({"/dev/null/film.gif"}, "/dev/null/film.gif");
  expect({"no_such_folder/film.gif"}, "no_such_folder/film.gif");
}

TEST_F(RenderFilm, LeavesNothingWhereItIsInterrupted) {
  // 40 s of film; it is interrupted once the first frames are there.
  const Outcome outcome = run_shell(
      "$MAPBED render ./drives.yaml -o film.gif --speed 0.05 --fps 50 --size 1000 & p=$!\n"
      "for i in $(seq 2000); do [ -e .film.gif.unfinished ] && "
      "[ $(stat -c %s .film.gif.unfinished) -gt 0 ] && break; sleep 0.005; done\n"
      "kill -TERM $p; wait $p",
      path());
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.err, HasSubstr("mapbed: interrupted; nothing was written"));
  EXPECT_FALSE(fs::exists(path("film.gif")));
  EXPECT_FALSE(fs::exists(path(".film.gif.unfinished")));
}

}  // namespace
}  // namespace mapbed
