#pragma once

namespace mapbed {

struct ProductSize {
  int rows = 0, columns = 0;  // of c
  int depth = 0;              // columns of a and b
};

// c -= a b' in the lower triangle of c, by columns that stand `stride` apart; up to kSlack numbers
// beyond the end of a are read. The same bytes by each; that for AVX2 is the other where the
// compiler has none.
void subtract_product_any(const ProductSize& size, const double* a, int a_stride, const double* b,
                          int b_stride, double* c, int c_stride);
void subtract_product_avx2(const ProductSize& size, const double* a, int a_stride, const double* b,
                           int b_stride, double* c, int c_stride);

}  // namespace mapbed
