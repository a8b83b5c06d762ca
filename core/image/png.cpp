#include "core/image/png.h"

#include <csetjmp>
#include <cstring>

#include <png.h>

#include "core/file/atomic_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;

template <class Pixel>
constexpr png_uint_32 kFormat = sizeof(Pixel) == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
static_assert(sizeof(Rgb) == 3);

template <class Pixel>
std::string encoded(const Image<Pixel>& picture) {
  CHECK(!picture.pixels().empty());
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(picture.width());
  png.height = static_cast<png_uint_32>(picture.height());
  png.format = kFormat<Pixel>;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');  // an upper bound
  png_alloc_size_t size = bytes.size();
  const int ok =
      png_image_write_to_memory(&png, bytes.data(), &size, 0, picture.pixels().data(), 0, nullptr);
  png_image_free(&png);
  CHECK(ok != 0);
  bytes.resize(size);
  return bytes;
}

// libpng's reader, freed however reading ends. It leaves a step that fails by longjmp, so steps own
// nothing; they return false then, and `failure` says why.
class Decoder {
 public:
  explicit Decoder(std::string_view bytes)
      : rest_(bytes),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
    CHECK(png_ != nullptr && info_ != nullptr);
    png_set_read_fn(png_, this, read);
  }
  ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_info(png_, info_);
    return true;
  }

  // Palettes become colours, 1, 2 and 4 bits 8, a transparent colour an alpha channel.
  bool prepare_rows() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_expand(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  bool read_rows(png_bytep* rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  std::uint32_t width() const { return png_get_image_width(png_, info_); }
  std::uint32_t height() const { return png_get_image_height(png_, info_); }
  int channels() const { return png_get_channels(png_, info_); }
  int bits() const { return png_get_bit_depth(png_, info_); }
  std::size_t row_size() const { return png_get_rowbytes(png_, info_); }
  const char* failure() const { return failure_; }

 private:
  static void read(png_structp png, png_bytep to, std::size_t count) {
    std::string_view& rest = static_cast<Decoder*>(png_get_io_ptr(png))->rest_;
    if (rest.size() < count) png_error(png, "it ends too early");
    std::memcpy(to, rest.data(), count);
    rest.remove_prefix(count);
  }
  [[noreturn]] static void fail(png_structp png, png_const_charp message) {
    char(&failure)[64] = static_cast<Decoder*>(png_get_error_ptr(png))->failure_;
    std::strncpy(failure, message, sizeof failure - 1);
    png_longjmp(png, 1);
  }
  static void ignore(png_structp, png_const_charp) {}

  std::string_view rest_;
  char failure_[64] = {};
  png_structp png_;
  png_infop info_;
};

// Rows of one or two bytes a value, the high one first.
std::vector<std::uint16_t> values_of(const std::vector<png_byte>& bytes, bool wide) {
  if (!wide) return {bytes.begin(), bytes.end()};
  std::vector<std::uint16_t> values(bytes.size() / 2);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<std::uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]);
  }
  return values;
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

Samples samples_from_png(std::string_view png, const std::string& name) {
  Decoder decoder(png);
  const auto fail = [&] {
    throw InputError(SourceLocation{name},
                     "cannot be read as a PNG picture (" + std::string(decoder.failure()) + ")",
                     "it is damaged, cut short or of another kind");
  };
  if (!decoder.read_header()) fail();
  const std::uint32_t width = decoder.width();
  const std::uint32_t height = decoder.height();
  if (std::uint64_t{width} * height > kMostPixels) {
    throw InputError(
        SourceLocation{name},
        "is a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
        "that is more than can be used here");
  }
  if (!decoder.prepare_rows()) fail();
  std::vector<png_byte> bytes(decoder.row_size() * height);
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = bytes.data() + y * decoder.row_size();
  if (!decoder.read_rows(rows.data())) fail();
  const bool wide = decoder.bits() == 16;
  return {.width = static_cast<int>(width),
          .height = static_cast<int>(height),
          .channels = decoder.channels(),
          .white = wide ? 65535 : 255,
          .values = values_of(bytes, wide)};
}

}  // namespace mapbed
