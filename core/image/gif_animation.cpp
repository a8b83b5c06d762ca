#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <gif_lib.h>

#include "core/check.h"
#include "core/image/animation.h"
#include "core/image/palette.h"

namespace mapbed {
namespace {

constexpr int kColors = 256;
constexpr GifByteType kUnchanged = kColors - 1;  // the index of what shows through

int write_bytes(GifFileType* gif, const GifByteType* bytes, int size) {
  auto& out = *static_cast<std::ostream*>(gif->UserData);
  out.write(reinterpret_cast<const char*>(bytes), size);
  return size;  // what the stream could not take is told when the file is committed
}

class GifAnimation : public Animation {
 public:
  GifAnimation(std::ostream& out, const AnimationShape& shape, const std::vector<Rgb>& palette)
      : shape_(shape), palette_(palette), gif_(EGifOpen(&out, write_bytes, nullptr)) {
    CHECK(gif_ != nullptr && !palette.empty() && palette.size() < kColors);
    std::array<GifColorType, kColors> colors{};
    for (std::size_t i = 0; i < palette.size(); ++i) {
      colors[i] = {palette[i].red, palette[i].green, palette[i].blue};
    }
    ColorMapObject* map = GifMakeMapObject(kColors, colors.data());
    EGifSetGifVersion(gif_, true);
    EGifPutScreenDesc(gif_, shape.width, shape.height, 8, 0, map);
    GifFreeMapObject(map);
    put_forever();
    EGifPutComment(gif_, kAnimationMark);
  }
  ~GifAnimation() override {
    if (gif_ != nullptr) EGifCloseFile(gif_, nullptr);
  }
  GifAnimation(const GifAnimation&) = delete;
  GifAnimation& operator=(const GifAnimation&) = delete;

  // A frame is written once it is known for how long it stays.
  void add(const RgbImage& frame) override {
    CHECK(frame.width() == shape_.width && frame.height() == shape_.height);
    if (frames_ > 0 && frame == last_) {
      ++frames_;
      return;
    }
    put_waiting();
    waiting_ = changed_part(frame);
    last_ = frame;
    ++frames_;
  }

  void finish() override {
    put_waiting();
    EGifCloseFile(gif_, nullptr);
    gif_ = nullptr;
  }

 private:
  struct Part {
    int left = 0, top = 0, width = 0, height = 0;
    std::vector<GifByteType> indices = {};
  };

  // Of which the colours differ in the film, too.
  Part changed_part(const RgbImage& frame) {
    std::vector<GifByteType> now(frame.pixels().size());
    std::transform(frame.pixels().begin(), frame.pixels().end(), now.begin(),
                   [this](const Rgb& color) { return palette_.index_of(color); });
    Part part{0, 0, shape_.width, shape_.height};
    if (shown_.empty()) {
      part.indices = now;
    } else {
      part = part_between(shown_, now);
    }
    shown_ = std::move(now);
    return part;
  }

  Part part_between(const std::vector<GifByteType>& before,
                    const std::vector<GifByteType>& now) const {
    int left = shape_.width, top = shape_.height, right = 0, bottom = 0;
    for (int y = 0; y < shape_.height; ++y) {
      for (int x = 0; x < shape_.width; ++x) {
        const auto at = static_cast<std::size_t>(y * shape_.width + x);
        if (before[at] == now[at]) continue;
        left = std::min(left, x), right = std::max(right, x + 1);
        top = std::min(top, y), bottom = y + 1;
      }
    }
    if (right <= left) return {0, 0, 1, 1, {kUnchanged}};
    Part part{left, top, right - left, bottom - top};
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const auto at = static_cast<std::size_t>(y * shape_.width + x);
        part.indices.push_back(before[at] == now[at] ? kUnchanged : now[at]);
      }
    }
    return part;
  }

  void put_forever() {
    const std::array<GifByteType, 3> forever{1, 0, 0};
    EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE);
    EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0");
    EGifPutExtensionBlock(gif_, static_cast<int>(forever.size()), forever.data());
    EGifPutExtensionTrailer(gif_);
  }

  // Hundredths of a second, so that the film as a whole has its length.
  void put_waiting() {
    if (!waiting_) return;
    const long until = std::lround(100.0 * static_cast<double>(frames_) / shape_.rate);
    GraphicsControlBlock control{DISPOSE_DO_NOT, false, static_cast<int>(until - told_),
                                 is_first_ ? NO_TRANSPARENT_COLOR : int{kUnchanged}};
    told_ = until;
    is_first_ = false;
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(bytes.size()), bytes.data());
    Part& part = *waiting_;
    EGifPutImageDesc(gif_, part.left, part.top, part.width, part.height, false, nullptr);
    for (int y = 0; y < part.height; ++y) {
      EGifPutLine(gif_, part.indices.data() + static_cast<std::ptrdiff_t>(y) * part.width,
                  part.width);
    }
    waiting_.reset();
  }

  AnimationShape shape_;
  Palette palette_;
  GifFileType* gif_;
  RgbImage last_;
  std::vector<GifByteType> shown_;  // indices of the last frame
  std::optional<Part> waiting_;     // of which it is not known how long it stays
  long frames_ = 0;
  long told_ = 0;  // [s / 100]
  bool is_first_ = true;
};

}  // namespace

std::unique_ptr<Animation> gif_animation(std::ostream& out, const AnimationShape& shape,
                                         const std::vector<Rgb>& palette) {
  return std::make_unique<GifAnimation>(out, shape, palette);
}

}  // namespace mapbed
