#include "algorithms/field/surface_terms.h"

#include <cmath>
#include <limits>

#include "algorithms/field/mapped_line.h"

namespace mapbed {
namespace {

// Without branches, so that several hits are taken at a time.
MAPBED_INLINE_LOOP inline void squared_distances(const HitsOnSurface& hits, float* __restrict half,
                                                 float* __restrict x, float* __restrict y,
                                                 float* __restrict squared) {
  for (std::size_t i = 0; i < hits.count; ++i) {
    const MappedLine line(hits.doubled_x[i], hits.doubled_y[i]);
    half[i] = line.half;
    x[i] = line.x;
    y[i] = line.y;
    const float distance = line.squared_distance(hits.off_x[i], hits.off_y[i]);
    squared[i] = hits.found[i] != 0 ? distance : std::numeric_limits<float>::max();
  }
}

}  // namespace

void surface_terms(const HitsOnSurface& hits, const HitMixture& mixture, const float* weights,
                   SurfaceTerms& terms, Processor processor) {
  run(processor, [&hits, &terms, &mixture, weights]() MAPBED_INLINE_LOOP {
    HitsOnSurface::Floats half, along_x, along_y, squared, inlier;
    squared_distances(hits, half.data(), along_x.data(), along_y.data(), squared.data());
    for (std::size_t i = 0; i < hits.count; ++i) {
      const HitMixture::Value value = mixture.at(squared[i]);
      terms.log[i] = value.log;
      inlier[i] = value.inlier;
    }
    if (weights != nullptr) {
      for (std::size_t i = 0; i < hits.count; ++i) {
        terms.log[i] *= weights[i];
        inlier[i] *= weights[i];
      }
    }
    for (std::size_t i = 0; i < hits.count; ++i) {
      // Along its line a point may slide: it pulls across it only.
      const float nxx = inlier[i] * (1.0F - half[i] - along_x[i]);
      const float nxy = -inlier[i] * along_y[i];
      const float nyy = inlier[i] * (1.0F - half[i] + along_x[i]);
      const float pull_x = nxx * hits.off_x[i] + nxy * hits.off_y[i];
      const float pull_y = nxy * hits.off_x[i] + nyy * hits.off_y[i];
      // A turn moves the point by (-arm_y, arm_x).
      const float dx = hits.arm_x[i], dy = hits.arm_y[i];
      const float mx = dx * nxy - dy * nxx, my = dx * nyy - dy * nxy;
      terms.pull_x[i] = pull_x;
      terms.pull_y[i] = pull_y;
      terms.pull_turn[i] = dx * pull_y - dy * pull_x;
      terms.xx[i] = nxx;
      terms.xy[i] = nxy;
      terms.yy[i] = nyy;
      terms.x_turn[i] = mx;
      terms.y_turn[i] = my;
      terms.turn_turn[i] = dx * my - dy * mx;
    }
  });
}

}  // namespace mapbed
