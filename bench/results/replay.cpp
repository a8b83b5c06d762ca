#include "bench/results/replay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/plot/svg_text.h"
#include "core/check.h"
#include "core/image/png.h"
#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value, double step) {
  const double steps = std::round(value / step);
  return steps == 0.0 ? 0.0 : steps / std::round(1.0 / step);
}
double centimeters(double meters) {
  return rounded(meters, 0.01);
}

// At most `most` of `size` indices, evenly spaced, the first and the last among them.
std::vector<std::size_t> thinned(std::size_t size, int most) {
  CHECK(most >= 2);
  const std::size_t count = std::min(size, static_cast<std::size_t>(most));
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; ++i) {
    indices.push_back(count == 1 ? 0 : i * (size - 1) / (count - 1));
  }
  return indices;
}

Json track_json(const Trajectory& track, double start, int max_steps) {
  Json json{{"t", Json::array()}, {"x", Json::array()}, {"y", Json::array()}, {"a", Json::array()}};
  for (const std::size_t i : thinned(track.size(), max_steps)) {
    const Pose2& pose = track[i].pose;
    json["t"].push_back(rounded(track[i].time - start, 0.001));
    json["x"].push_back(centimeters(pose.x));
    json["y"].push_back(centimeters(pose.y));
    json["a"].push_back(rounded(pose.theta, 0.001));
  }
  return json;
}

// One beam in so many is kept.
std::size_t stride_of(const LaserScan& scan, int max_beams) {
  const auto most = static_cast<std::size_t>(max_beams);
  return std::max<std::size_t>(1, (scan.ranges.size() + most - 1) / most);
}

Json scan_json(const LaserScan& scan, double start, int max_beams) {
  const std::size_t beams = scan.ranges.size();
  const std::size_t stride = stride_of(scan, max_beams);
  Json ranges = Json::array();
  for (std::size_t beam = 0; beam < beams; beam += stride) {
    ranges.push_back(scan.is_hit(beam) ? std::lround(100.0 * scan.ranges[beam]) : 0L);
  }
  const Pose2& laser = scan.robot_from_laser.planar;
  return {{"t", rounded(scan.time - start, 0.001)},
          {"laser", {centimeters(laser.x), centimeters(laser.y), rounded(laser.theta, 0.001)}},
          {"first", rounded(scan.first_bearing, 0.0001)},
          {"step", rounded(static_cast<double>(stride) * scan.bearing_step, 0.000001)},
          {"cm", ranges}};
}

using LabelsByScan = std::map<std::pair<double, int>, const ScanLabels*>;

LabelsByScan by_scan(const BeamLabels& labels) {
  LabelsByScan found;
  for (const ScanLabels& of_scan : labels) found[{of_scan.time, of_scan.laser}] = &of_scan;
  return found;
}

// Which of the beams that are kept are called dynamic.
Json labels_json(const LaserScan& scan, const LabelsByScan& labels, int max_beams) {
  Json numbers = Json::array();
  const auto found = labels.find({scan.time, scan.laser});
  if (found == labels.end()) return numbers;
  const std::vector<float>& of_beams = found->second->static_probability;
  if (of_beams.size() != scan.ranges.size()) return numbers;
  const std::size_t stride = stride_of(scan, max_beams);
  for (std::size_t k = 0; k * stride < of_beams.size(); ++k) {
    if (is_dynamic(of_beams[k * stride])) numbers.push_back(k);
  }
  return numbers;
}

Json followed_json(const ObjectTrack& track, double start, int max_steps) {
  Json json{{"id", track.id},     {"t", Json::array()}, {"x", Json::array()},
            {"y", Json::array()}, {"s", Json::array()}, {"hidden", Json::array()}};
  for (const std::size_t i : thinned(track.states.size(), max_steps)) {
    const TrackState& state = track.states[i];
    json["t"].push_back(rounded(state.time - start, 0.001));
    json["x"].push_back(centimeters(state.position.x()));
    json["y"].push_back(centimeters(state.position.y()));
    json["s"].push_back(centimeters(sigma_of(state)));
    json["hidden"].push_back(state.occluded ? 1 : 0);
  }
  return json;
}

Json outline_json(const std::vector<Eigen::Vector2d>& line) {
  Json json = Json::array();
  for (const Eigen::Vector2d& point : line) {
    json.push_back(centimeters(point.x()));
    json.push_back(centimeters(point.y()));
  }
  return json;
}

Json map_json(const ReplayPicture& map) {
  return {{"png", png_address(png_of(map.image))},
          {"x", map.low_corner.x()},
          {"y", map.low_corner.y()},
          {"width", map.image.width() * map.resolution},
          {"height", map.image.height() * map.resolution}};
}

// First and last stamp of anything that has one.
std::pair<double, double> span_of(const Replay& replay) {
  double start = std::numeric_limits<double>::infinity();
  double end = -start;
  const auto include = [&](double time) {
    start = std::min(start, time);
    end = std::max(end, time);
  };
  for (const Trajectory* track : {&replay.truth, &replay.estimate, &replay.odometry}) {
    for (const Stamped<Pose2>& pose : *track) include(pose.time);
  }
  for (const LaserScan& scan : replay.scans) include(scan.time);
  return start <= end ? std::pair{start, end} : std::pair{0.0, 0.0};
}

