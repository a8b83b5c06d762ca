#pragma once

#include <cstring>

// Products of dense matrices, column by column, written once and compiled for several processors:
// only for sources that are compiled with options of their own, so all of it is local to them. Each
// entry is summed in the same order whatever the vectors' width, so that all give the same bytes.

namespace mapbed {
namespace {

#if defined(__AVX2__)
constexpr int kLanes = 4;
#else
constexpr int kLanes = 2;
#endif
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));

inline Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(Lanes));
  return lanes;
}

// A tile of c: `rows` of it, up to kVectors * kLanes, and kColumns. Reads a's rows beyond `rows`
// too.
template <int kVectors, int kColumns>
inline void subtract_tile(int rows, int depth, const double* a, int a_stride, const double* b,
                          int b_stride, double* c, int c_stride) {
  Lanes sum[kColumns][kVectors] = {};
  for (int k = 0; k < depth; ++k) {
    Lanes of_a[kVectors];
#pragma GCC unroll 4
    for (int v = 0; v < kVectors; ++v) of_a[v] = load(a + v * kLanes);
#pragma GCC unroll 8
    for (int j = 0; j < kColumns; ++j) {
#pragma GCC unroll 4
      for (int v = 0; v < kVectors; ++v) sum[j][v] += of_a[v] * b[j];
    }
    a += a_stride;
    b += b_stride;
  }
  for (int j = 0; j < kColumns; ++j) {
    double* column = c + static_cast<long>(j) * c_stride;
    if (rows == kVectors * kLanes) {
      for (int v = 0; v < kVectors; ++v) {
        const Lanes result = load(column + v * kLanes) - sum[j][v];
        std::memcpy(column + v * kLanes, &result, sizeof(Lanes));
      }
    } else {
      double sums[kVectors * kLanes];
      std::memcpy(sums, sum[j], sizeof(sums));
      for (int r = 0; r < rows; ++r) column[r] -= sums[r];
    }
  }
}

template <int kColumns>
inline void subtract_columns(int rows, int depth, const double* a, int a_stride, const double* b,
                             int b_stride, double* c, int c_stride) {
  for (int row = 0; row < rows; row += 2 * kLanes) {
    const int left = rows - row;
    if (left > kLanes) {
      subtract_tile<2, kColumns>(left < 2 * kLanes ? left : 2 * kLanes, depth, a + row, a_stride, b,
                                 b_stride, c + row, c_stride);
    } else {
      subtract_tile<1, kColumns>(left, depth, a + row, a_stride, b, b_stride, c + row, c_stride);
    }
  }
}

// c -= a b', of c the lower triangle where is_lower.
inline void subtract_product_tiled(int rows, int columns, int depth, const double* a, int a_stride,
                                   const double* b, int b_stride, double* c, int c_stride,
                                   bool is_lower) {
  for (int j = 0; j < columns;) {
    const int first = is_lower ? j : 0;
    const double* a_rows = a + first;
    double* c_tile = c + static_cast<long>(j) * c_stride + first;
    const int left = columns - j;
    if (left >= 6) {
      subtract_columns<6>(rows - first, depth, a_rows, a_stride, b + j, b_stride, c_tile, c_stride);
      j += 6;
    } else if (left >= 3) {
      subtract_columns<3>(rows - first, depth, a_rows, a_stride, b + j, b_stride, c_tile, c_stride);
      j += 3;
    } else {
      subtract_columns<1>(rows - first, depth, a_rows, a_stride, b + j, b_stride, c_tile, c_stride);
      j += 1;
    }
  }
}

}  // namespace
}  // namespace mapbed
