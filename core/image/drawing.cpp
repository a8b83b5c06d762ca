#include "core/image/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

namespace mapbed {
namespace {

using Eigen::Vector2d;
using Strokes = std::vector<std::vector<Vector2d>>;

constexpr int kFine = 7;         // steps of a mask to a pixel: odd, so that a centre is a step
constexpr int kShift = 4;        // bits of OpenCV's coordinates behind the point
constexpr int kBandHeight = 64;  // [pixels] rows that are drawn at a time, for memory
constexpr double kFar = 1e5;     // [pixels] points beyond are taken as no further

// A part of the picture, enlarged: what is drawn into it is blended into the picture.
class Band {
 public:
  Band(RgbImage& image, const cv::Rect& area)  // pixels of the picture
      : image_(image),
        area_(area),
        mask_(area.height * kFine, area.width * kFine, CV_8U, cv::Scalar(0)) {}

  cv::Mat& mask() { return mask_; }
  double top() const { return area_.y; }
  double bottom() const { return area_.y + area_.height; }

  // In steps of the mask, with the first step's centre at 0.
  Vector2d in_steps(const Vector2d& p) const {
    const Eigen::Array2d clamped = p.array().max(-kFar).min(kFar);
    return ((clamped - Eigen::Array2d(area_.x, area_.y)) * kFine - 0.5).matrix();
  }
  cv::Point fixed(const Vector2d& p) const {
    const Vector2d steps = in_steps(p) * (1 << kShift);
    return {static_cast<int>(std::lround(steps.x())), static_cast<int>(std::lround(steps.y()))};
  }
  static int fixed_length(double pixels) {
    return static_cast<int>(std::lround(std::min(pixels, kFar) * kFine * (1 << kShift)));
  }

  void blend(const Rgb& color, double opacity) {
    cv::Mat coverage;  // 255: the whole pixel
    cv::resize(mask_, coverage, area_.size(), 0, 0, cv::INTER_AREA);
    const auto mixed = [](std::uint8_t below, std::uint8_t above, double fraction) {
      return static_cast<std::uint8_t>(std::lround(below + fraction * (above - below)));
    };
    for (int y = 0; y < area_.height; ++y) {
      for (int x = 0; x < area_.width; ++x) {
        const double fraction =
            std::clamp(opacity, 0.0, 1.0) * coverage.at<std::uint8_t>(y, x) / 255.0;
        if (fraction == 0.0) continue;
        Rgb& pixel = image_.at(area_.x + x, area_.y + y);
        pixel = {mixed(pixel.red, color.red, fraction), mixed(pixel.green, color.green, fraction),
                 mixed(pixel.blue, color.blue, fraction)};
      }
    }
  }