double radius_of(const TruthEntity& entity) {
  return entity.kind == EntityKind::person ? 0.25 : entity.kind == EntityKind::door ? 0.1 : 0.5;
}

}  // namespace

// Stamps are counted from the start, so that they are short however large those of the log are.
std::string replay_json(const Replay& replay, const ReplayOptions& options) {
  const auto [start, end] = span_of(replay);
  Json json{{"title", replay.title}, {"start", 0}, {"end", rounded(end - start, 0.001)}};
  for (const auto& line : replay.outlines) json["outlines"].push_back(outline_json(line));
  if (replay.map.image.width() > 0) json["map"] = map_json(replay.map);
  const std::pair<const char*, const Trajectory*> tracks[] = {
      {"truth", &replay.truth}, {"estimate", &replay.estimate}, {"odometry", &replay.odometry}};
  for (const auto& [name, track] : tracks) {
    if (!track->empty()) json[name] = track_json(*track, start, options.max_steps);
  }
  for (const ReplayTrack& other : replay.others) {
    Json track = track_json(other.world_from_it, start, options.max_steps);
    track["name"] = other.name;
    track["kind"] = other.kind;
    track["radius"] = other.radius;
    json["others"].push_back(std::move(track));
  }
  const LabelsByScan labels = by_scan(replay.labels);
  for (const std::size_t i : thinned(replay.scans.size(), options.max_scans)) {
    const LaserScan& scan = replay.scans[i];
    json["scans"].push_back(scan_json(scan, start, options.max_beams));
    if (!labels.empty()) json["labels"].push_back(labels_json(scan, labels, options.max_beams));
  }
  for (const ObjectTrack& track : replay.tracks) {
    json["tracks"].push_back(followed_json(track, start, options.max_steps));
  }
  // Bytes that are no UTF-8 are replaced rather than refused: a name must not lose a whole replay.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Replay replay_of(const Truth& truth, const SensorLog& log) {
  Replay replay{.truth = trajectory_of(truth)};
  std::map<int, ReplayTrack> others;
  for (const TruthEntity& entity : truth.entities) {
    if (!entity.is_dynamic() || entity.kind == EntityKind::robot) continue;
    others[entity.id] = {entity.name, name_of(entity.kind), radius_of(entity), {}};
  }
  for (const StampedStates& states : truth.states) {
    for (std::size_t i = 0; i < states.moving.size(); ++i) {
      const MovingPose& moving = states.moving[i];
      // The last part stands for the whole: somebody's trunk, a door's leaf.
      const bool is_last =
          i + 1 == states.moving.size() || states.moving[i + 1].entity != moving.entity;
      const auto found = others.find(moving.entity);
      if (!is_last || found == others.end()) continue;
      found->second.world_from_it.push_back({states.time, planar(moving.world_from_part)});
    }
  }
  for (auto& [id, track] : others) {
    if (!track.world_from_it.empty()) replay.others.push_back(std::move(track));
  }
  replay.scans = front_scans_of(log);
  return replay;
}

std::vector<LaserScan> front_scans_of(const SensorLog& log) {
  std::vector<LaserScan> scans;
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan != nullptr && scan->laser == 0) scans.push_back(*scan);
  }
  return scans;
}

std::vector<std::vector<Eigen::Vector2d>> outlines_of(const World& world, double height) {
  constexpr int kCorners = 16;  // of a circle
  std::vector<std::vector<Eigen::Vector2d>> outlines;
  for (const Footprint& print : footprints(world, height, height + 0.01)) {
    const EntityKind kind = world.entities[static_cast<std::size_t>(print.entity)].kind;
    if (kind == EntityKind::floor || kind == EntityKind::door) continue;
    std::vector<Eigen::Vector2d> line = print.outline;
    for (int i = 0; line.size() < kCorners && print.outline.empty(); ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kCorners;
      line.push_back(print.center +
                     print.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    line.push_back(line.front());
    outlines.push_back(std::move(line));
  }
  return outlines;
}

double sigma_of(const TrackState& state) {
  const Eigen::Matrix2d& c = state.covariance;
  const double middle = 0.5 * (c(0, 0) + c(1, 1));
  const double longer = middle + std::hypot(0.5 * (c(0, 0) - c(1, 1)), c(0, 1));
  return std::sqrt(std::max(0.0, longer));
}

Tracks transformed(Tracks tracks, const Pose2& target_from_source) {
  const Eigen::Rotation2Dd turn(target_from_source.theta);
  const Eigen::Matrix2d rotation = turn.toRotationMatrix();
  for (ObjectTrack& track : tracks) {
    for (TrackState& state : track.states) {
      state.position = target_from_source * state.position;
      state.velocity = rotation * state.velocity;
      state.covariance = rotation * state.covariance * rotation.transpose();
    }
  }
  return tracks;
}

Trajectory aligned_at_start(const Trajectory& estimate, const Trajectory& truth) {
  for (const Stamped<Pose2>& first : estimate) {
    const std::optional<Pose2> world_from_robot = pose_at(truth, first.time);
    if (!world_from_robot) continue;
    const Pose2 world_from_map = *world_from_robot * inverse(first.pose);
    Trajectory moved = estimate;
    for (Stamped<Pose2>& pose : moved) pose.pose = world_from_map * pose.pose;
    return moved;
  }
  return estimate;
}

}  // namespace mapbed
