#include "algorithms/pose_graph/fronts/dense_products.h"
#include "algorithms/pose_graph/fronts/dense_tiles.h"

namespace mapbed {

void subtract_product_any(const ProductSize& size, const double* a, int a_stride, const double* b,
                          int b_stride, double* c, int c_stride) {
  subtract_product_tiled(size.rows, size.columns, size.depth, a, a_stride, b, b_stride, c, c_stride,
                         true);
}

}  // namespace mapbed
