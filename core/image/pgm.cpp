#include "core/image/pgm.h"

#include <algorithm>
#include <charconv>

#include "core/file/atomic_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr long kLongestSide = 1 << 20;
constexpr long kMostPixels = 1L << 26;

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

// One byte a pixel, or two, the high one first.
void read_binary(std::string_view bytes, const std::string& name, Samples& picture) {
  const bool wide = picture.white > 255;
  std::size_t at = 0;
  for (std::uint16_t& value : picture.values) {
    int sample = static_cast<unsigned char>(bytes[at++]);
    if (wide) sample = sample * 256 + static_cast<unsigned char>(bytes[at++]);
    if (sample > picture.white)
      throw InputError(SourceLocation{name}, "has a pixel above the largest value it names");
    value = static_cast<std::uint16_t>(sample);
  }
}

std::string header_of(const GrayImage& image) {
  return "P5\n" + std::to_string(image.width()) + " " + std::to_string(image.height()) + "\n255\n";
}

}  // namespace

std::string pgm_of(const GrayImage& image) {
  std::string bytes = header_of(image);
  bytes.append(image.pixels().begin(), image.pixels().end());
  return bytes;
}

// Without a copy of the pixels.
void write_pgm(const std::string& path, const GrayImage& image) {
  AtomicFile file(path);
  file.stream() << header_of(image);
  file.stream().write(reinterpret_cast<const char*>(image.pixels().data()),
                      static_cast<std::streamsize>(image.pixels().size()));
  file.commit();
}

Samples samples_from_pgm(std::string_view pgm, const std::string& name) {
  const bool known = pgm.size() > 2 && pgm[0] == 'P' && (pgm[1] == '2' || pgm[1] == '5');
  if (!known) throw InputError(SourceLocation{name}, "is not a PGM picture");
  const bool plain = pgm[1] == '2';
  NumberReader reader(pgm.substr(2), name);
  const long width = reader.next("the width", 1, kLongestSide);
  const long height = reader.next("the height", 1, kLongestSide);
  const long white = reader.next("the largest value of a pixel", 1, 65535);
  // A plain pixel takes at least two bytes, a binary one its size, after the single blank that ends
  // the header: what the header promises has to be there before memory is taken for it.
  const std::size_t count = static_cast<std::size_t>(width * height);
  const std::size_t least = plain || white > 255 ? count * 2 : count;
  if (width * height > kMostPixels || reader.rest().size() < least + (plain ? 0 : 1)) {
    throw InputError(SourceLocation{name}, "is not as long as its header says", "it was cut short");
  }
  Samples picture{.width = static_cast<int>(width),
                  .height = static_cast<int>(height),
                  .white = static_cast<int>(white),
                  .values = std::vector<std::uint16_t>(count)};
  if (plain) {
    for (std::uint16_t& value : picture.values) {
      value = static_cast<std::uint16_t>(reader.next("a pixel", 0, white));
    }
  } else {
    read_binary(reader.rest().substr(1), name, picture);
  }
  return picture;
}

}  // namespace mapbed
