// Files from a server on this machine that behaves well and badly, and from folders.

#include "bench/fetch/get_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/fetch/curl.h"
#include "bench/fetch/testing/local_server.h"
#include "core/file/gzip_writer.h"
#include "core/file/hash.h"
#include "core/input_error.h"
#include "core/interrupted.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

class GetFile : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int i = 0; i < 3000; ++i) data_ += fmt::format("line {}\n", i);
    wanted_ = {folder_.file("a.log"), data_.size(), sha256(data_)};
  }

  bool get(const std::string& name = "a.log") const {
    return get_file(server_.address(name), wanted_);
  }
  std::string message() const {
    try {
      (void)get();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_.file(name), std::ios::binary) << bytes;
  }
  std::string bytes(const std::string& name) const {
    std::ifstream file(folder_.file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  // The file is there, and nothing but it.
  void expect_got() const {
    EXPECT_EQ(bytes("a.log"), data_);
    EXPECT_EQ(folder_.files(), 1u);
  }

  TemporaryFolder folder_;
  LocalServer server_;
  std::string data_;
  WantedFile wanted_;
};

TEST_F(GetFile, ComesFromAnAddress) {
  server_.put("a.log", {data_});
  EXPECT_TRUE(get());
  expect_got();
}

TEST_F(GetFile, GoesOnWhereAnEarlierOneStopped) {
  server_.put("a.log", {data_});
  write("a.log.part", data_.substr(0, 1000));
  EXPECT_TRUE(get());
  expect_got();
  EXPECT_THAT(server_.requests(), ElementsAre("a.log from 1000"));
}

TEST_F(GetFile, GoesOnByItselfWhereTheConnectionBreaks) {
  server_.put("a.log", {.bytes = data_, .most = data_.size() / 3 + 1});
  EXPECT_TRUE(get());
  expect_got();
  EXPECT_EQ(server_.requests().size(), 3u);
}

TEST_F(GetFile, KeepsWhatHasComeWhereTheConnectionBreaksForGood) {
  server_.put("a.log", {.bytes = data_, .most = 100});
  EXPECT_THAT(message(),
              AllOf(HasSubstr("a.log: the connection ended half-way; 500 of "),
                    HasSubstr(" bytes have come and are kept: the same command goes on")));
  EXPECT_EQ(bytes("a.log.part"), data_.substr(0, 500));
}

TEST_F(GetFile, BeginsAnewWhereTheServerGivesNoSecondHalf) {
  server_.put("a.log", {.bytes = data_, .has_ranges = false});
  write("a.log.part", data_.substr(0, 1000));
  EXPECT_TRUE(get());
  expect_got();
  EXPECT_THAT(server_.requests(), ElementsAre("a.log from 1000", "a.log"));
}

TEST_F(GetFile, BeginsAnewWhereThePartIsOfAnotherFile) {
  server_.put("a.log", {data_});
  for (const std::size_t length : {std::size_t{1000}, data_.size(), data_.size() + 7}) {
    fs::remove(folder_.file("a.log"));
    write("a.log.part", std::string(length, 'x'));
    EXPECT_TRUE(get()) << length;
    expect_got();
  }
}

TEST_F(GetFile, AWholePartIsNotFetchedAgain) {
  write("a.log.part", data_);
  EXPECT_TRUE(get());
  expect_got();
  EXPECT_TRUE(server_.requests().empty());
}

TEST_F(GetFile, SaysThatNothingIsThere) {
  EXPECT_FALSE(get("no.log"));
  EXPECT_FALSE(get_file(folder_.file("no.log"), wanted_));
  EXPECT_EQ(folder_.files(), 0u);
}

TEST_F(GetFile, FollowsAnAddressToAnother) {
  server_.put("a.log", {data_});
  server_.put("old.log", {.redirect = server_.address("a.log")});
  EXPECT_TRUE(get("old.log"));
  expect_got();
}

TEST_F(GetFile, KeepsNothingThatIsNotTheFile) {
  server_.put("a.log", {std::string(data_.size(), 'x')});
  EXPECT_THAT(message(),
              HasSubstr(fmt::format("a.log: gives another file: its SHA-256 is {}…, not {}…; it "
                                    "was not kept; name a folder or a mirror that has the file "
                                    "with --from",
                                    sha256(std::string(data_.size(), 'x')).substr(0, 12),
                                    wanted_.sha256.substr(0, 12))));
  server_.put("a.log", {"short"});
  EXPECT_THAT(message(),
              HasSubstr(fmt::format("gives 5 bytes, and the file has {}", data_.size())));
  server_.put("a.log", {"\n<!DOCTYPE html><html>log in</html>"});
  EXPECT_THAT(message(), HasSubstr("gives an HTML page of 35 bytes"));
  server_.put("a.log", {""});
  EXPECT_THAT(message(), HasSubstr("gives an empty file"));
  EXPECT_EQ(folder_.files(), 0u);
}

TEST_F(GetFile, TellsWhatIsWrongWithTheServerOrTheNetwork) {
  server_.put("a.log", {.bytes = "later", .status = 503});
  EXPECT_THAT(message(), HasSubstr("a.log: the server answers with status 503; try again later, or "
                                   "name a folder or a mirror that has the file with --from"));
  server_.put("a.log", {.redirect = server_.address("a.log")});
  EXPECT_THAT(message(), HasSubstr("sends from one address to the next without an end"));
  EXPECT_INPUT_ERROR(get_file("http://127.0.0.1:1/a.log", wanted_), "the host does not answer");
  EXPECT_INPUT_ERROR(get_file("http://a..b/a.log", wanted_),
                     "the host was not found (no network?); try again later, or ");
  EXPECT_INPUT_ERROR(get_file("gopher://127.0.0.1/a.log", wanted_), "curl ended with status 1");
}

TEST_F(GetFile, TellsThatTheDiskIsFull) {
  server_.put("a.log", {data_});
  fs::create_symlink("/dev/full", folder_.file("a.log.part"));
  EXPECT_THAT(message(), HasSubstr("what comes cannot be written (disk full?)"));
  fs::create_symlink("/dev/full", folder_.file("b.log.part"));
  write("a.log", data_);
  WantedFile copy = wanted_;
  copy.path = folder_.file("b.log");
  EXPECT_INPUT_ERROR(get_file(folder_.file("a.log"), copy), "make room, or name another folder");
}

TEST_F(GetFile, StopsWhenItIsToldToAndGoesOnTheNextTime) {
  server_.put("a.log", {.bytes = data_, .most = 2000, .stalls = true});
  const auto until_some_came = [](std::uint64_t bytes) { return bytes < 2000; };
  EXPECT_THROW(get_file(server_.address("a.log"), wanted_, until_some_came), Interrupted);
  EXPECT_EQ(bytes("a.log.part"), data_.substr(0, 2000));
  EXPECT_EQ(folder_.files(), 1u);
}

TEST_F(GetFile, IsCopiedFromAFolder) {
  const TemporaryFolder other;
  std::ofstream(other.file("a.log")) << data_;
  EXPECT_TRUE(get_file(other.file("a.log"), wanted_));
  expect_got();
  std::ofstream(other.file("a.log")) << "other";
  EXPECT_INPUT_ERROR(get_file(other.file("a.log"), wanted_), "gives 5 bytes, and the file has");
  EXPECT_THROW(get_file(other.file("a.log"), wanted_, [](std::uint64_t) { return false; }),
               Interrupted);
  expect_got();
}

TEST_F(GetFile, IsRightHoweverItIsPacked) {
  const std::string one = gzipped(data_, GzipForm::gzip);
  const std::string other = gzipped(data_, GzipForm::python);
  server_.put("a.gz", {other});
  const std::string path = folder_.file("a.gz");
  EXPECT_INPUT_ERROR(get_file(server_.address("a.gz"), {path, 0, sha256(one)}),
                     "gives another file");
  EXPECT_TRUE(get_file(server_.address("a.gz"), {path, 0, sha256(one), sha256(data_)}));
  EXPECT_EQ(bytes("a.gz"), other);
}

TEST_F(GetFile, WithoutAChecksumAnythingCounts) {
  server_.put("a.log", {"anything"});
  EXPECT_TRUE(get_file(server_.address("a.log"), {folder_.file("a.log")}));
  EXPECT_EQ(bytes("a.log"), "anything");
}

TEST_F(GetFile, NeedsTheProgramCurl) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder_.file(".").c_str(), 1);
  const std::string told = message();
  setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(told, HasSubstr("is fetched by the program curl, which is not here; apt-get install "
                              "curl, or "));
}

TEST(AddressBelow, WritesOtherSignsThanThoseOfAddressesAsNumbers) {
  EXPECT_EQ(address_below("http://a/b", "c d/é+1.log"), "http://a/b/c%20d/%C3%A9%2B1.log");
  EXPECT_EQ(address_below("http://a/b/", "c-1_2~.gz"), "http://a/b/c-1_2~.gz");
}

}  // namespace
}  // namespace mapbed
