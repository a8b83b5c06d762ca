// `mapbed fetch`, from a server on this machine and from folders.

#include <cstdlib>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/cli/testing/command_test.h"
#include "bench/fetch/testing/local_server.h"
#include "core/file/gzip_writer.h"
#include "core/file/hash.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

// MAPBED_DATA names the folder data/ of the test; hall.yaml describes a log on the server.
class FetchCommand : public CommandTest {
 protected:
  void SetUp() override {
    if (const char* data = std::getenv("MAPBED_DATA")) of_before_ = data;
    setenv("MAPBED_DATA", path("data").c_str(), 1);
    for (int scan = 0; scan < 2000; ++scan) {
      log_ += fmt::format("FLASER 3 1 2 3 {0} 0 0 {0} 0 0 {0} h 0\n", scan);
    }
    fs::create_directory(path("public"));
    describe("hall", true);
    server_.put("hall.txt", {log_});
  }
  void TearDown() override {
    if (of_before_) {
      setenv("MAPBED_DATA", of_before_->c_str(), 1);
    } else {
      unsetenv("MAPBED_DATA");
    }
  }

  void describe(const std::string& name, bool is_made) const {
    const std::string file = name + "/" + name + ".log.gz";
    write(
        name + ".yaml",
        fmt::format(
            "about: a round\nfile: {}\nsha256: {}\nsource: by me, 1999\n"
            "licence: CC0\nfetch: walk there\nrobot: r\nlaser: x\nlog: {{field_of_view: 90 deg}}\n",
            file, sha256(gzipped(log_, GzipForm::gzip))));
    if (!is_made) return;
    write("public/" + name + ".yaml",
          fmt::format("cite: Me, 2000\npieces:\n  - {{file: {0}.txt, addresses: ['{1}'], opened: "
                      "never, bytes: {2}, sha256: {3}}}\nmade:\n  - {{file: {4}, content: {3}, "
                      "piece: {0}.txt, by: copy}}\n",
                      name, server_.address(name + ".txt"), log_.size(), sha256(log_), file));
  }

  LocalServer server_;
  std::string log_;
  std::optional<std::string> of_before_;
};

TEST_F(FetchCommand, BringsALogWithItsLicenceShownAndTheOthersFindIt) {
  expect_refusal({"map", "./hall.yaml", "-o", "m"},
                 "hall.yaml: its log 'hall/hall.log.gz' is not here; get it ('mapbed fetch "
                 "./hall.yaml') and set MAPBED_DATA");
  const Outcome got = call({"fetch", "./hall.yaml"});
  EXPECT_EQ(got.status, 0) << got.err;
  EXPECT_EQ(got.out,
            fmt::format("hall: a round\nsource: by me, 1999\nlicence: CC0\nto cite: Me, 2000\n"
                        "got hall.txt from {}\nmade {} of hall.txt\n",
                        server_.address("hall.txt"), path("data/hall/hall.log.gz")));
  EXPECT_EQ(got.err, "");
  EXPECT_EQ(call({"map", "./hall.yaml", "--method", "odometry", "-o", "m"}).status, 0);
  EXPECT_THAT(call({"fetch", "./hall.yaml"}).out,
              EndsWith("already here: " + path("data/hall/hall.log.gz") + "\n"));
  EXPECT_EQ(server_.requests().size(), 1u);
}

