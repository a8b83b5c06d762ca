#include "core/image/stroke_font.h"

#include <algorithm>
#include <array>

#include "core/check.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

// A sign is drawn with strokes, separated by blanks. Each is a chain of points, two hexadecimal
// digits x and y, with the base line at y = 3. With '~' in front the points are the control points
// of a quadratic B-spline: round within, through the first and last point, straight where three
// lie in a line, a corner where one is given twice.
struct Sign {
  std::string_view utf8;
  std::string_view strokes;
};

constexpr std::array<Sign, 100> kSigns = {{
    {" ", ""},
    {"!", "0c06 0304"},
    {"\"", "0c09 2c29"},
    {"#", "132c 435c 0969 0666"},
    {"$", "~6a6c0c0868630305 3e31"},
    {"%", "~0a0c4c48080a ~555797935355 8c13"},
    {"&", "~63191d4d490603436377"},
    {"'", "0c09"},
    {"(", "~3e0b0431"},
    {")", "~0e3b3401"},
    {"*", "2b27 0a48 084a"},
    {"+", "0767 3a34"},
    {",", "1401"},
    {"-", "0747"},
    {".", "0304"},
    {"/", "025d"},
    {"0", "~3c0c03636c3c"},
    {"1", "1a3c33"},
    {"2", "~0a0c6c67030363"},
    {"3", "~0a0c5c5828 ~2868630305"},
    {"4", "434c0666"},
    {"5", "5c0c08 ~083969630305"},
    {"6", "~5c0c0363690906"},
    {"7", "0c6c23"},
    {"8", "~3c1c18585c3c ~380803636838"},
    {"9", "~13636c0c066669"},
    {":", "0304 0809"},
    {";", "1819 1401"},
    {"<", "5b0753"},
    {"=", "0969 0666"},
    {">", "0b5703"},
    {"?", "~0a0c5c582826 2324"},
    {"@", "~67693935 6567 ~6965858c0c0272"},
    {"A", "033c63 1656"},
    {"B", "030c ~0c3c5c583808 ~083868633303"},
    {"C", "~6a6c0c036365"},
    {"D", "030c ~0c2c6c632303"},
    {"E", "5c0c0353 0848"},
    {"F", "5c0c03 0848"},
    {"G", "~6a6c0c036367 6737"},
    {"H", "030c 636c 0868"},
    {"I", "030c"},
    {"J", "~4c47430306"},
    {"K", "030c 6c06 2863"},
    {"L", "0c0353"},
    {"M", "030c458c83"},
    {"N", "030c636c"},
    {"O", "~3c0c03636c3c"},
    {"P", "030c ~0c4c6c674707"},
    {"Q", "~3c0c03636c3c 4672"},
    {"R", "030c ~0c4c6c674707 3763"},
    {"S", "~6a6c0c0868630305"},
    {"T", "0c6c 3c33"},
    {"U", "~0c070363676c"},
    {"V", "0c336c"},
    {"W", "0c234a638c"},
    {"X", "036c 0c63"},
    {"Y", "0c376c 3733"},
    {"Z", "0c6c0363"},
    {"[", "3e0e0131"},
    {"\\", "0d52"},
    {"]", "0e3e3101"},
    {"^", "092c49"},
    {"_", "0262"},
    {"`", "0c2a"},
    {"a", "~565909035356 5953"},
    {"b", "0c03 ~060959530306"},
    {"c", "~585909035354"},
    {"d", "5c53 ~565909035356"},
    {"e", "0656 ~565909035354"},
    {"f", "~4c1c1913 0939"},
    {"g", "~565909035356 ~5952500001"},
    {"h", "0c03 ~0609595653"},
    {"i", "0903 0c0c"},
    {"j", "~29222000 2c2c"},
    {"k", "0c03 4905 2753"},
    {"l", "0c03"},
    {"m", "0903 ~0609494643 ~4649898683"},
    {"n", "0903 ~0609595653"},
    {"o", "~060959530306"},
    {"p", "0900 ~060959530306"},
    {"q", "5950 ~565909035356"},
    {"r", "0903 ~060939"},
    {"s", "~5859090656530304"},
    {"t", "~1c161343 0949"},
    {"u", "~0906035356 5953"},
    {"v", "093369"},
    {"w", "0923486389"},
    {"x", "0953 0359"},
    {"y", "0933 6920"},
    {"z", "09590353"},
    {"{", "~4e2e2808 ~08282141"},
    {"|", "0e01"},
    {"}", "~0e2e2848 ~48282101"},
    {"~", "~060939356568"},
    {"\u00b0", "~0b0d3d39090b"},
    {"\u00b1", "0868 3b35 0363"},
    {"\u00d7", "1a54 5a14"},
    {"\u00b2", "~0b0d3d3b080838"},
    {"\u00b5", "0900 ~0906035356 5953"},
}};
constexpr std::string_view kBox = "0c6c63030c";
constexpr double kBaseLine = 3.0;
constexpr double kGap = 3.0;           // between two signs
constexpr double kBlankAdvance = 5.0;  // of a blank
constexpr double kDigitWidth = 6.0;    // digits stand in columns

