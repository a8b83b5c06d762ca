#include "sim/sensors/rfid/image_paths.h"

#include <algorithm>

namespace mapbed {
namespace {

constexpr double kBeforeMirror = 0.05;  // [m]
constexpr double kTouching = 1e-6;      // [m]

Eigen::Vector3d in_space(const MirrorFace& face, const Eigen::Vector2d& corner) {
  return face.offset * face.normal + corner.x() * face.across + corner.y() * face.along;
}

// From a point to the rectangle around a face, at least. [m]
double distance_to(const MirrorFace& face, const Eigen::Vector3d& point) {
  const double aside =
      face.box.exteriorDistance(Eigen::Vector2d(point.dot(face.across), point.dot(face.along)));
  return std::hypot(aside, height_over(face, point));
}

// Of the rectangle around a face, in turn.
std::array<Eigen::Vector3d, 4> corners_around(const MirrorFace& face) {
  const Eigen::Vector2d& low = face.box.min();
  const Eigen::Vector2d& high = face.box.max();
  return {in_space(face, low), in_space(face, {high.x(), low.y()}), in_space(face, high),
          in_space(face, {low.x(), high.y()})};
}

bool has_part_before(const MirrorFace& face, const MirrorFace& other) {
  return std::any_of(face.outline.begin(), face.outline.end(), [&](const Eigen::Vector2d& corner) {
    return height_over(other, in_space(face, corner)) > kTouching;
  });
}

// Beams from an image spread within a pyramid through its mirror. Planes of its sides, their
// normals inwards; the image is a point of all of them.
std::array<Eigen::Vector3d, 4> pyramid_through(const MirrorFace& mirror,
                                               const Eigen::Vector3d& image) {
  const std::array<Eigen::Vector3d, 4> corners = corners_around(mirror);
  const Eigen::Vector3d middle = (corners[0] + corners[2]) / 2.0 - image;
  std::array<Eigen::Vector3d, 4> normals;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d normal = (corners[i] - image).cross(corners[(i + 1) % 4] - image);
    normals[i] = normal.dot(middle) < 0.0 ? Eigen::Vector3d(-normal) : normal;
  }
  return normals;
}

// That a face lies wholly outside of one of the planes.
bool is_outside(const std::array<Eigen::Vector3d, 4>& pyramid, const Eigen::Vector3d& image,
                const MirrorFace& face) {
  const std::array<Eigen::Vector3d, 4> corners = corners_around(face);
  return std::any_of(pyramid.begin(), pyramid.end(), [&](const Eigen::Vector3d& normal) {
    return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& corner) {
      return normal.dot(corner - image) < 0.0;
    });
  });
}

// Where the straight line to a place behind a face goes through it; none where it does not.
std::optional<Eigen::Vector3d> crossing(const MirrorFace& face, const Eigen::Vector3d& from,
                                        const Eigen::Vector3d& image) {
  const double before = height_over(face, from);
  const double behind = -height_over(face, image);
  if (before <= kTouching || behind <= kTouching) return {};
  const Eigen::Vector3d point = from + (image - from) * (before / (before + behind));
  if (!contains(face, point)) return {};
  return point;
}

}  // namespace

std::vector<MirrorImage> images_of(const Eigen::Vector3d& point, std::span<const MirrorFace> faces,
                                   int most_mirrors, double reach) {
  std::vector<MirrorImage> images;
  if (most_mirrors < 1) return images;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const MirrorFace& face = faces[i];
    if (height_over(face, point) < kBeforeMirror || distance_to(face, point) > reach) continue;
    MirrorImage image{.faces = {static_cast<int>(i), 0}, .places = {}};
    image.places.fill(mirrored(face, point));
    images.push_back(image);
  }
  const std::size_t once = most_mirrors < 2 ? 0 : images.size();
  for (std::size_t k = 0; k < once; ++k) {
    const MirrorImage first = images[k];
    const MirrorFace& mirror = faces[static_cast<std::size_t>(first.faces[0])];
    const std::array<Eigen::Vector3d, 4> pyramid = pyramid_through(mirror, first.places[0]);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const MirrorFace& face = faces[i];
      if (height_over(face, first.places[0]) < kBeforeMirror) continue;
      if (distance_to(face, first.places[0]) > reach) continue;
      if (!has_part_before(face, mirror) || !has_part_before(mirror, face)) continue;
      if (is_outside(pyramid, first.places[0], face)) continue;
      images.push_back({2,
                        {first.faces[0], static_cast<int>(i)},
                        {first.places[0], mirrored(face, first.places[0])}});
    }
  }
  return images;
}

RadioPath straight_path(const Eigen::Vector3d& antenna, const Eigen::Vector3d& tag) {
  RadioPath path;
  path.points[0] = antenna;
  path.points[1] = tag;
  path.length = (tag - antenna).norm();
  return path;
}

std::optional<RadioPath> path_by(const MirrorImage& image, std::span<const MirrorFace> faces,
                                 const Eigen::Vector3d& antenna, const Eigen::Vector3d& tag) {
  RadioPath path;
  path.mirrors = image.mirrors;
  path.points[0] = antenna;
  for (int k = 0; k < image.mirrors; ++k) {
    const auto seen = static_cast<std::size_t>(image.mirrors - 1 - k);  // from the antenna on
    const auto at = static_cast<std::size_t>(k);
    const MirrorFace& face = faces[static_cast<std::size_t>(image.faces[seen])];
    const auto point = crossing(face, path.points[at], image.places[seen]);
    if (!point) return {};
    path.points[at + 1] = *point;
    path.faces[at] = image.faces[seen];
  }
  path.points[static_cast<std::size_t>(image.mirrors) + 1] = tag;
  path.length = (image.places[static_cast<std::size_t>(image.mirrors) - 1] - antenna).norm();
  return path;
}

}  // namespace mapbed
