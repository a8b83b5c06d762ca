#include "sim/drivers/car_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <unordered_set>

#include <Eigen/Geometry>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr int kHeadings = 24;        // told apart around the circle
constexpr double kSpacing = 0.1;     // [m] between the poses of a path
constexpr double kBackwards = 2.0;   // price of a metre, times that of one forwards
constexpr double kGearChange = 1.0;  // [m] that a change of direction counts for
constexpr double kSteering = 0.1;    // [m] that a change of curvature counts for
constexpr double kGreed = 1.2;       // of the heuristic: finds a path soon, at most so much longer
constexpr std::array kCurvatures{-1.0, -0.5, 0.0, 0.5, 1.0};  // times the largest

// The body as discs along its middle line.
class Discs {
 public:
  explicit Discs(const CarBody& body) {
    const int count = std::max(1, static_cast<int>(std::ceil(1.5 * body.length / body.width)));
    const double half = body.length / count / 2.0;
    radius_ = std::hypot(half, body.width / 2.0);
    for (int i = 0; i < count; ++i) {
      centers_.emplace_back(body.ahead - body.length / 2.0 + (2 * i + 1) * half, 0.0);
    }
  }

  const std::vector<Vector2d>& centers() const { return centers_; }  // in the axle's frame
  double radius() const { return radius_; }

  // [m] of what the map sees: what is nearer than that to a disc's centre touches it.
  double radius_in_map() const { return std::min(radius_, 0.9 * NavigationMap::kReach); }

  bool is_free_of(std::span<const Obstacle> people, double margin, const Pose2& axle) const {
    for (const Obstacle& person : people) {
      if (!person.is_disc()) continue;
      const Vector2d place = inverse(axle) * person.pose.position();
      const double keep = radius_ + person.radius + margin;
      for (const Vector2d& center : centers_) {
        if ((center - place).squaredNorm() < keep * keep) return false;
      }
    }
    return true;
  }

 private:
  std::vector<Vector2d> centers_;
  double radius_ = 0.0;  // [m]
};

// Price of a metre with so much room beside the body.
double price_of(double room) {
  return 1.0 + 2.0 * std::clamp(1.0 - room / 0.4, 0.0, 1.0);
}

// What is left to go from a point, along a way to its end and back onto it.
class WayLeft {
 public:
  explicit WayLeft(std::vector<Vector2d> way) : way_(std::move(way)), left_(way_.size(), 0.0) {
    for (std::size_t i = way_.size() - 1; i-- > 0;) {
      left_[i] = left_[i + 1] + (way_[i + 1] - way_[i]).norm();
    }
  }

  double from(const Vector2d& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < way_.size(); ++i) {
      const Vector2d nearest = nearest_point({way_[i], way_[i + 1], 0.0}, point);
      least =
          std::min(least, (point - nearest).norm() + (way_[i + 1] - nearest).norm() + left_[i + 1]);
    }
    return least;
  }

 private:
  std::vector<Vector2d> way_;
  std::vector<double> left_;  // [m] from each corner to the end
};

Pose2 moved(const Pose2& pose, double curvature, double distance) {
  const double turn = curvature * distance;
  const double chord =
      distance * (std::abs(turn) < 1e-9 ? 1.0 : std::sin(turn / 2.0) / (turn / 2.0));
  return pose * Pose2{chord * std::cos(turn / 2.0), chord * std::sin(turn / 2.0), turn};
}

// A move of the search, as the axle sees it where it begins.
struct Arc {
  double curvature = 0.0;  // of the largest, -1 to 1
  bool backwards = false;
  std::vector<Pose2> poses;       // on it, the last one where it ends
  std::vector<Vector2d> centers;  // of the body's discs, pose after pose
};

std::vector<Arc> arcs_of(const CarBody& body, const Discs& discs, double length) {
  const int count = static_cast<int>(std::ceil(length / kSpacing));
  std::vector<Arc> arcs;
  for (const bool backwards : {false, true}) {
    for (const double curvature : kCurvatures) {
      Arc arc{.curvature = curvature, .backwards = backwards, .poses = {}, .centers = {}};
      for (int i = 1; i <= count; ++i) {
        const double distance = (backwards ? -length : length) * i / count;
        arc.poses.push_back(moved({}, curvature / body.turning_radius, distance));
        for (const Vector2d& center : discs.centers()) {
          arc.centers.push_back(arc.poses.back() * center);
        }
      }
      arcs.push_back(std::move(arc));
    }
  }
  return arcs;
}

// Somebody, and what the middle of a disc of the body keeps from him. [m]
struct Person {
  Vector2d place;
  double keep;
};

// The margin; less from those who are nearer already.
std::vector<Person> people_around(std::span<const Obstacle> people, const Discs& discs,
                                  const Pose2& start, double margin) {
  std::vector<Person> result;
  for (const Obstacle& person : people) {
    if (!person.is_disc()) continue;
    const Vector2d place = person.pose.position();
    const double touching = discs.radius() + person.radius;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector2d& center : discs.centers()) {
      nearest = std::min(nearest, (start * center - place).norm());
    }
    result.push_back({place, touching + std::clamp(nearest - touching, 0.0, margin)});
  }
  return result;
}

struct Node {
  Pose2 pose;  // world_from_axle
  double cost = 0.0;
  int parent = -1;
  int arc = -1;  // by which it was reached; -1: the start
};

