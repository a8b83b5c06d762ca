#include "core/file/unpack.h"

#include <bzlib.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lz4frame.h>
#include <zstd.h>

namespace mapbed {
namespace {

std::string bzip2(const std::string& text) {
  std::string packed(text.size() + 1000, '\0');
  auto size = static_cast<unsigned>(packed.size());
  std::string source = text;
  BZ2_bzBuffToBuffCompress(packed.data(), &size, source.data(),
                           static_cast<unsigned>(source.size()), 9, 0, 0);
  return packed.substr(0, size);
}

std::string lz4(const std::string& text) {
  std::string packed(LZ4F_compressFrameBound(text.size(), nullptr), '\0');
  return packed.substr(
      0, LZ4F_compressFrame(packed.data(), packed.size(), text.data(), text.size(), nullptr));
}

std::string zstd(const std::string& text) {
  std::string packed(ZSTD_compressBound(text.size()), '\0');
  return packed.substr(0, ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), 3));
}

struct Packing {
  const char* name;
  std::string (*pack)(const std::string&);
  Unpacked (*unpack)(std::string_view, std::size_t);
};

void PrintTo(const Packing& packing, std::ostream* out) {
  *out << packing.name;
}

class PackedBytes : public ::testing::TestWithParam<Packing> {
 protected:
  static std::string text() {  // of more than one step, and not the same all over
    std::string text;
    while (text.size() < 700'000) text += std::to_string(text.size() * text.size());
    return text;
  }
  std::string packed() const { return GetParam().pack(text()); }
  Unpacked unpacked(const std::string& bytes, std::size_t most = 1u << 30) const {
    return GetParam().unpack(bytes, most);
  }
};

TEST_P(PackedBytes, AreTheSameWhenUnpacked) {
  const Unpacked whole = unpacked(packed());
  EXPECT_TRUE(whole.is_whole);
  EXPECT_TRUE(whole.bytes == text());
  EXPECT_TRUE(unpacked(packed(), text().size()).is_whole);
}

TEST_P(PackedBytes, AreBoundedWhateverTheyUnpackTo) {
  const Unpacked part = unpacked(packed(), 300'000);
  EXPECT_FALSE(part.is_whole);
  EXPECT_TRUE(part.bytes == text().substr(0, 300'000));
  EXPECT_FALSE(unpacked(packed(), text().size() - 1).is_whole);
}

TEST_P(PackedBytes, CutShortGiveWhatStandsBefore) {
  const std::string whole = packed();
  const Unpacked part = unpacked(whole.substr(0, whole.size() - 50));
  EXPECT_FALSE(part.is_whole);
  EXPECT_TRUE(text().starts_with(part.bytes));
}

TEST_P(PackedBytes, ThatAreNoneGiveNothing) {
  for (const std::string& bytes :
       {std::string(), std::string("no packed bytes at all"), std::string(64, '\0')}) {
    EXPECT_FALSE(unpacked(bytes).is_whole);
    EXPECT_EQ(unpacked(bytes).bytes, "");
  }
}

TEST_P(PackedBytes, OfNothingAreNothing) {
  const Unpacked nothing = unpacked(GetParam().pack(""));
  EXPECT_TRUE(nothing.is_whole);
  EXPECT_EQ(nothing.bytes, "");
}

INSTANTIATE_TEST_SUITE_P(All, PackedBytes,
                         ::testing::Values(Packing{"bzip2", bzip2, unpack_bzip2},
                                           Packing{"lz4", lz4, unpack_lz4},
                                           Packing{"zstd", zstd, unpack_zstd}));

TEST(Zstd, SeveralFramesAreOneAfterTheOther) {
  EXPECT_EQ(unpack_zstd(zstd("one") + zstd("") + zstd("two"), 100).bytes, "onetwo");
}

}  // namespace
}  // namespace mapbed