 private:
  RgbImage& image_;
  cv::Rect area_;
  cv::Mat mask_;
};

// Draws what lies within a box, band by band.
void draw(RgbImage& image, const Eigen::AlignedBox2d& box, const Rgb& color, double opacity,
          const std::function<void(Band&)>& paint) {
  const Eigen::AlignedBox2d picture(Vector2d::Zero(), Vector2d(image.width(), image.height()));
  const Eigen::AlignedBox2d seen = box.intersection(picture);
  if (seen.isEmpty()) return;  // also where there is no picture
  const Eigen::Array2i low = seen.min().array().floor().cast<int>();
  const Eigen::Array2i high = seen.max().array().ceil().cast<int>();
  for (int y = low.y(); y < high.y(); y += kBandHeight) {
    const cv::Rect area(low.x(), y, high.x() - low.x(), std::min(kBandHeight, high.y() - y));
    if (area.empty()) return;
    Band band(image, area);
    paint(band);
    band.blend(color, opacity);
  }
}

Eigen::AlignedBox2d box_around(const Vector2d& center, double reach) {
  return {center - Vector2d::Constant(reach), center + Vector2d::Constant(reach)};
}

// OpenCV draws lines that are 2 n wide with 2 n + 1.4.
int line_thickness(double pixels) {
  const double n = std::round((pixels * kFine - 1.4) / 2.0);
  return std::clamp(static_cast<int>(2.0 * n), 1, 32767);
}

// The parts of a stroke that come near the band, each segment once.
void paint_stroke(Band& band, const std::vector<Vector2d>& stroke, double width) {
  const int thickness = line_thickness(width);
  const auto meets = [&](const Vector2d& a, const Vector2d& b) {
    return std::max(a.y(), b.y()) + width > band.top() &&
           std::min(a.y(), b.y()) - width < band.bottom();
  };
  Vector2d last = stroke.front();
  bool down = false;  // the pen has drawn up to `last`
  for (const Vector2d& point : stroke) {
    if (!point.allFinite()) {
      down = false;
      continue;
    }
    if (down && (point - last).squaredNorm() < 0.01) continue;  // nothing that could be seen
    const Vector2d& from = down ? last : point;
    if (meets(from, point)) {
      cv::line(band.mask(), band.fixed(from), band.fixed(point), 255, thickness, cv::LINE_AA,
               kShift);
    }
    last = point;
    down = true;
  }
}

void draw_strokes(RgbImage& image, const Strokes& strokes, const Pen& pen) {
  Eigen::AlignedBox2d box;
  for (const auto& stroke : strokes) {
    for (const Vector2d& point : stroke) {
      if (point.allFinite()) box.extend(box_around(point, pen.width + 1.0));
    }
  }
  draw(image, box, pen.color, pen.opacity, [&](Band& band) {
    for (const auto& stroke : strokes) paint_stroke(band, stroke, pen.width);
  });
}

// Hershey's simple font: small letters are 14 units high, capitals 21, the base line is y = 0.
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kSmallLetter = 14.0;
constexpr double kLowest = -8.0;
constexpr double kHighest = 26.0;

// A sign that the font lacks or has no good one of: strokes, y up, and perhaps a letter of the
// font, smaller and raised.
struct Sign {
  std::string_view utf8;
  double advance;
  Strokes strokes;
  const char* letter = "";
  double letter_size = 1.0;
  double letter_base = 0.0;
};

Strokes ring(const Vector2d& center, double radius) {
  std::vector<cv::Point2d> points;
  cv::ellipse2Poly(cv::Point2d(center.x(), center.y()), cv::Size2d(radius, radius), 0, 0, 360, 15,
                   points);
  Strokes strokes(1);
  for (const cv::Point2d& point : points) strokes[0].emplace_back(point.x, point.y);
  return strokes;
}

const std::array<Sign, 9>& signs() {
  static const std::array<Sign, 9> kSigns = {{
      {" ", 9.0, {}},  // the font's own blanks and dashes are broad
      {"-", 18.0, {{{4, 9}, {14, 9}}}},
      {"\u00b0", 13.0, ring({6.0, 17.5}, 3.5)},
      {"\u00b1", 26.0, {{{5, 11}, {21, 11}}, {{13, 19}, {13, 3}}, {{5, -1}, {21, -1}}}},
      {"\u00d7", 24.0, {{{6, 2}, {18, 14}}, {{6, 14}, {18, 2}}}},
      {"\u00b2", 14.0, {}, "2", 0.6, 9.0},
      {"\u00b5", 19.0, {{{4, 4}, {4, -7}}}, "u"},
      {"\u03bc", 19.0, {{{4, 4}, {4, -7}}}, "u"},
      {"", 20.0, {{{4, 0}, {16, 0}, {16, 21}, {4, 21}, {4, 0}}}},  // any other
  }};
  return kSigns;
}

// Cuts the first sign off text that does not begin with one of the font.
const Sign& next_sign(std::string_view& text) {
  const auto& known = signs();
  const auto sign = std::find_if(known.begin(), known.end() - 1,
                                 [&](const Sign& s) { return text.starts_with(s.utf8); });
  do {
    text.remove_prefix(1);  // and the bytes that continue it
  } while (!text.empty() && (static_cast<unsigned char>(text[0]) & 0xc0) == 0x80);
  return *sign;
}

bool is_in_font(char c) {
  return c > ' ' && c < 127 && c != '-';
}

// Cuts the signs of the font that text begins with off it.
std::string next_run(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_in_font);
  std::string run(text.begin(), end);
  text.remove_prefix(run.size());
  return run;
}

// Pixels for one unit of the font: small letters are a whole number of pixels high, so that base
// line and top of the letters are sharp.
double unit_of(double size) {
  CHECK(std::isfinite(size) && size > 0.0);
  return std::max(1.0, std::round(0.7 * size * 14.0 / 21.0)) / kSmallLetter;
}

double advance_of(const std::string& run, double unit) {
  int baseline = 0;
  constexpr double kPrecision = 16.0;
  return unit * cv::getTextSize(run, kFont, kPrecision, 0, &baseline).width / kPrecision;
}

void paint_text(Band& band, Vector2d base, std::string_view text, double unit, double width) {
  const auto letters = [&](const std::string& run, const Vector2d& at, double scale) {
    const Vector2d steps = band.in_steps(at);
    const cv::Point origin(static_cast<int>(std::lround(steps.x())),
                           static_cast<int>(std::lround(steps.y())));
    cv::putText(band.mask(), run, origin, kFont, scale * kFine, 255, line_thickness(width),
                cv::LINE_AA);
  };
  while (!text.empty()) {
    if (is_in_font(text[0])) {
      const std::string run = next_run(text);
      letters(run, base, unit);
      base.x() += advance_of(run, unit);
      continue;
    }
    const Sign& sign = next_sign(text);
    for (std::vector<Vector2d> stroke : sign.strokes) {
      for (Vector2d& point : stroke) point = base + unit * Vector2d(point.x(), -point.y());
      paint_stroke(band, stroke, width);
    }
    letters(sign.letter, base - Vector2d(0.0, unit * sign.letter_base), unit * sign.letter_size);
    base.x() += unit * sign.advance;
  }
}

}  // namespace

