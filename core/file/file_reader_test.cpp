#include "core/file/file_reader.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/file/text_file.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

std::string numbers(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += std::to_string(i) + "\n";
  return text;
}

using Lines = std::vector<std::string>;

TEST(FileReader, HandsOverAllBytesInPiecesPlainOrPacked) {
  const TemporaryFolder folder;
  const std::string bytes = numbers(500'000);
  ASSERT_GT(bytes.size(), std::size_t{2} << 20);
  for (const std::string name : {"a.bin", "a.bin.gz"}) {
    write_text_file(folder.file(name), bytes);
    FileReader file(folder.file(name));
    std::string read;
    int pieces = 0;
    for (auto piece = file.next(); !piece.empty(); piece = file.next(), ++pieces) read += piece;
    EXPECT_TRUE(read == bytes) << name;
    EXPECT_EQ(pieces, static_cast<int>((bytes.size() >> 18) + 1)) << name;
  }
}

TEST(FileReader, SaysWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_INPUT_ERROR(FileReader(folder.file("a")), "a: no such file");
  EXPECT_INPUT_ERROR(FileReader(folder.file("")), "is a folder, not a file");

  write_text_file(folder.file("a.gz"), numbers(1000));
  std::ifstream in(folder.file("a.gz"), std::ios::binary);
  std::string packed(std::istreambuf_iterator<char>(in), {});
  packed[packed.size() / 2] ^= 0x55;
  std::ofstream(folder.file("b.gz"), std::ios::binary) << packed;
  EXPECT_INPUT_ERROR(read_text_file(folder.file("b.gz")), "b.gz: the gzip data are damaged");
}

Lines split(const std::string& text, std::size_t step) {
  LineSplitter splitter("a.txt");
  Lines lines;
  const auto take = [&](std::string_view line) { lines.emplace_back(line); };
  for (std::size_t at = 0; at < text.size(); at += step) splitter.add(text.substr(at, step), take);
  splitter.finish(take);
  return lines;
}

TEST(LineSplitter, FindsTheSameLinesHoweverTheTextIsCut) {
  for (const std::size_t step : {1u, 2u, 3u, 5u, 100u}) {
    EXPECT_EQ(split("one\n\ntwo\r\nthree", step), (Lines{"one", "", "two\r", "three"})) << step;
    EXPECT_EQ(split("one\ntwo\n", step), (Lines{"one", "two"})) << step;
  }
  EXPECT_EQ(split("", 1), Lines{});
}

TEST(LineSplitter, RefusesALineWithoutEnd) {
  LineSplitter splitter("a.txt");
  const std::string piece(1 << 20, 'x');
  const auto add = [&](int pieces) {
    for (int i = 0; i < pieces; ++i) splitter.add(piece, [](std::string_view) {});
  };
  add(16);
  EXPECT_INPUT_ERROR(add(1), "a.txt: has a line of more than 16 MiB");
}

}  // namespace
}  // namespace mapbed
