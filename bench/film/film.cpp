#include "bench/film/film.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "bench/film/ffmpeg_animation.h"
#include "bench/film/film_painter.h"
#include "core/file/atomic_file.h"
#include "core/image/animation.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

std::unique_ptr<Animation> animation_for(const std::string& path, std::ostream& out,
                                         const AnimationShape& shape) {
  if (ending_of(path) == ".gif") return gif_animation(out, shape, FilmPainter::palette());
  if (ending_of(path) == ".webp") return webp_animation(out, shape, FilmPainter::palette());
  return ffmpeg_animation(out, shape);
}

}  // namespace

bool is_film(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".gif" || ending == ".webp" || ending == ".mp4";
}

void check_film_can_be_made(const std::string& path) {
  if (ending_of(path) == ".mp4") check_ffmpeg_is_there(path);
}

bool is_film_of_ours(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string content(std::istreambuf_iterator<char>(file), {});
  return content.find(kAnimationMark) != std::string::npos;
}

FilmMade write_film(const Course& course, const FilmOptions& options, const std::string& path,
                    const std::function<void(std::size_t, std::size_t)>& tell,
                    const GoesOn& goes_on) {
  FilmPainter painter(course, options.longest_side, options.speed);
  const double length = std::max(0.0, options.to - options.from) / options.speed;  // [s] of film
  const auto moving = 1 + static_cast<std::size_t>(std::floor(length * options.rate));
  const auto still = static_cast<std::size_t>(std::ceil(kStillSeconds * options.rate));
  const std::size_t total = moving + still;
  AtomicFile file(path);
  const auto film =
      animation_for(path, file.stream(), {painter.width(), painter.height(), options.rate});
  for (std::size_t i = 0; i < moving; ++i) {
    throw_unless(goes_on);
    const double since_start = static_cast<double>(i) / options.rate * options.speed;
    film->add(painter.frame_at(course.start + options.from + since_start));
    tell(i + 1, total);
  }
  const RgbImage& last = painter.last_frame();
  for (std::size_t i = 0; i < still; ++i) {
    throw_unless(goes_on);
    film->add(last);
    tell(moving + i + 1, total);
  }
  film->finish();
  file.commit();
  return {painter.width(), painter.height(), static_cast<int>(total),
          static_cast<double>(total) / options.rate};
}

}  // namespace mapbed
