#include "sim/drivers/car_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <set>
#include <tuple>

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

  double radius() const { return radius_; }

  // [m] between the body and the nearest wall; negative: they may touch.
  double room(const NavigationMap& map, const Pose2& axle) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector2d& center : centers_) least = std::min(least, map.clearance(axle * center));
    return least - std::min(radius_, 0.9 * NavigationMap::kReach);  // the map sees no further
  }

  bool is_free_of(std::span<const Obstacle> people, double margin, const Pose2& axle) const {
    for (const Obstacle& person : people) {
      for (const Vector2d& center : centers_) {
        const double distance = (axle * center - person.pose.position()).norm();
        if (person.is_disc() && distance < radius_ + person.radius + margin) return false;
      }
    }
    return true;
  }

 private:
  std::vector<Vector2d> centers_;  // in the axle's frame
  double radius_ = 0.0;            // [m]
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

struct Node {
  Pose2 pose;  // world_from_axle
  double cost = 0.0;
  int parent = -1;
  int curvature = 2;  // of kCurvatures, how it was reached
  bool backwards = false;
};

class Search {
 public:
  Search(const NavigationMap& map, const CarBody& body, std::span<const Obstacle> people,
         const CarPathOptions& options, WayLeft way_left)
      : map_(map),
        body_(body),
        people_(people),
        options_(options),
        discs_(body),
        way_left_(std::move(way_left)),
        cell_(std::clamp(body.turning_radius / 3.0, 0.15, 0.6)),
        samples_(static_cast<int>(std::ceil(1.5 * cell_ / kSpacing))) {}

  std::optional<std::vector<CarPathPoint>> path(const Pose2& start, const Vector2d& goal) {
    options_.margin = std::clamp(discs_.room(map_, start), 0.0, options_.margin);
    open(Node{.pose = start});
    while (!queue_.empty() && static_cast<int>(nodes_.size()) < options_.most_places) {
      const int at = std::get<1>(queue_.top());
      queue_.pop();
      const Node node = nodes_[static_cast<std::size_t>(at)];
      if (!closed_.insert(place_of(node)).second) continue;
      if ((middle(node.pose) - goal).norm() < options_.tolerance) return traced(at);
      for (const bool backwards : {false, true}) {
        for (int k = 0; k < static_cast<int>(kCurvatures.size()); ++k) try_move(at, k, backwards);
      }
    }
    return std::nullopt;
  }

 private:
  using Place = std::tuple<int, int, int, bool>;

  Vector2d middle(const Pose2& axle) const { return axle * Vector2d(body_.ahead, 0.0); }

  double curvature(int k) const {
    return kCurvatures[static_cast<std::size_t>(k)] / body_.turning_radius;
  }

  Pose2 sample(const Pose2& from, int k, bool backwards, int i) const {
    const double step = (backwards ? -1.5 : 1.5) * cell_ / samples_;
    return moved(from, curvature(k), i * step);
  }

  Place place_of(const Node& node) const {
    const double turns = node.pose.theta / (2.0 * kPi) * kHeadings;
    const int heading = (static_cast<int>(std::lround(turns)) + kHeadings) % kHeadings;
    return {static_cast<int>(std::floor(node.pose.x / cell_)),
            static_cast<int>(std::floor(node.pose.y / cell_)), heading, node.backwards};
  }

  void open(const Node& node) {
    const double left = way_left_.from(middle(node.pose));
    queue_.emplace(node.cost + kGreed * left, static_cast<int>(nodes_.size()));
    nodes_.push_back(node);
  }

  void try_move(int from, int k, bool backwards) {
    const Node& last = nodes_[static_cast<std::size_t>(from)];
    Node next{.cost = last.cost, .parent = from, .curvature = k, .backwards = backwards};
    const double length = 1.5 * cell_ / samples_ * (backwards ? kBackwards : 1.0);
    for (int i = 1; i <= samples_; ++i) {
      next.pose = sample(last.pose, k, backwards, i);
      const double room = discs_.room(map_, next.pose);
      if (room < options_.margin) return;
      next.cost += length * price_of(room);
    }
    if (!discs_.is_free_of(people_, options_.people_margin, next.pose)) return;
    if (last.parent >= 0 && last.backwards != backwards) next.cost += kGearChange;
    next.cost += kSteering * std::abs(kCurvatures[static_cast<std::size_t>(k)] -
                                      kCurvatures[static_cast<std::size_t>(last.curvature)]);
    if (!closed_.contains(place_of(next))) open(next);
  }

  std::vector<CarPathPoint> traced(int end) const {
    std::vector<int> chain;
    for (int at = end; at >= 0; at = nodes_[static_cast<std::size_t>(at)].parent) {
      chain.push_back(at);
    }
    std::reverse(chain.begin(), chain.end());
    const Node& first = nodes_[static_cast<std::size_t>(chain.front())];
    const bool begins_backwards =
        chain.size() > 1 && nodes_[static_cast<std::size_t>(chain[1])].backwards;
    std::vector<CarPathPoint> path{{first.pose, begins_backwards}};
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const Pose2 from = nodes_[static_cast<std::size_t>(chain[i - 1])].pose;
      const Node& node = nodes_[static_cast<std::size_t>(chain[i])];
      for (int s = 1; s <= samples_; ++s) {
        path.push_back({sample(from, node.curvature, node.backwards, s), node.backwards});
      }
    }
    return path;
  }

  const NavigationMap& map_;
  CarBody body_;
  std::span<const Obstacle> people_;
  CarPathOptions options_;
  Discs discs_;
  WayLeft way_left_;
  double cell_;  // [m] side of what counts as one place
  int samples_;  // of a move
  std::vector<Node> nodes_;
  std::set<Place> closed_;
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
  return Search(map, body, people, options, WayLeft(std::move(*way))).path(start, goal);
}

}  // namespace mapbed
