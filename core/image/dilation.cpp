#include "core/image/dilation.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace mapbed {

GrayImage dilated(const GrayImage& marks, int reach) {
  CHECK(reach >= 0);
  GrayImage near(marks.width(), marks.height());
  if (near.pixels().empty()) return near;
  const cv::Mat ones(marks.height(), marks.width(), CV_8U,
                     const_cast<std::uint8_t*>(marks.pixels().data()));
  cv::Mat sums;  // at (y, x): of all pixels above y and left of x
  cv::integral(ones, sums, CV_32S);
  for (int y = 0; y < near.height(); ++y) {
    const int* above = sums.ptr<int>(std::max(0, y - reach));
    const int* below = sums.ptr<int>(std::min(near.height(), y + reach + 1));
    for (int x = 0; x < near.width(); ++x) {
      const int left = std::max(0, x - reach);
      const int right = std::min(near.width(), x + reach + 1);
      near.at(x, y) = below[right] - below[left] - above[right] + above[left] > 0 ? 1 : 0;
    }
  }
  return near;
}

}  // namespace mapbed
