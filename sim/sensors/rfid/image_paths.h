#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/sensors/rfid/mirror_faces.h"

namespace mapbed {

// A way of a wave, straight between its points: from an antenna by mirrors to a tag.
struct RadioPath {
  static constexpr int kMostMirrors = 2;

  int mirrors = 0;
  std::array<int, kMostMirrors> faces = {};              // from the antenna on
  std::array<Eigen::Vector3d, 2 + kMostMirrors> points;  // antenna, mirrors, tag
  double length = 0.0;                                   // [m]

  const Eigen::Vector3d& end() const { return points[static_cast<std::size_t>(mirrors) + 1]; }
};

// Where a tag seems to be behind one mirror or two.
struct MirrorImage {
  int mirrors = 1;
  std::array<int, RadioPath::kMostMirrors> faces = {};  // from the tag on
  // Seen in the first of them, then in the second, too. [m]
  std::array<Eigen::Vector3d, RadioPath::kMostMirrors> places;
};

// Images of a point in faces that it stands before, by 5 cm at least: the face that a tag sticks on
// is none of its mirrors, its loss is that of what is behind a tag. Of two mirrors, those alone of
// which each has a part before the other, and one has a part in the light that the other throws.
// Nothing that takes a way longer than `reach` [m] from mirror to tag.
std::vector<MirrorImage> images_of(const Eigen::Vector3d& point, std::span<const MirrorFace> faces,
                                   int most_mirrors, double reach);

RadioPath straight_path(const Eigen::Vector3d& antenna, const Eigen::Vector3d& tag);

// The way from an antenna by an image's mirrors; none where it would miss one of them. What stands
// in the way is not asked.
std::optional<RadioPath> path_by(const MirrorImage& image, std::span<const MirrorFace> faces,
                                 const Eigen::Vector3d& antenna, const Eigen::Vector3d& tag);

}  // namespace mapbed
