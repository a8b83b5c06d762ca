#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "core/image/animation.h"

namespace mapbed {

// MP4, by the program ffmpeg where it is installed: it gets the frames on its standard input, and
// its file goes to `out` when it is finished. Width and height must be even. Throws InputError
// where it fails, with what it said.
std::unique_ptr<Animation> ffmpeg_animation(std::ostream& out, const AnimationShape& shape);

// Throws InputError, at `path`, where there is no ffmpeg.
void check_ffmpeg_is_there(const std::string& path);

}  // namespace mapbed
