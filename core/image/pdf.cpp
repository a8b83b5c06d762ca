#include "core/image/pdf.h"

#include <cstdint>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/check.h"
#include "core/image/png.h"

namespace mapbed {
namespace {

constexpr double kPointsPerMillimeter = 72.0 / 25.4;

std::size_t big_endian(std::string_view bytes) {
  std::size_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

// The compressed rows of a PNG file: what its IDAT chunks hold is what PDF calls FlateDecode with
// the predictors of PNG.
std::string compressed_rows(std::string_view png) {
  constexpr std::size_t kSignature = 8, kHead = 8, kChecksum = 4;  // [bytes]
  std::string rows;
  png.remove_prefix(kSignature);
  while (png.size() >= kHead) {
    const std::size_t length = big_endian(png);
    if (png.substr(4, 4) == "IDAT") rows += png.substr(kHead, length);
    png.remove_prefix(kHead + length + kChecksum);
  }
  CHECK(!rows.empty());
  return rows;
}

std::string stream(const std::string& entries, const std::string& content) {
  return fmt::format("<< {} /Length {} >>\nstream\n{}\nendstream", entries, content.size(),
                     content);
}

// The file with its table of where each object begins; they are numbered from 1, the first one is
// the catalog.
std::string file_of(const std::vector<std::string>& objects) {
  std::string file = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";  // bytes that say it is no text
  std::string table = fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects.size() + 1);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    table += fmt::format("{:010} 00000 n \n", file.size());
    file += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
  }
  const std::size_t begin = file.size();
  return file + table +
         fmt::format("trailer\n<< /Size {} /Root 1 0 R >>\nstartxref\n{}\n%%EOF\n",
                     objects.size() + 1, begin);
}

}  // namespace

std::string pdf_of(const RgbImage& image, double width) {
  CHECK(width > 0.0);
  const double points = width * kPointsPerMillimeter;
  const std::string size =
      fmt::format("{:.2f} {:.2f}", points, points * image.height() / image.width());
  const std::string shape = fmt::format(
      "/Type /XObject /Subtype /Image /Width {0} /Height {1} /ColorSpace /DeviceRGB "
      "/BitsPerComponent 8 /Filter /FlateDecode "
      "/DecodeParms << /Predictor 15 /Colors 3 /BitsPerComponent 8 /Columns {0} >>",
      image.width(), image.height());
  const std::string page = fmt::format(
      "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {}] /Contents 4 0 R "
      "/Resources << /XObject << /Map 5 0 R >> >> >>",
      size);
  const std::string drawing =
      fmt::format("q {} 0 0 {} 0 0 cm /Map Do Q", size.substr(0, size.find(' ')),
                  size.substr(size.find(' ') + 1));
  return file_of({"<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
                  page, stream("", drawing), stream(shape, compressed_rows(png_of(image)))});
}

}  // namespace mapbed
