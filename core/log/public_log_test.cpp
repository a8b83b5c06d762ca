#include "core/log/public_log.h"

#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/file/gzip_writer.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"
#include "core/log/log_description.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

class PublicLogFile : public ::testing::Test {
 protected:
  PublicLogFile() {
    std::filesystem::create_directory(folder_.file("public"));
    write_text_file(folder_.file("a.yaml"),
                    fmt::format("about: a\nfile: a.log.gz\nsha256: {}\nsource: s\nlicence: l\n"
                                "fetch: f\nrobot: r\nlaser: x\nlog: {{field_of_view: 90 deg}}\n",
                                sha256(gzipped(log_, GzipForm::python))));
  }
  PublicLog read(const std::string& text) const {
    write_text_file(folder_.file("public/a.yaml"), text);
    return load_public_log(folder_.file("a.yaml"));
  }
  static std::string pieces(const std::string& file, const std::string& address) {
    return fmt::format("pieces: [{{file: {}, addresses: ['{}'], opened: never}}]\n", file, address);
  }
  std::string made(const std::string& piece) const {
    return fmt::format("made: [{{file: a.log.gz, content: {}, piece: {}, by: copy}}]\n",
                       sha256(log_), piece);
  }
  std::string message() const {
    try {
      (void)open_log(folder_.file("a.yaml"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder_;
  const std::string log_ = "FLASER 3 1 2 3 0 0 0 0 0 0 5 h 0\n";
};

TEST_F(PublicLogFile, IsEmptyWhereThereIsNone) {
  EXPECT_TRUE(load_public_log(folder_.file("a.yaml")).pieces.empty());
  EXPECT_FALSE(can_be_fetched(load_log_description(folder_.file("a.yaml"))));
}

TEST_F(PublicLogFile, RefusesWhatIsWrong) {
  EXPECT_INPUT_ERROR(read(pieces("a.log", "ftp://a/a.log")),
                     "a.yaml:1: 'ftp://a/a.log' is no address of a public file");
  EXPECT_INPUT_ERROR(read(pieces("../a.log", "http://a/a.log")), "a piece has a plain name");
  EXPECT_INPUT_ERROR(read("pieces: [{file: a, addresses: [], opened: never}]\n"),
                     "a piece has an address");
  EXPECT_INPUT_ERROR(read(pieces("a.log", "http://a/a.log") + made("b.log")),
                     "a.yaml:2: there is no piece 'b.log'");
  EXPECT_INPUT_ERROR(read("citation: me\n"), "unknown key 'citation'");
  EXPECT_INPUT_ERROR(read("pieces: [{file: a, addresses: ['http://a'], opened: never, sha256: 1}]"),
                     "a SHA-256 has 64 hexadecimal digits");
}

TEST_F(PublicLogFile, ALogThatCanBeFetchedIsSaidToBe) {
  (void)read(pieces("a.log", "http://a/a.log") + made("a.log"));
  EXPECT_THAT(message(), HasSubstr("its log 'a.log.gz' is not here; get it ('mapbed fetch " +
                                   folder_.file("a.yaml") + "') and set MAPBED_DATA"));
}

TEST_F(PublicLogFile, ALogThatIsPackedOtherwiseIsTheSame) {
  write_text_file(folder_.file("a.log.gz"), log_);
  EXPECT_THAT(message(), HasSubstr("is not the file that a.yaml describes"));
  (void)read(pieces("a.log", "http://a/a.log") + made("a.log"));
  EXPECT_EQ(message(), "no error");
  write_text_file(folder_.file("a.log.gz"), log_ + log_);
  EXPECT_THAT(message(), HasSubstr("is not the file that a.yaml describes"));
}

TEST_F(PublicLogFile, AFileLeadsOutOfNoFolder) {
  for (const char* file : {"../a.log", "a/../../a.log", "..", "a/"}) {
    write_text_file(folder_.file("b.yaml"),
                    fmt::format("about: a\nfile: {}\nsha256: {}\nsource: s\nlicence: l\nfetch: f\n"
                                "robot: r\nlaser: x\n",
                                file, sha256("")));
    EXPECT_INPUT_ERROR(load_log_description(folder_.file("b.yaml")),
                       "b.yaml:2: the file's path must not lead out of the folder");
  }
}

}  // namespace
}  // namespace mapbed
