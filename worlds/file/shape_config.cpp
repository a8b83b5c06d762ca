#include "worlds/file/shape_config.h"

#include <algorithm>

#include "core/input_error.h"
#include "worlds/file/obj_file.h"
#include "worlds/geometry/triangulate.h"

namespace mapbed {
namespace {

constexpr double kLargest = 1e4;  // [m] of any coordinate

Eigen::VectorXd coordinates(const ConfigNode& node, std::size_t least, std::size_t most) {
  const std::vector<double> numbers = node.numbers(Unit::meter, between(-kLargest, kLargest));
  if (numbers.size() < least || numbers.size() > most) {
    throw InputError(
        node.place(), std::to_string(numbers.size()) + " coordinates are given",
        least == most ? "write " + std::to_string(least) : "write x and y, and a height if needed");
  }
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

Extrusion extrusion(const ConfigNode& node, double height) {
  Extrusion result{points(node, 3), 0.0, height};
  if (result.outline.size() > kMostCorners) {
    throw InputError(node.place(),
                     "the outline has more than " + std::to_string(kMostCorners) + " corners",
                     "leave some out, or make two shapes of it");
  }
  if (doubled_area(result.outline) < 0.0) {
    std::reverse(result.outline.begin(), result.outline.end());
  }
  if (triangulate(result.outline).size() != result.outline.size() - 2) {
    throw InputError(node.place(), "the outline crosses itself or covers nothing",
                     "list its corners in order, once round");
  }
  return result;
}

}  // namespace

Eigen::Vector2d point(const ConfigNode& node) {
  return coordinates(node, 2, 2);
}

std::vector<Eigen::Vector2d> points(const ConfigNode& node, std::size_t least) {
  std::vector<Eigen::Vector2d> result;
  for (const ConfigNode& item : node.items()) result.push_back(point(item));
  if (result.size() < least) {
    throw InputError(node.place(), std::to_string(result.size()) + " points are too few",
                     "give " + std::to_string(least) + " or more");
  }
  return result;
}

double length(const ConfigNode& map, const std::string& key, double otherwise) {
  const ConfigNode* node = map.find(key);
  if (node == nullptr) return otherwise;
  return node->number(Unit::meter, {.low = 0.0, .high = kLargest, .low_itself = false});
}

Pose3 pose_of(const ConfigNode& node) {
  Pose3 pose;
  if (const ConfigNode* at = node.find("at")) {
    const Eigen::VectorXd p = coordinates(*at, 2, 3);
    pose.position = {p[0], p[1], p.size() == 3 ? p[2] : 0.0};
  }
  const auto angle = [&](const std::string& key) {
    const ConfigNode* found = node.find(key);
    return found != nullptr ? found->number(Unit::radian) : 0.0;
  };
  pose.rotation = rotation_of(angle("heading"), angle("pitch"), angle("roll"));
  return pose;
}

ConfiguredShape shape_of(const ConfigNode& node, double height,
                         const std::filesystem::path& folder) {
  if (const ConfigNode* box = node.find("box")) {
    const Eigen::Vector3d size = coordinates(*box, 3, 3);
    if (size.minCoeff() <= 0.0) {
      throw InputError(box->place(), "the box has no size", "give three lengths above 0");
    }
    return {Box{size}, size.z() / 2};
  }
  if (const ConfigNode* round = node.find("cylinder")) {
    const Cylinder cylinder{length(*round, "radius", 0.5), length(*round, "height", 1.0)};
    return {cylinder, cylinder.height / 2};
  }
  if (const ConfigNode* outline = node.find("outline")) {
    return {extrusion(*outline, length(node, "height", height)), 0.0};
  }
  if (const ConfigNode* mesh = node.find("mesh")) {
    return {load_obj((folder / mesh->text()).string()), 0.0};
  }
  throw InputError(node.place(), "the shape has no geometry",
                   "give box, cylinder, outline or mesh");
}

Opening opening_of(const ConfigNode& node) {
  Opening opening;
  opening.kind = static_cast<OpeningKind>(node.at("kind").choice({"gap", "door", "glass"}));
  opening.at = node.at("at").number(Unit::meter, kNotNegative);
  opening.width = length(node, "width", opening.width);
  const auto flag = [&](const std::string& key, bool& value) {
    if (const ConfigNode* found = node.find(key)) value = found->flag();
  };
  const auto seconds = [&](const std::string& key, double& value) {
    if (const ConfigNode* found = node.find(key)) {
      value = found->number(Unit::second, kNotNegative);
    }
  };
  if (opening.kind == OpeningKind::door) {
    flag("open", opening.door.starts_open);
    flag("hinge_at_end", opening.door.hinge_at_end);
    flag("opens_left", opening.door.opens_left);
    seconds("mean_open", opening.door.mean_open);
    seconds("mean_shut", opening.door.mean_shut);
    opening.door.opens_within = length(node, "opens_within", opening.door.opens_within);
  }
  return opening;
}

}  // namespace mapbed