TEST_F(FetchCommand, InterruptedItKeepsWhatHasComeAndTheSameCommandGoesOn) {
  server_.put("hall.txt", {.bytes = log_, .most = 20'000, .stalls = true});
  const Outcome stopped = run_shell(
      "$MAPBED fetch ./hall.yaml & p=$!; part=data/hall/fetched-hall.txt.part; "
      "until [ \"$(stat -c %s $part 2>/dev/null)\" = 20000 ]; do sleep 0.02; done; "
      "kill -INT $p; wait $p",
      path());
  EXPECT_EQ(stopped.status, 3) << stopped.err;
  EXPECT_EQ(stopped.err, "mapbed: interrupted; what has come is kept: the same command goes on\n");
  EXPECT_EQ(fs::file_size(path("data/hall/fetched-hall.txt.part")), 20'000u);
}

TEST_F(FetchCommand, GoesOnFromWhatAnEarlierCallHasKept) {
  fs::create_directories(path("data/hall"));
  write("data/hall/fetched-hall.txt.part", log_.substr(0, 20'000));
  EXPECT_EQ(call({"fetch", "./hall.yaml"}).status, 0);
  EXPECT_THAT(server_.requests(), ::testing::ElementsAre("hall.txt from 20000"));
  EXPECT_EQ(text("data/hall/hall.log.gz"), log_);
}

TEST_F(FetchCommand, WithoutANameItListsWhatThereIs) {
  const Outcome list = call({"fetch"});
  EXPECT_EQ(list.status, 0);
  EXPECT_THAT(list.out, AllOf(HasSubstr("aces               to be got, 0.2 MB  ACES building"),
                              HasSubstr("intel              by hand            Intel"),
                              HasSubstr("example            here               Four"),
                              HasSubstr("\nfolder: " + path("data") + "\n")));
  unsetenv("MAPBED_DATA");
  EXPECT_THAT(call({"fetch"}).out,
              HasSubstr("folder: MAPBED_DATA is not set; export MAPBED_DATA="));
}

TEST_F(FetchCommand, NeedsAFolderAndTellsTheOthersOfIt) {
  unsetenv("MAPBED_DATA");
  expect_refusal({"fetch", "./hall.yaml"},
                 "MAPBED_DATA: is not set, so nobody knows where logs are kept; export "
                 "MAPBED_DATA=$HOME/mapbed_data (in ~/.profile, too, for later), or name a folder "
                 "with --to");
  const Outcome got = call({"fetch", "./hall.yaml", "--to", "logs"});
  EXPECT_EQ(got.status, 0) << got.err;
  EXPECT_THAT(got.out,
              EndsWith("for the other commands: export MAPBED_DATA=" + path("logs") + "\n"));
  write("file", "");
  expect_refusal({"fetch", "./hall.yaml", "--to", "file"},
                 "/file: cannot be made: Not a directory; choose another folder with --to");
}

TEST_F(FetchCommand, OneThatCannotBeGotKeepsNoOtherAway) {
  describe("yard", false);
  const Outcome outcome = call({"fetch", "./yard.yaml", "./hall.yaml"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("by hand: walk there\n"));
  EXPECT_EQ(outcome.err,
            "mapbed: yard.yaml: its file 'yard/yard.log.gz' is made by hand; take the steps above, "
            "or name a folder or a mirror that has it with --from\n");
  EXPECT_EQ(text("data/hall/hall.log.gz"), log_);
  expect_refusal({"fetch", "./yard.yaml"},
                 "yard.yaml: its file 'yard/yard.log.gz' is made by hand");
}

TEST_F(FetchCommand, TakesAFolderOrAMirror) {
  fs::create_directory(path("stick"));
  write("stick/hall.txt", log_);
  EXPECT_EQ(call({"fetch", "./hall.yaml", "--from", "stick"}).status, 0);
  EXPECT_TRUE(server_.requests().empty());
  fs::remove_all(path("data"));
  server_.put("mirror/hall.txt", {log_});
  EXPECT_EQ(call({"fetch", "./hall.yaml", "--from", server_.address("mirror")}).status, 0);
  EXPECT_EQ(text("data/hall/hall.log.gz"), log_);
  fs::remove_all(path("data"));
  expect_refusal({"fetch", "./hall.yaml", "--from", "nowhere"}, "nowhere: does not have ");
  EXPECT_FALSE(fs::exists(path("data")));
}

TEST_F(FetchCommand, TwoAtOnceInOneFolderAreOneTooMany) {
  const Outcome outcome = run_shell(
      "mkdir data; flock data/.lock sh -c 'touch held; while [ -e held ]; do sleep 0.1; done' & "
      "until [ -e held ]; do sleep 0.1; done; $MAPBED fetch ./hall.yaml; s=$?; rm held; wait; "
      "exit $s",
      path());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("at work in this folder; wait for it to end, or choose "
                                     "another folder with --to"));
}

TEST_F(FetchCommand, RefusesWhatItDoesNotKnow) {
  expect_refusal({"fetch", "acess"}, "unknown log 'acess'; did you mean 'aces'?");
  expect_refusal({"fetch", "--all", "aces"}, "--all is all of them; leave the names out");
  expect_refusal({"fetch", "./hall.yaml", "--form", "x"}, "did you mean '--from'?");
}

TEST_F(FetchCommand, AScenarioThatLacksItsLogSaysHowToGetIt) {
  write("s.yaml",
        "about: a\nlog: ./hall.yaml\ncompare: {raw: {estimator: odometry}}\nseeds: 1\n"
        "metrics: [path_length]\n");
  expect_refusal({"run", "./s.yaml", "-o", "r"},
                 "is not here (hall/hall.log.gz; 'mapbed fetch " + path("hall.yaml") +
                     "' gets it); set MAPBED_DATA to the folder that holds the logs");
}

TEST_F(FetchCommand, DescribeAndListKnowWhatCanBeGot) {
  EXPECT_THAT(call({"list", "logs"}).out,
              AllOf(HasSubstr("(not here: 'mapbed fetch aces' gets it)"),
                    HasSubstr("(not here: 'mapbed fetch intel' says how to get it)"),
                    Not(HasSubstr("'mapbed fetch example'"))));
  const std::string aces = call({"describe", "aces"}).out;
  EXPECT_THAT(aces,
              AllOf(HasSubstr("cite: Andrew Howard"),
                    HasSubstr("- aces-corrected.log.gz: 202430 bytes, SHA-256 5434d443"),
                    HasSubstr("    https://raw.githubusercontent.com/"), HasSubstr("opened: never"),
                    HasSubstr("made by fetch: radish_gfs/rawodom/aces_rawodom.clf.gz of "
                              "aces-corrected.log.gz (chained_odometry)")));
  EXPECT_THAT(call({"describe", "intel"}).out, HasSubstr("by hand:\n  - get data/intel.rawlog"));
}

}  // namespace
}  // namespace mapbed
