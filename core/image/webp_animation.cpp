#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include <webp/encode.h>
#include <webp/mux.h>

#include "core/check.h"
#include "core/image/animation.h"
#include "core/image/palette.h"

namespace mapbed {
namespace {

// Of 6 and of 100: more takes much longer and makes files little smaller.
constexpr int kMethod = 3;
constexpr float kEffort = 50.0F;

// Who made it, as pictures say it.
std::string packet() {
  return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
         "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description "
         "xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\" xmp:CreatorTool=\"" +
         std::string(kAnimationMark) + "\"/></rdf:RDF></x:xmpmeta>";
}

class WebpAnimation : public Animation {
 public:
  WebpAnimation(std::ostream& out, const AnimationShape& shape, const std::vector<Rgb>& palette)
      : out_(out), shape_(shape), palette_(palette) {
    WebPAnimEncoderOptions options;
    CHECK(WebPAnimEncoderOptionsInit(&options) != 0 && WebPConfigInit(&config_) != 0);
    options.kmin = options.kmax = 0;  // each frame as what differs from the one before
    config_.lossless = 1;
    config_.method = kMethod;
    config_.quality = kEffort;
    encoder_ = WebPAnimEncoderNew(shape.width, shape.height, &options);
    CHECK(encoder_ != nullptr);
  }
  ~WebpAnimation() override { WebPAnimEncoderDelete(encoder_); }
  WebpAnimation(const WebpAnimation&) = delete;
  WebpAnimation& operator=(const WebpAnimation&) = delete;

  void add(const RgbImage& frame) override {
    WebPPicture picture;
    CHECK(WebPPictureInit(&picture) != 0);
    picture.use_argb = 1;
    picture.width = frame.width();
    picture.height = frame.height();
    std::vector<Rgb> pixels(frame.pixels().size());
    std::transform(frame.pixels().begin(), frame.pixels().end(), pixels.begin(),
                   [this](const Rgb& color) { return palette_.nearest(color); });
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(pixels.data());
    const bool ok = WebPPictureImportRGB(&picture, bytes, 3 * frame.width()) != 0 &&
                    WebPAnimEncoderAdd(encoder_, &picture, milliseconds(), &config_) != 0;
    WebPPictureFree(&picture);
    if (!ok) throw std::bad_alloc();  // nothing else can go wrong
    ++frames_;
  }

  void finish() override {
    WebPData film;
    WebPDataInit(&film);
    const bool ok = WebPAnimEncoderAdd(encoder_, nullptr, milliseconds(), nullptr) != 0 &&
                    WebPAnimEncoderAssemble(encoder_, &film) != 0 && mark(film);
    out_.write(reinterpret_cast<const char*>(film.bytes), static_cast<std::streamsize>(film.size));
    WebPDataClear(&film);
    if (!ok) throw std::bad_alloc();
  }

 private:
  int milliseconds() const {  // when the next frame begins
    return static_cast<int>(std::lround(1000.0 * static_cast<double>(frames_) / shape_.rate));
  }

  // Puts the mark in; the encoder itself has no place for it.
  static bool mark(WebPData& film) {
    WebPMux* mux = WebPMuxCreate(&film, 1);
    if (mux == nullptr) return false;
    const std::string text = packet();
    const WebPData chunk{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
    WebPDataClear(&film);
    const bool ok = WebPMuxSetChunk(mux, "XMP ", &chunk, 1) == WEBP_MUX_OK &&
                    WebPMuxAssemble(mux, &film) == WEBP_MUX_OK;
    WebPMuxDelete(mux);
    return ok;
  }

  std::ostream& out_;
  AnimationShape shape_;
  Palette palette_;
  WebPConfig config_;
  WebPAnimEncoder* encoder_ = nullptr;
  long frames_ = 0;
};

}  // namespace

std::unique_ptr<Animation> webp_animation(std::ostream& out, const AnimationShape& shape,
                                          const std::vector<Rgb>& palette) {
  return std::make_unique<WebpAnimation>(out, shape, palette);
}

}  // namespace mapbed