void draw_line(RgbImage& image, const Vector2d& from, const Vector2d& to, const Pen& pen) {
  draw_polyline(image, {from, to}, pen);
}

void draw_polyline(RgbImage& image, const std::vector<Vector2d>& points, const Pen& pen) {
  if (!points.empty()) draw_strokes(image, {points}, pen);
}

void fill_disc(RgbImage& image, const Vector2d& center, double radius, const Rgb& color,
               double opacity) {
  if (!center.allFinite()) return;
  draw(image, box_around(center, radius + 1.0), color, opacity, [&](Band& band) {
    cv::circle(band.mask(), band.fixed(center), Band::fixed_length(radius), 255, cv::FILLED,
               cv::LINE_AA, kShift);
  });
}

void fill_rectangle(RgbImage& image, const Vector2d& corner, const Vector2d& opposite,
                    const Rgb& color, double opacity) {
  const Eigen::AlignedBox2d box(corner.cwiseMin(opposite), corner.cwiseMax(opposite));
  draw(image, box, color, opacity, [&](Band& band) {
    const auto step = [&](const Vector2d& p) {  // the first one behind an edge
      const Eigen::Array2d steps = (band.in_steps(p).array() + 0.5).round();
      return cv::Point(static_cast<int>(steps.x()), static_cast<int>(steps.y()));
    };
    const cv::Rect steps(step(box.min()), step(box.max()));
    band.mask()(steps & cv::Rect({}, band.mask().size())).setTo(255);
  });
}

double text_width(std::string_view text, double size) {
  double width = 0.0;
  while (!text.empty()) {
    width += is_in_font(text[0]) ? advance_of(next_run(text), unit_of(size))
                                 : unit_of(size) * next_sign(text).advance;
  }
  return width;
}

void draw_text(RgbImage& image, const Vector2d& start, std::string_view text,
               const TextStyle& style) {
  constexpr double kStrokeWidth = 0.09;  // of the size
  const double unit = unit_of(style.size);
  const Vector2d base = start.array().floor() + 0.5;  // a pixel's centre
  const double width = std::max(1.0, kStrokeWidth * style.size);
  const double edge = width + 2.0 * style.halo;
  const Eigen::AlignedBox2d box(
      base - Vector2d(edge, kHighest * unit + edge),
      base + Vector2d(text_width(text, style.size) + edge, edge - kLowest * unit));
  if (style.halo > 0.0) {
    draw(image, box, kWhite, 0.8, [&](Band& b) { paint_text(b, base, text, unit, edge); });
  }
  draw(image, box, style.color, 1.0, [&](Band& b) { paint_text(b, base, text, unit, width); });
}

void paste(const RgbImage& small, int scale, RgbImage& image, int x, int y) {
  if (small.pixels().empty()) return;
  const auto as_mat = [](const RgbImage& picture) {
    return cv::Mat(picture.height(), picture.width(), CV_8UC3,
                   const_cast<Rgb*>(picture.pixels().data()));
  };
  const cv::Size size(small.width() * scale, small.height() * scale);
  cv::Mat part = as_mat(image)(cv::Rect({x, y}, size));
  cv::resize(as_mat(small), part, size, 0, 0, cv::INTER_NEAREST);
}

}  // namespace mapbed
