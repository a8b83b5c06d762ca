#include "core/file/gzip_writer.h"

#include <filesystem>

#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

TEST(GzipWriter, WritesInPiecesWhatIsReadAsOne) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.gz");
  std::string whole;
  GzipWriter writer(path);
  for (int i = 0; i < 1000; ++i) {
    const std::string piece(static_cast<std::size_t>(i % 300), static_cast<char>(i % 251));
    writer.write(piece);
    whole += piece;
  }
  writer.commit();

  EXPECT_EQ(read_text_file(path), whole);
  EXPECT_LT(std::filesystem::file_size(path), whole.size() / 10);  // runs of one byte pack well
}

TEST(GzipWriter, LeavesNothingBehindThatIsNotComplete) {
  const TemporaryFolder folder;
  { GzipWriter(folder.file("a.gz")).write("half"); }
  EXPECT_EQ(folder.files(), 0u);
}

// What `printf 'mapbed\n' | gzip -9n | xxd -p` prints. Python's GzipFile does not name the system.
TEST(GzipWriter, PacksAsOtherProgramsDoToTheByte) {
  const auto expected = [](char system) {
    std::string bytes(
        "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\xcb\x4d\x2c\x48\x4a\x4d\xe1\x02\x00\x95"
        "\xbf\x00\x73\x07\x00\x00\x00",
        27);
    bytes[9] = system;
    return bytes;
  };
  EXPECT_EQ(gzipped("mapbed\n", GzipForm::gzip), expected('\x03'));
  EXPECT_EQ(gzipped("mapbed\n", GzipForm::plain), expected('\x03'));
  EXPECT_EQ(gzipped("mapbed\n", GzipForm::python), expected('\xff'));
}

}  // namespace
}  // namespace mapbed
