#include "bench/plot/svg_text.h"

#include <gmock/gmock.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;

TEST(SvgText, NoTextCanBreakTheFile) {
  EXPECT_EQ(xml_escaped("a<b & \"c\"'d'>"), "a&lt;b &amp; &quot;c&quot;&#39;d&#39;&gt;");
  EXPECT_EQ(xml_escaped("caf\xC3\xA9 \xE2\x88\x92"), "caf\xC3\xA9 \xE2\x88\x92");
  EXPECT_EQ(xml_escaped(std::string_view("\x01\x00\x7F", 3)), "   ");
  EXPECT_EQ(xml_escaped("\xFF\xC3"), "\xEF\xBF\xBD\xEF\xBF\xBD");
  EXPECT_EQ(xml_escaped("\xED\xA0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD") << "a surrogate";
}

TEST(SvgText, CoordinatesAreShort) {
  EXPECT_EQ(coordinate(12.0), "12");
  EXPECT_EQ(coordinate(0.25), "0.25");
  EXPECT_EQ(coordinate(-0.001), "0");
  EXPECT_EQ(coordinate(100.0), "100");
}

TEST(SvgText, LinesAreBrokenBetweenWords) {
  EXPECT_THAT(wrapped("one two", 10.0, 1000.0), ElementsAre("one two"));
  EXPECT_THAT(wrapped("one two", 10.0, 1.0), ElementsAre("one", "two"));
  EXPECT_THAT(wrapped("one\ntwo", 10.0, 1000.0), ElementsAre("one", "two"));
  EXPECT_THAT(wrapped("", 10.0, 1000.0), ElementsAre());
}

TEST(SvgText, LettersOfSeveralBytesAreAsWideAsOthers) {
  EXPECT_NEAR(svg_text_width("caf\xC3\xA9", 10.0), svg_text_width("cafe", 10.0), 1e-12);
}

TEST(SvgText, LeavesRoomForTheWidestFonts) {
  // DejaVu Sans, measured in a browser: "error [m]" and, bold, "true path", in font sizes.
  EXPECT_GT(svg_text_width("error [m]", 1.0), 4.493);
  EXPECT_GT(svg_text_width("true path", 1.0, FontWeight::bold), 5.148);
  EXPECT_GT(svg_text_width("\u22121", 1.0), 1.474) << "a minus is as wide as a capital";
}

TEST(SvgText, IsSetSmallerWhereThereIsNotEnoughRoom) {
  EXPECT_EQ(fitting_size("error", 10.0, 1000.0), 10.0);
  EXPECT_NEAR(svg_text_width("error", fitting_size("error", 10.0, 7.0)), 7.0, 1e-12);
}

TEST(Base64, OfTheExamplesInRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE"), "//4=");
}

}  // namespace
}  // namespace mapbed
