#include "core/image/png.h"

#include <cstring>

#include <png.h>

#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 27;

// libpng's description of a picture, which has to be freed however reading or writing ends.
struct Description {
  png_image image;
  Description() {
    std::memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
  }
  ~Description() { png_image_free(&image); }
  Description(const Description&) = delete;
  Description& operator=(const Description&) = delete;
};

template <class Pixel>
constexpr png_uint_32 kFormat = sizeof(Pixel) == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
static_assert(sizeof(Rgb) == 3);

template <class Pixel>
std::string encoded(const Image<Pixel>& picture) {
  CHECK(!picture.pixels().empty());
  Description png;
  png.image.width = static_cast<png_uint_32>(picture.width());
  png.image.height = static_cast<png_uint_32>(picture.height());
  png.image.format = kFormat<Pixel>;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png.image), '\0');  // an upper bound
  png_alloc_size_t size = bytes.size();
  const int ok = png_image_write_to_memory(&png.image, bytes.data(), &size, 0,
                                           picture.pixels().data(), 0, nullptr);
  CHECK(ok != 0);
  bytes.resize(size);
  return bytes;
}

template <class Pixel>
Image<Pixel> decoded(std::string_view bytes, const std::string& name) {
  const auto fail = [&](const Description& png) {
    throw InputError(SourceLocation{name},
                     "cannot be read as a PNG picture (" + std::string(png.image.message) + ")",
                     "it is damaged, cut short or of another kind");
  };
  Description png;
  if (png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()) == 0) fail(png);
  if (std::uint64_t{png.image.width} * png.image.height > kMostPixels) {
    throw InputError(SourceLocation{name},
                     "is a picture of " + std::to_string(png.image.width) + " x " +
                         std::to_string(png.image.height) + " pixels",
                     "that is more than can be used here");
  }
  png.image.format = kFormat<Pixel>;
  png.image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  Image<Pixel> picture(static_cast<int>(png.image.width), static_cast<int>(png.image.height));
  const png_color white{255, 255, 255};
  if (png_image_finish_read(&png.image, &white, picture.pixels().data(), 0, nullptr) == 0)
    fail(png);
  return picture;
}

}  // namespace

std::string png_of(const GrayImage& image) {
  return encoded(image);
}

std::string png_of(const RgbImage& image) {
  return encoded(image);
}

void write_png(const std::string& path, const GrayImage& image) {
  write_file(path, encoded(image));
}

void write_png(const std::string& path, const RgbImage& image) {
  write_file(path, encoded(image));
}

GrayImage gray_from_png(std::string_view png, const std::string& name) {
  return decoded<std::uint8_t>(png, name);
}

RgbImage rgb_from_png(std::string_view png, const std::string& name) {
  return decoded<Rgb>(png, name);
}

GrayImage read_gray_png(const std::string& path) {
  return gray_from_png(read_text_file(path), path);
}

RgbImage read_rgb_png(const std::string& path) {
  return rgb_from_png(read_text_file(path), path);
}

}  // namespace mapbed
