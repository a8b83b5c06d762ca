#include "bench/pages/figure_html.h"

#include <gmock/gmock.h>

#include "bench/plot/plot.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(FigureHtml, PlotsOfOursArePartOfThePage) {
  const Plot plot{.title = "A \"title\" & <more>",
                  .series = {{.name = "a", .x = {0.0, 1.0}, .y = {1.0, 2.0}}}};
  const std::string svg = svg_of(plot);
  EXPECT_TRUE(is_plain_drawing(svg));
  EXPECT_EQ(figure_html(svg), svg);
}

TEST(FigureHtml, WhatRunsOrLeadsOutOfThePageIsShownAsAnImage) {
  for (const std::string inside : {"<script>alert(1)</script>",
                                   "<SCRIPT>alert(1)</SCRIPT>",
                                   "<rect onload=\"alert(1)\"/>",
                                   "<rect fill=\"a\"onload=\"alert(1)\"/>",
                                   "<rect onload='alert(1)'/>",
                                   "<rect onload=alert(1) />",
                                   "<foreignObject><p>text</p></foreignObject>",
                                   "<a href=\"javascript:alert(1)\">x</a>",
                                   "<image href=\"https://example.org/a.png\"/>",
                                   "<image href=\"data:image/svg+xml;base64,AA\"/>",
                                   "<use href=\"#x\"/>",
                                   "<style>p {display: none}</style>",
                                   "<set attributeName=\"href\"/>",
                                   "<rect style=\"background: url(https://example.org)\"/>",
                                   "<rect fill=\"url(https://example.org)\"/>",
                                   "<rect fill=\"&#117;rl(x)\"/>",
                                   "<!-- comment -->",
                                   "<![CDATA[<script>]]>",
                                   "<?xml version=\"1.0\"?>",
                                   "</svg></svg><b>",
                                   "<rect fill=\"<script>\"/>",
                                   "</svg><svg>",
                                   "<rect",
                                   "<rect fill=\""}) {
    const std::string svg = "<svg>" + inside + "</svg>";
    EXPECT_FALSE(is_plain_drawing(svg)) << svg;
    EXPECT_THAT(figure_html(svg), HasSubstr("<img src=\"data:image/svg+xml;base64,"));
    EXPECT_THAT(figure_html(svg), Not(HasSubstr(inside)));
  }
  EXPECT_FALSE(is_plain_drawing("<svg></svg>text"));
  EXPECT_FALSE(is_plain_drawing("<p></p>"));
  EXPECT_FALSE(is_plain_drawing(""));
}

}  // namespace
}  // namespace mapbed
