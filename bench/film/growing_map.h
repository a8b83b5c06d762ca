#pragma once

#include <cstddef>
#include <map>

#include "algorithms/grid/counting_map.h"
#include "algorithms/grid/grid_frame.h"
#include "core/geometry/pose2.h"
#include "core/image/image.h"
#include "core/labels/beam_labels.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// A map by the counting model that scans are put into, moved in and taken out of again, as the path
// is believed to have been another one; as a picture with one pixel a cell.
class GrowingMap {
 public:
  // Cell (0, 0) of the frame is the picture's lower left pixel.
  GrowingMap(const GridFrame& frame, int width, int height);

  // The scan of that number is at this pose, wherever it was before. Poses that differ by less than
  // a part of a cell are the same. With labels, dynamic beams end in nothing, as in build_map().
  void put(std::size_t number, const LaserScan& scan, const Pose2& map_from_robot,
           const ScanLabels* labels = nullptr);

  // Free is white, occupied black, unknown grey-blue.
  const RgbImage& picture();

 private:
  void count(const LaserScan& scan, const Pose2& map_from_robot, const ScanLabels* labels,
             std::uint32_t sign);
  bool is_same(const Pose2& a, const Pose2& b) const;

  GridFrame frame_;
  Image<CountingMap::Cell> cells_;
  RgbImage picture_;
  std::map<std::size_t, Pose2> poses_;
  CellBox changed_;  // since the picture was drawn
};

}  // namespace mapbed
