#include "core/file/text_file.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <zlib.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

std::string packed(const std::string& path, const std::string& content) {
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, content.data(), static_cast<unsigned>(content.size()));
  gzclose(file);
  return path;
}

std::string message_of(const std::string& path, std::size_t max_bytes = 1000) {
  try {
    read_text_file(path, max_bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

class TextFile : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return ::testing::TempDir() + "text_" + name; }
};

TEST_F(TextFile, ReadsPlainAndPackedAlike) {
  std::ofstream(path("plain")) << "one\ntwo\n";
  EXPECT_EQ(read_text_file(path("plain")), "one\ntwo\n");
  EXPECT_EQ(read_text_file(packed(path("packed"), "one\ntwo\n")), "one\ntwo\n");
}

TEST_F(TextFile, ReadsPastTheMarkThatSomeEditorsPutInFront) {
  std::ofstream(path("marked")) << "\xef\xbb\xbfone\n";
  EXPECT_EQ(read_text_file(path("marked")), "one\n");
}

TEST_F(TextFile, RefusesWhatIsNoFile) {
  EXPECT_THAT(message_of(path("absent")), HasSubstr("text_absent: no such file"));
  EXPECT_THAT(message_of(::testing::TempDir()), HasSubstr("is a folder, not a file"));
}

TEST_F(TextFile, RefusesGzipThatWasCutShort) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += std::to_string(i * 7919) + "\n";
  packed(path("whole.gz"), text);
  std::filesystem::resize_file(path("whole.gz"), std::filesystem::file_size(path("whole.gz")) / 2);
  EXPECT_THAT(message_of(path("whole.gz"), 1U << 20), HasSubstr("the gzip data are cut short"));
}

TEST_F(TextFile, RefusesContentBeyondTheLimit) {
  packed(path("bomb.gz"), std::string(2'000'000, '0'));
  EXPECT_THAT(message_of(path("bomb.gz"), 1U << 20), HasSubstr("holds more than 1 MB"));
}

}  // namespace
}  // namespace mapbed
