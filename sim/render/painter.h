#pragma once

#include <memory>

#include "core/image/image.h"
#include "sim/render/camera.h"
#include "sim/render/gl_context.h"
#include "sim/render/painted_mesh.h"

namespace mapbed {

struct CanvasOptions {
  int width = 1280;  // [pixels]
  int height = 960;  // [pixels]
  int samples = 3;   // a pixel is the mean of samples x samples
  bool shadows = true;
  Eigen::Vector3d background = {1.0, 1.0, 1.0};
};

// Draws triangles with sunlight, its shadows and light from the sky. Holds the OpenGL context:
// making one costs more than drawing a small picture with it.
class Painter {
 public:
  explicit Painter(GlBackend backend = GlBackend::any);  // throws InputError, see GlContext
  ~Painter();

  RgbImage draw(const PaintedMesh& mesh, const Camera& camera, const CanvasOptions& options);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
