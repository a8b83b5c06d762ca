#pragma once

#include <functional>
#include <string>

#include "bench/film/course.h"
#include "core/interrupted.h"

namespace mapbed {

struct FilmOptions {
  double rate = 20.0;      // frames a second
  double speed = 1.0;      // times real time
  double from = 0.0;       // [s] since the log's start
  double to = 0.0;         // [s] the same
  int longest_side = 800;  // [pixels] of the map's part
};

inline constexpr double kStillSeconds = 2.0;  // that the last frame stays

// Whether a file of this name is a film: .gif, .webp or .mp4.
bool is_film(const std::string& path);

// Throws InputError where a film of this name cannot be made here: without ffmpeg no .mp4.
void check_film_can_be_made(const std::string& path);

// Whether the file at `path` is a film that this wrote.
bool is_film_of_ours(const std::string& path);

struct FilmMade {
  int width = 0, height = 0;  // [pixels]
  int frames = 0;
  double seconds = 0.0;
};

// The file is there complete or not at all. `tell(done, total)` hears of frames. Throws Interrupted
// where `goes_on` says no, and InputError where it cannot be written.
FilmMade write_film(const Course& course, const FilmOptions& options, const std::string& path,
                    const std::function<void(std::size_t, std::size_t)>& tell,
                    const GoesOn& goes_on);

}  // namespace mapbed
