#include "sim/sensors/rfid/rfid_field.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using Complex = std::complex<double>;

constexpr double kNotBack = 25.0;      // [dB] below the threshold: left out
constexpr double kTooWeak = 25.0;      // [dB] below it: a way that is not followed
constexpr double kMostCrossed = 40.0;  // [dB] then nothing gets through

double decibels(double amplitude) {
  return 20.0 * std::log10(std::max(amplitude, 1e-12));
}
double amplitude_of(double decibels) {
  return std::pow(10.0, decibels / 20.0);
}

// Of a whole way, by its straight pieces.
double crossing_loss(const Scene& scene, const RadioPath& path) {
  double loss = 0.0;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(path.mirrors); ++k) {
    if (loss > kMostCrossed) break;
    loss += crossing_loss(scene, path.points[k], path.points[k + 1], kMostCrossed - loss);
  }
  return loss;
}

// Whether a point is before each face, so that the face may mirror what comes from there.
std::vector<bool> before(const std::vector<MirrorFace>& faces, const Eigen::Vector3d& point) {
  std::vector<bool> result;
  result.reserve(faces.size());
  for (const MirrorFace& face : faces) result.push_back(height_over(face, point) > 0.0);
  return result;
}

}  // namespace

RfidField::RfidField(const World& world, const std::vector<MountedAntenna>& antennas)
    : tags_(world.tags), materials_(world.materials) {
  std::vector<std::string> names;
  for (const RfidTag& tag : world.tags) names.push_back(tag.id);
  names_ = std::make_shared<const std::vector<std::string>>(std::move(names));
  for (const MountedAntenna& antenna : antennas) {
    antennas_.push_back({antenna, device_of(antenna.model), mirrors_for(world, antenna.model)});
  }
}

std::shared_ptr<const RfidField::Mirrors> RfidField::mirrors_for(const World& world,
                                                                 const RfidModel& model) const {
  const MirrorFaceOptions options{model.smallest_face, model.floor};
  for (const Antenna& other : antennas_) {
    const Mirrors& there = *other.mirrors;
    if (there.options == options && there.most == model.reflections && there.reach == model.reach)
      return other.mirrors;
  }
  auto mirrors = std::make_shared<Mirrors>();
  mirrors->options = options;
  mirrors->most = model.reflections;
  mirrors->reach = model.reach;
  if (model.reflections > 0) mirrors->faces = mirror_faces(world, options);
  for (const RfidTag& tag : tags_) {
    mirrors->images.push_back(
        images_of(tag.world_from_tag.position, mirrors->faces, model.reflections, model.reach));
  }
  return mirrors;
}

std::optional<IdealTag> RfidField::receive(const Scene& scene, const Antenna& antenna,
                                           const PlacedAntenna& placed, const RfidTag& tag,
                                           const std::vector<MirrorImage>& images,
                                           const std::vector<bool>& is_before) const {
  const RfidModel& model = antenna.mounted.model;
  const Eigen::Vector3d& place = tag.world_from_tag.position;
  const RadioPath straight = straight_path(placed.place, place);
  if (straight.length > model.reach || straight.length < 1e-3) return {};
  const double tag_loss = tag.material == RfidTag::kNothing
                              ? 0.0
                              : materials_[static_cast<std::size_t>(tag.material)].tag_loss;
  const double at_one = budget(placed, tag_loss);
  const std::vector<MirrorFace>& faces = antenna.mirrors->faces;
  const double weakest = amplitude_of(model.threshold - kTooWeak - at_one);
  const double farthest = model.wavelength() / (4.0 * kPi * weakest);  // [m] without any loss

  IdealTag result;
  const Complex direct = path_amplitude(placed, tag.world_from_tag, straight, faces, materials_);
  result.direct = static_cast<float>(at_one + decibels(std::abs(direct)));
  double crossed = 0.0;
  if (model.occlusion && std::abs(direct) > weakest) crossed = crossing_loss(scene, straight);
  result.crossing = static_cast<float>(crossed);
  Complex sum = direct * amplitude_of(-crossed);
  double strongest = 0.0;  // of the other ways
  for (const MirrorImage& image : images) {
    const auto last = static_cast<std::size_t>(image.mirrors) - 1;
    if (!is_before[static_cast<std::size_t>(image.faces[last])]) continue;
    const Eigen::Vector3d& seen = image.places[last];
    if ((seen - placed.place).squaredNorm() > farthest * farthest) continue;
    const std::optional<RadioPath> path = path_by(image, faces, placed.place, place);
    if (!path) continue;
    Complex field = path_amplitude(placed, tag.world_from_tag, *path, faces, materials_);
    if (std::abs(field) < weakest) continue;
    // Who asks for no occlusion asks for none by the mirrors' own world either: a mirror behind a
    // wall is none.
    const double loss = crossing_loss(scene, *path);
    field *= amplitude_of(-loss);
    sum += field;
    strongest = std::max(strongest, std::abs(field));
  }
  result.power = static_cast<float>(at_one + decibels(std::abs(sum)));
  result.multipath = result.power - (result.direct - result.crossing);
  result.is_reflection = strongest > std::abs(direct) * amplitude_of(-crossed);
  // There and back on the same ways.
  const double phase = -2.0 * std::arg(sum) + antenna.device.phase;
  result.phase = static_cast<float>(phase - 2.0 * kPi * std::floor(phase / (2.0 * kPi)));
  if (result.power < model.threshold - kNotBack) return {};
  return result;
}

IdealRfid RfidField::round(const Scene& scene, int index, const Pose2& world_from_robot) const {
  CHECK(index >= 0 && static_cast<std::size_t>(index) < antennas_.size());
  const Antenna& antenna = antennas_[static_cast<std::size_t>(index)];
  const Pose3 world_from_antenna =
      upright(world_from_robot) * antenna.mounted.robot_from_antenna.pose();
  const PlacedAntenna placed =
      placed_antenna(antenna.mounted.model, antenna.device, world_from_antenna);
  IdealRfid result;
  result.antenna = index;
  result.place = placed.place.head<2>();
  result.names = names_;
  const std::vector<bool> is_before = before(antenna.mirrors->faces, placed.place);
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    std::optional<IdealTag> tag =
        receive(scene, antenna, placed, tags_[i], antenna.mirrors->images[i], is_before);
    if (!tag) continue;
    tag->tag = static_cast<std::int32_t>(i);
    result.tags.push_back(*tag);
  }
  return result;
}

std::optional<IdealTag> RfidField::at(const Scene& scene, int index,
                                      const Pose3& world_from_antenna, const RfidTag& tag) const {
  CHECK(index >= 0 && static_cast<std::size_t>(index) < antennas_.size());
  const Antenna& antenna = antennas_[static_cast<std::size_t>(index)];
  const Mirrors& mirrors = *antenna.mirrors;
  return receive(scene, antenna,
                 placed_antenna(antenna.mounted.model, antenna.device, world_from_antenna), tag,
                 images_of(tag.world_from_tag.position, mirrors.faces, mirrors.most, mirrors.reach),
                 before(mirrors.faces, world_from_antenna.position));
}

}  // namespace mapbed
