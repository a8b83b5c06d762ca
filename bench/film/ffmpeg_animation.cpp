#include "bench/film/ffmpeg_animation.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include "bench/methods/work_folder.h"
#include "bench/process/child_process.h"
#include "core/check.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

const std::string kFilm = "film.mp4";
const std::string kMessages = "messages.txt";

// Frames as they are, to a file that plays everywhere and begins before all of it is there.
std::vector<std::string> command_of(const AnimationShape& shape) {
  return {"ffmpeg",
          "-nostdin",
          "-hide_banner",
          "-loglevel",
          "error",
          "-y",
          "-f",
          "rawvideo",
          "-pixel_format",
          "rgb24",
          "-video_size",
          fmt::format("{}x{}", shape.width, shape.height),
          "-framerate",
          fmt::format("{}", shape.rate),
          "-i",
          "pipe:0",
          "-pix_fmt",
          "yuv420p",
          "-movflags",
          "+faststart",
          "-metadata",
          std::string("comment=") + kAnimationMark,
          kFilm};
}

std::string last_line_of(const std::string& file) {
  const std::string text = read_text_file(file);
  const std::size_t end = text.find_last_not_of("\r\n ");
  if (end == std::string::npos) return "nothing";
  const std::size_t begin = text.find_last_of("\r\n", end);
  return in_quotes(text.substr(begin + 1, end - begin));
}

class FfmpegAnimation : public Animation {
 public:
  FfmpegAnimation(std::ostream& out, const AnimationShape& shape) : out_(out) {
    CHECK(shape.width % 2 == 0 && shape.height % 2 == 0);
    std::array<int, 2> ends{};
    // No pipe: writing into one that nobody reads any more would end this program.
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      throw InputError("there is no line to ffmpeg");
    }
    line_ = ends[0];
    program_ = std::thread([this, shape, input = ends[1]] {
      try {
        end_ = run_child({.words = command_of(shape),
                          .folder = folder_.path("."),
                          .messages = folder_.path(kMessages),
                          .leftover = folder_.path("."),
                          .input = input});
      } catch (const InputError& error) {
        not_started_ = error.what();
      }
      close(input);  // not before: what is sent would have nobody to go to
    });
  }
  ~FfmpegAnimation() override { wait(); }
  FfmpegAnimation(const FfmpegAnimation&) = delete;
  FfmpegAnimation& operator=(const FfmpegAnimation&) = delete;

  void add(const RgbImage& frame) override {
    const auto* bytes = reinterpret_cast<const char*>(frame.pixels().data());
    std::size_t left = frame.pixels().size() * sizeof(Rgb);
    while (left > 0) {
      const ssize_t sent = send(line_, bytes, left, MSG_NOSIGNAL);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) fail();  // it reads no more
      bytes += sent;
      left -= static_cast<std::size_t>(sent);
    }
  }

  void finish() override {
    wait();
    if (!not_started_.empty() || !end_.is_success()) fail();
    const std::ifstream film(folder_.path(kFilm), std::ios::binary);
    out_ << film.rdbuf();
  }

 private:
  void wait() {
    if (line_ >= 0) close(line_);
    line_ = -1;
    if (program_.joinable()) program_.join();
  }

  [[noreturn]] void fail() {
    wait();
    if (!not_started_.empty()) throw InputError(not_started_);
    throw InputError(
        fmt::format("ffmpeg {}; it said {}; name a file ending in .webp or .gif to do without it",
                    text_of(end_, 0.0), last_line_of(folder_.path(kMessages))));
  }

  std::ostream& out_;
  WorkFolder folder_;
  int line_ = -1;
  ChildEnd end_;             // once `program_` has ended
  std::string not_started_;  // the same; why
  std::thread program_;
};

}  // namespace

std::unique_ptr<Animation> ffmpeg_animation(std::ostream& out, const AnimationShape& shape) {
  return std::make_unique<FfmpegAnimation>(out, shape);
}

void check_ffmpeg_is_there(const std::string& path) {
  if (!program_in_path("ffmpeg").empty()) return;
  throw InputError({path}, "needs the program ffmpeg, which is not installed",
                   "apt-get install ffmpeg, or name a file ending in .webp or .gif");
}

}  // namespace mapbed
