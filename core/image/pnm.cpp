#include "core/image/pnm.h"

#include <algorithm>
#include <charconv>
#include <cstring>

#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr long kLongestSide = 1 << 20;
constexpr long kMostPixels = 1L << 27;

template <class Pixel>
std::string encoded(const char* magic, const Image<Pixel>& image) {
  std::string bytes = std::string(magic) + "\n" + std::to_string(image.width()) + " " +
                      std::to_string(image.height()) + "\n255\n";
  const std::size_t header = bytes.size();
  bytes.resize(header + image.pixels().size() * sizeof(Pixel));
  if (!image.pixels().empty()) {
    std::memcpy(bytes.data() + header, image.pixels().data(), bytes.size() - header);
  }
  return bytes;
}

// Reads numbers between blanks and comments, which go from '#' to the end of the line.
class NumberReader {
 public:
  NumberReader(std::string_view bytes, std::string name) : rest_(bytes), name_(std::move(name)) {}

  long next(const char* meaning, long low, long high) {
    skip_blanks();
    long value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc() || value < low || value > high) {
      throw InputError(SourceLocation{name_},
                       std::string(meaning) + " is missing or not between " + std::to_string(low) +
                           " and " + std::to_string(high),
                       "the picture is damaged, cut short or of another kind");
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  std::string_view rest() const { return rest_; }

 private:
  void skip_blanks() {
    while (!rest_.empty()) {
      if (rest_[0] == '#') {
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      } else if (std::string_view(" \t\r\n\v\f").find(rest_[0]) != std::string_view::npos) {
        rest_.remove_prefix(1);
      } else {
        return;
      }
    }
  }

  std::string_view rest_;
  std::string name_;
};

// Fills `channels` from text or bytes and stretches [0, most] to [0, 255].
void read_channels(NumberReader& reader, bool plain, long most, const std::string& name,
                   std::uint8_t* channels, std::size_t count) {
  if (!plain && reader.rest().size() < count + 1) {  // a single blank ends the header
    throw InputError(SourceLocation{name}, "ends in the middle of the picture", "it was cut short");
  }
  for (std::size_t i = 0; i < count; ++i) {
    const long value =
        plain ? reader.next("a pixel", 0, most) : static_cast<unsigned char>(reader.rest()[i + 1]);
    if (value > most)
      throw InputError(SourceLocation{name}, "has a pixel above the largest value it names");
    channels[i] = static_cast<std::uint8_t>((value * 255 + most / 2) / most);
  }
}

template <class Pixel>
Image<Pixel> decoded(std::string_view bytes, const std::string& name, char plain_digit,
                     char binary_digit, const char* kind) {
  const bool known =
      bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == plain_digit || bytes[1] == binary_digit);
  if (!known) throw InputError(SourceLocation{name}, std::string("is no ") + kind + " picture");
  const bool plain = bytes[1] == plain_digit;
  NumberReader reader(bytes.substr(2), name);
  const long width = reader.next("the width", 1, kLongestSide);
  const long height = reader.next("the height", 1, kLongestSide);
  const long most = reader.next("the largest value of a pixel", 1, 255);
  // A plain pixel takes at least two bytes, a binary one exactly its size: what the header promises
  // has to be there before memory is taken for it.
  const std::size_t count = static_cast<std::size_t>(width * height) * sizeof(Pixel);
  if (width * height > kMostPixels || reader.rest().size() < (plain ? count * 2 : count)) {
    throw InputError(SourceLocation{name}, "is not as long as its header says", "it was cut short");
  }
  Image<Pixel> image(static_cast<int>(width), static_cast<int>(height));
  read_channels(reader, plain, most, name, reinterpret_cast<std::uint8_t*>(image.pixels().data()),
                count);
  return image;
}

}  // namespace

std::string pgm_of(const GrayImage& image) {
  return encoded("P5", image);
}

std::string ppm_of(const RgbImage& image) {
  return encoded("P6", image);
}

void write_pgm(const std::string& path, const GrayImage& image) {
  write_file(path, encoded("P5", image));
}

void write_ppm(const std::string& path, const RgbImage& image) {
  write_file(path, encoded("P6", image));
}

GrayImage gray_from_pgm(std::string_view pgm, const std::string& name) {
  return decoded<std::uint8_t>(pgm, name, '2', '5', "PGM");
}

RgbImage rgb_from_ppm(std::string_view ppm, const std::string& name) {
  return decoded<Rgb>(ppm, name, '3', '6', "PPM");
}

GrayImage read_pgm(const std::string& path) {
  return gray_from_pgm(read_text_file(path), path);
}

RgbImage read_ppm(const std::string& path) {
  return rgb_from_ppm(read_text_file(path), path);
}

}  // namespace mapbed
