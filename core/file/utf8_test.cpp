#include "core/file/utf8.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(Utf8, IsToldFromOtherBytes) {
  for (const char* text : {"", "plain", "\u00e4", "\u20ac", "\U0001f916", "\ud7ff\ue000"}) {
    EXPECT_TRUE(is_utf8(text)) << text;
    EXPECT_EQ(escaped_utf8(text), text);
  }
  EXPECT_FALSE(is_utf8("b\xE4r")) << "Latin-1";
  EXPECT_FALSE(is_utf8("\xC3")) << "cut short";
  EXPECT_FALSE(is_utf8("\xE2\x82")) << "cut short";
  EXPECT_FALSE(is_utf8("\x80")) << "continues nothing";
  EXPECT_FALSE(is_utf8("\xC0\xAF")) << "longer than needed";
  EXPECT_FALSE(is_utf8("\xE0\x9F\xBF")) << "longer than needed";
  EXPECT_FALSE(is_utf8("\xED\xA0\x80")) << "half of a pair";
  EXPECT_FALSE(is_utf8("\xF4\x90\x80\x80")) << "beyond the last code point";
}

TEST(Utf8, OtherBytesAreEscapedAlone) {
  EXPECT_EQ(escaped_utf8("b\xE4r \u00e4\xC3"), "b\\xE4r \u00e4\\xC3");
}

}  // namespace
}  // namespace mapbed