double digit_of(char c) {
  return c >= 'a' ? c - 'a' + 10 : c - '0';
}

std::vector<Vector2d> points_of(std::string_view digits) {
  CHECK(digits.size() % 2 == 0);
  std::vector<Vector2d> points;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    points.emplace_back(digit_of(digits[i]), digit_of(digits[i + 1]) - kBaseLine);
  }
  return points;
}

// A quadratic B-spline: between the middles of its control polygon's edges, Bezier curves with the
// polygon's corners.
std::vector<Vector2d> rounded(const std::vector<Vector2d>& control) {
  constexpr int kSteps = 8;
  std::vector<Vector2d> curve = {control.front()};
  for (std::size_t i = 1; i + 1 < control.size(); ++i) {
    const bool last = i + 2 == control.size();
    const Vector2d from = curve.back();
    const Vector2d to = last ? control[i + 1] : Vector2d(0.5 * (control[i] + control[i + 1]));
    for (int step = 1; step <= kSteps; ++step) {
      const double t = static_cast<double>(step) / kSteps;
      curve.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * control[i] + t * t * to);
    }
  }
  return curve;
}

Glyph glyph_of(std::string_view strokes) {
  Glyph glyph;
  double width = 0.0;
  while (!strokes.empty()) {
    const std::size_t end = std::min(strokes.find(' '), strokes.size());
    const std::string_view stroke = strokes.substr(0, end);
    const bool round = stroke.starts_with('~');
    const std::vector<Vector2d> points = points_of(stroke.substr(round ? 1 : 0));
    glyph.strokes.push_back(round ? rounded(points) : points);
    for (const Vector2d& point : glyph.strokes.back()) width = std::max(width, point.x());
    strokes.remove_prefix(std::min(end + 1, strokes.size()));
  }
  glyph.advance = glyph.strokes.empty() ? kBlankAdvance : width + kGap;
  return glyph;
}

}  // namespace

Glyph next_glyph(std::string_view& text) {
  CHECK(!text.empty());
  for (const Sign& sign : kSigns) {
    if (!text.starts_with(sign.utf8)) continue;
    text.remove_prefix(sign.utf8.size());
    Glyph glyph = glyph_of(sign.strokes);
    const bool digit = sign.utf8[0] >= '0' && sign.utf8[0] <= '9';
    if (digit) glyph.advance = kDigitWidth + kGap;
    return glyph;
  }
  do {  // the whole sign, with the bytes that continue it
    text.remove_prefix(1);
  } while (!text.empty() && (static_cast<unsigned char>(text[0]) & 0xc0) == 0x80);
  return glyph_of(kBox);
}

}  // namespace mapbed