class Search {
 public:
  Search(const NavigationMap& map, const CarBody& body, std::span<const Obstacle> people,
         const CarPathOptions& options, WayLeft way_left, const Pose2& start)
      : map_(map),
        body_(body),
        options_(options),
        discs_(body),
        people_(people_around(people, discs_, start, options.people_margin)),
        way_left_(std::move(way_left)),
        cell_(std::clamp(body.turning_radius / 3.0, 0.15, 0.6)),
        length_(1.5 * cell_),
        arcs_(arcs_of(body, discs_, length_)) {
    for (const Vector2d& center : discs_.centers()) {
      const double room = map.clearance(start * center) - discs_.radius_in_map();
      options_.margin = std::clamp(room, 0.0, options_.margin);
    }
    open(Node{.pose = start});
  }

  std::optional<std::vector<CarPathPoint>> path(const Vector2d& goal) {
    while (!queue_.empty() && static_cast<int>(nodes_.size()) < options_.most_places) {
      const int at = queue_.top().second;
      queue_.pop();
      const Node node = nodes_[static_cast<std::size_t>(at)];
      if (!closed_.insert(place_of(node)).second) continue;
      if ((middle(node.pose) - goal).norm() < options_.tolerance) return traced(at);
      const Eigen::Matrix2d turn = Eigen::Rotation2Dd(node.pose.theta).toRotationMatrix();
      for (int arc = 0; arc < static_cast<int>(arcs_.size()); ++arc) {
        try_move(at, node, turn, arc);
      }
    }
    return std::nullopt;
  }

 private:
  Vector2d middle(const Pose2& axle) const { return axle * Vector2d(body_.ahead, 0.0); }
  const Arc& arc(int number) const { return arcs_[static_cast<std::size_t>(number)]; }
  bool is_backwards(const Node& node) const { return node.arc >= 0 && arc(node.arc).backwards; }

  // A cell of the floor, a heading and a direction.
  std::uint64_t place_of(const Node& node) const {
    const auto turns = std::lround(node.pose.theta / (2.0 * kPi) * kHeadings);
    const auto heading = static_cast<std::uint64_t>((turns + kHeadings) % kHeadings);
    const auto row = [&](double x) {
      return static_cast<std::uint64_t>(std::lround(std::floor(x / cell_)) + (1 << 27)) & 0xfffffff;
    };
    return row(node.pose.x) << 36 | row(node.pose.y) << 8 | heading << 1 |
           static_cast<std::uint64_t>(is_backwards(node));
  }

  void open(const Node& node) {
    const double left = way_left_.from(middle(node.pose));
    queue_.emplace(node.cost + kGreed * left, static_cast<int>(nodes_.size()));
    nodes_.push_back(node);
  }

  // [m] beside a disc of the body, at most kReach; negative where it touches.
  double room_at(const Vector2d& center) const {
    for (const Person& person : people_) {
      if ((center - person.place).squaredNorm() < person.keep * person.keep) return -1.0;
    }
    return map_.clearance(center) - discs_.radius_in_map();
  }

  void try_move(int from, const Node& last, const Eigen::Matrix2d& turn, int number) {
    const Arc& move = arc(number);
    const std::size_t discs = discs_.centers().size();
    const double price =
        length_ / static_cast<double>(move.poses.size()) * (move.backwards ? kBackwards : 1.0);
    Node next{
        .pose = last.pose * move.poses.back(), .cost = last.cost, .parent = from, .arc = number};
    if (closed_.contains(place_of(next))) return;
    double room = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < move.centers.size(); ++i) {
      room = std::min(room, room_at(turn * move.centers[i] + last.pose.position()));
      if (room < options_.margin) return;
      if ((i + 1) % discs != 0) continue;  // one more pose is done
      next.cost += price * price_of(room);
      room = std::numeric_limits<double>::infinity();
    }
    const double before = last.arc < 0 ? 0.0 : arc(last.arc).curvature;
    if (last.arc >= 0 && is_backwards(last) != move.backwards) next.cost += kGearChange;
    next.cost += kSteering * std::abs(move.curvature - before);
    open(next);
  }

  std::vector<CarPathPoint> traced(int end) const {
    std::vector<int> chain;
    for (int at = end; at >= 0; at = nodes_[static_cast<std::size_t>(at)].parent) {
      chain.push_back(at);
    }
    std::reverse(chain.begin(), chain.end());
    const auto node = [&](std::size_t i) { return nodes_[static_cast<std::size_t>(chain[i])]; };
    const bool begins_backwards = chain.size() > 1 && is_backwards(node(1));
    std::vector<CarPathPoint> path{{node(0).pose, begins_backwards}};
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const Arc& move = arc(node(i).arc);
      for (const Pose2& pose : move.poses) {
        path.push_back({node(i - 1).pose * pose, move.backwards});
      }
    }
    return path;
  }

  const NavigationMap& map_;
  CarBody body_;
  CarPathOptions options_;
  Discs discs_;
  std::vector<Person> people_;
  WayLeft way_left_;
  double cell_;    // [m] side of what counts as one place
  double length_;  // [m] of a move
  std::vector<Arc> arcs_;
  std::vector<Node> nodes_;
  std::unordered_set<std::uint64_t> closed_;
  using Entry = std::pair<double, int>;  // cost and heuristic; node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

bool is_free_of(std::span<const Obstacle> people, double margin, const CarBody& body,
                const Pose2& world_from_axle) {
  return Discs(body).is_free_of(people, margin, world_from_axle);
}

std::optional<std::vector<CarPathPoint>> plan_car_path(const NavigationMap& map,
                                                       const CarBody& body, const Pose2& start,
                                                       const Eigen::Vector2d& goal,
                                                       std::span<const Obstacle> people,
                                                       const CarPathOptions& options) {
  const Vector2d from = start * Vector2d(body.ahead, 0.0);
  auto way = map.way(from, goal, body.width / 2.0);
  if (!way) return std::nullopt;
  return Search(map, body, people, options, WayLeft(std::move(*way)), start).path(goal);
}

}  // namespace mapbed
