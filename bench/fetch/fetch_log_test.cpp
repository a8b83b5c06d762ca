#include "bench/fetch/fetch_log.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/fetch/testing/local_server.h"
#include "core/file/gzip_writer.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/log/log_description.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

// A log and relations, both made of public files: hall.txt and hall.relations.
class FetchLog : public ::testing::Test {
 protected:
  FetchLog() {
    fs::create_directories(path("logs/public"));
    write("logs/hall.yaml",
          fmt::format("about: a\nfile: hall/hall.log.gz\nsha256: {}\nsource: s\nlicence: l\nfetch: "
                      "walk round the hall\nrobot: r\nlaser: x\npieces: [a tape]\nrelations: "
                      "{{file: hall/hall.relations, sha256: {}}}\n",
                      sha256(packed_), sha256(relations_)));
    write_public(made("hall/hall.log.gz", log_, "hall.txt") +
                 made("hall/hall.relations", relations_, "hall.relations"));
    options_.folder = path("data");
  }

  static std::string made(const std::string& file, const std::string& content,
                          const std::string& piece) {
    return fmt::format("  - {{file: {}, content: {}, piece: {}, by: copy}}\n", file,
                       sha256(content), piece);
  }
  std::string piece(const std::string& name, const std::string& bytes) const {
    return fmt::format(
        "  - {{file: {}, addresses: [{}, {}], opened: never, bytes: {}, sha256: {}}}\n", name,
        server_.address("gone/" + name), server_.address(name), bytes.size(), sha256(bytes));
  }
  void write_public(const std::string& made, const std::string& more = "") const {
    write("logs/public/hall.yaml", "pieces:\n" + piece("hall.txt", log_) +
                                       piece("hall.relations", relations_) + "made:\n" + made +
                                       more);
  }
  void write(const std::string& name, const std::string& bytes) const {
    fs::create_directories(fs::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  std::string path(const std::string& name) const { return folder_.file(name); }
  void fetch() {
    said_.clear();
    fetch_log(load_log_description(path("logs/hall.yaml")), options_,
              {[this](const std::string& line) { said_.push_back(line); }, {}});
  }
  void expect_all() const {
    EXPECT_EQ(read_text_file(path("data/hall/hall.log.gz")), log_);
    EXPECT_EQ(read_text_file(path("data/hall/hall.relations")), relations_);
    int files = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(path("data/hall"))) ++files;
    EXPECT_EQ(files, 2);
  }

  const std::string log_ = "FLASER 3 1 2 3 0 0 0 0 0 0 5 h 0\n";
  const std::string relations_ = "0 1 0.5 0 0 0 0 0\n";
  const std::string packed_ = gzipped(log_, GzipForm::gzip);
  TemporaryFolder folder_;
  LocalServer server_;
  FetchOptions options_;
  std::vector<std::string> said_;
};

TEST_F(FetchLog, MakesItsFilesOfThePublicOnesAndKeepsNothingElse) {
  server_.put("hall.txt", {log_});
  server_.put("hall.relations", {relations_});
  fetch();
  expect_all();
  EXPECT_EQ(sha256_of_file(path("data/hall/hall.log.gz")), sha256(packed_));
  EXPECT_THAT(server_.requests(),
              ElementsAre("gone/hall.txt", "hall.txt", "gone/hall.relations", "hall.relations"));
  fetch();  // nothing is got again
  EXPECT_THAT(said_, ElementsAre("already here: " + path("data/hall/hall.log.gz"),
                                 "already here: " + path("data/hall/hall.relations")));
  EXPECT_EQ(server_.requests().size(), 4u);
}

TEST_F(FetchLog, TakesThemFromAFolderOrAMirrorHoweverThatIsLaidOut) {
  const auto from = [&](const std::string& place) {
    fs::remove_all(path("data"));
    options_.from = place;
    fetch();
    expect_all();
  };
  write("same/hall/hall.log.gz", packed_);
  write("same/hall/hall.relations", relations_);
  from(path("same"));
  write("flat/hall.log.gz", gzipped(log_, GzipForm::python));
  write("flat/hall.relations", relations_);
  from(path("flat"));
  write("pieces/hall.txt", log_);
  write("pieces/hall.relations", relations_);
  from(path("pieces"));
  server_.put("m/hall/hall.log.gz", {packed_});
  server_.put("m/hall.relations", {relations_});
  from(server_.address("m"));
  server_.put("n/hall.txt", {log_});
  server_.put("n/hall.relations", {relations_});
  from(server_.address("n/"));
}

TEST_F(FetchLog, SaysWhatTheNamedPlaceDoesNotHave) {
  options_.from = path("empty");
  EXPECT_INPUT_ERROR(fetch(),
                     "empty: does not have 'hall/hall.log.gz'; leave --from out, for its "
                     "public address or the steps to take");
  write("bad/hall.log.gz", "something else");
  options_.from = path("bad");
  EXPECT_INPUT_ERROR(fetch(), "bad/hall.log.gz: gives another file: its SHA-256 is ");
}

TEST_F(FetchLog, TellsTheStepsWhereItCannotMakeAFileAndMakesTheOthers) {
  write_public(made("hall/hall.relations", relations_, "hall.relations"),
               "by_hand: [put on shoes, walk]\n");
  server_.put("hall.relations", {relations_});
  EXPECT_INPUT_ERROR(fetch(),
                     "hall.yaml: its file 'hall/hall.log.gz' is made by hand; take the "
                     "steps above, or name a folder or a mirror that has it with --from");
  EXPECT_TRUE(fs::exists(path("data/hall/hall.relations")));
  EXPECT_THAT(fmt::format("{}", fmt::join(said_, "\n")),
              HasSubstr("by hand: walk round the hall\n  piece: a tape\n"));
  EXPECT_THAT(said_, ::testing::Contains("  1. put on shoes"));
  EXPECT_THAT(said_, ::testing::Contains("  2. walk"));

  server_.put("hall.relations",
              {.bytes = "busy", .status = 503});  // the steps are told all the same
  fs::remove_all(path("data"));
  EXPECT_INPUT_ERROR(fetch(), "the server answers with status 503");
  EXPECT_THAT(said_, ::testing::Contains("  2. walk"));
  EXPECT_FALSE(fs::exists(path("data/hall")));
}

TEST_F(FetchLog, LeavesAFileThatIsAnotherUnlessItIsForced) {
  server_.put("hall.txt", {log_});
  server_.put("hall.relations", {relations_});
  write("data/hall/hall.log.gz", "of my own");
  EXPECT_INPUT_ERROR(fetch(),
                     "hall.log.gz: is another file than the one that hall.yaml describes; "
                     "--force takes the described one in its place");
  EXPECT_EQ(read_text_file(path("data/hall/hall.log.gz")), "of my own");
  options_.force = true;
  fetch();
  expect_all();
}

TEST_F(FetchLog, SaysWhereAnAddressHasNothingAnyMore) {
  EXPECT_INPUT_ERROR(fetch(), server_.address("hall.txt") +
                                  ": nothing is there any more; name a "
                                  "folder or a mirror");
}

TEST_F(FetchLog, AFileBesideTheDescriptionIsThere) {
  write("logs/hall/hall.log.gz", packed_);
  write("logs/hall/hall.relations", relations_);
  fetch();
  EXPECT_THAT(server_.requests(), IsEmpty());
  EXPECT_FALSE(fs::exists(path("data")));
}

TEST_F(FetchLog, WhatIsMadeOfAnotherPublicFileIsRefused) {
  const std::string other = "FLASER 3 1 2 9 0 0 0 0 0 0 5 h 0\n";
  write("logs/public/hall.yaml",
        fmt::format("pieces: [{{file: hall.txt, addresses: ['{}'], opened: never}}]\nmade:\n",
                    server_.address("hall.txt")) +
            made("hall/hall.log.gz", log_, "hall.txt"));
  server_.put("hall.txt", {other});
  EXPECT_INPUT_ERROR(fetch(), "hall.log.gz: what was made of hall.txt is not what shall be in it");
  EXPECT_THAT(said_, ::testing::Contains(HasSubstr("its checksum is not known")));
  EXPECT_FALSE(fs::exists(path("data/hall")));
}

}  // namespace
}  // namespace mapbed
