#include "sim/actors/social_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr double kFarAway = 7.0;       // in ranges B: exp(-7) of the repulsion is below 2 N
constexpr double kHardFraction = 0.7;  // of the radius that nothing gets into
constexpr double kStandTurn = 3.0;     // [1/s^2] stiffness of turning on the spot
constexpr double kLeastPull = 0.5;     // of the heading towards the wish, where f_0 has died away
constexpr double kFastest = 2.5;       // [m/s] nobody is pushed faster than this

// What touching or nearly touching something does: n points from it to the walker.
Vector2d repulsion(double overlap, const Vector2d& n, const Vector2d& relative_velocity,
                   const SocialForceOptions& o) {
  double push = o.repulsion * std::exp(overlap / o.range);
  Vector2d force = Vector2d::Zero();
  if (overlap > 0.0) {
    push += o.stiffness * overlap;
    const Vector2d t(-n.y(), n.x());
    force = o.friction * overlap * relative_velocity.dot(t) * t;
  }
  return force + push * n;
}

// Overlaps so deep that forces would explode come from teleporting only.
double sane(double overlap, double radius) {
  return std::min(overlap, 0.5 * radius);
}

// The nearest points of walls that lie in clearly different directions: a wall in several pieces
// pushes once, both posts of a door push.
class WallPoints {
 public:
  explicit WallPoints(const Vector2d& position) : position_(position) {}

  void consider(const Wall& wall, double reach) {
    const Vector2d out = position_ - nearest_point(wall, position_);
    const double d2 = out.squaredNorm();
    if (d2 >= reach * reach || d2 < 1e-18) return;
    const double d = std::sqrt(d2);
    nearest_ = std::min(nearest_, d);
    const Point candidate{d, out / d};
    for (std::size_t i = 0; i < count_; ++i) {
      if (points_[i].n.dot(candidate.n) < 0.5) continue;  // more than 60 deg apart
      if (candidate.distance < points_[i].distance) points_[i] = candidate;
      return;
    }
    if (count_ < points_.size()) points_[count_++] = candidate;
  }

  struct Point {
    double distance;
    Vector2d n;
  };
  std::span<const Point> points() const { return {points_.data(), count_}; }
  double nearest() const { return nearest_; }  // [m] infinite where nothing is in reach

 private:
  Vector2d position_;
  std::array<Point, 4> points_{};
  std::size_t count_ = 0;
  double nearest_ = std::numeric_limits<double>::infinity();
};

struct WallForce {
  Vector2d force = Vector2d::Zero();
  double nearest = 0.0;  // [m] to the nearest wall; infinite where none is in reach
};

WallForce force_of_walls(const Walker& walker, const NavigationMap& map,
                         std::span<const Wall> doors, const SocialForceOptions& o) {
  const double radius = o.shoulder * walker.radius;
  const double reach = radius + kFarAway * o.range;
  WallPoints near(walker.position);
  for (const Wall& wall : map.walls_near(walker.position)) near.consider(wall, reach);
  for (const Wall& wall : doors) near.consider(wall, reach);
  WallForce result;
  result.nearest = near.nearest();
  for (const WallPoints::Point& p : near.points()) {
    result.force += repulsion(sane(radius - p.distance, radius), p.n, -walker.velocity, o);
  }
  return result;
}

void add_forces_between(const std::vector<Walker>& walkers, std::vector<Vector2d>& forces,
                        const SocialForceOptions& o) {
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    for (std::size_t j = i + 1; j < walkers.size(); ++j) {
      const Walker& a = walkers[i];
      const Walker& b = walkers[j];
      const Vector2d apart = a.position - b.position;
      const double radii = a.radius + b.radius;
      const double reach = radii + kFarAway * o.range;
      const double d2 = apart.squaredNorm();
      if (d2 >= reach * reach) continue;
      const double d = std::max(std::sqrt(d2), 1e-6);
      const Vector2d n = d > 1e-6 ? Vector2d(apart / d) : Vector2d(1.0, 0.0);
      const Vector2d force = repulsion(sane(radii - d, radii), n, b.velocity - a.velocity, o);
      forces[i] += force;
      forces[j] -= force;
    }
  }
}

Vector2d force_of_robots(const Walker& walker, std::span<const RoundObstacle> robots,
                         const SocialForceOptions& o) {
  Vector2d force = Vector2d::Zero();
  for (const RoundObstacle& robot : robots) {
    const Vector2d apart = walker.position - robot.position;
    const double radii = o.shoulder * walker.radius + robot.radius;
    const double d = apart.norm();
    if (d >= radii + kFarAway * o.range || d < 1e-6) continue;
    force += repulsion(sane(radii - d, radii), apart / d, robot.velocity - walker.velocity, o);
  }
  return force;
}

// Equations of the header, semi-implicit: velocity first, then position.
void move(Walker& w, const Vector2d& f_e, const SocialForceOptions& o, double dt) {
  const Vector2d r_f(std::cos(w.heading), std::sin(w.heading));
  const Vector2d r_o(-r_f.y(), r_f.x());
  const Vector2d f_0 = w.mass / o.relaxation * (w.wish - w.velocity);
  const double v_f = w.velocity.dot(r_f) + dt / w.mass * (f_0 + f_e).dot(r_f);
  const double v_o = (w.velocity.dot(r_o) + dt / w.mass * o.sideways * f_e.dot(r_o)) /
                     (1.0 + dt / w.mass * o.damping);  // implicit: never overshoots

  double stiffness =
      o.heading * std::max(f_0.norm(), kLeastPull * w.mass / o.relaxation * w.wish.norm());
  const Vector2d pull = f_0 + kLeastPull * w.mass / o.relaxation * w.wish;
  double wanted = std::atan2(pull.y(), pull.x());
  if (w.keeps_heading) {
    stiffness = kStandTurn;
    wanted = w.wished_heading;
  } else if (f_0.dot(r_f) < 0.0 && w.wish.dot(r_f) > 0.0) {
    wanted = std::atan2(w.wish.y(), w.wish.x());  // brakes without turning round
  }
  const double damping = (1.0 + o.alpha) * std::sqrt(stiffness / o.alpha);
  const double torque = stiffness * angle_difference(w.heading, wanted);
  w.turn_rate = (w.turn_rate + dt * torque) / (1.0 + dt * damping);
  w.heading = normalized_angle(w.heading + dt * w.turn_rate);

  w.velocity = v_f * r_f + v_o * r_o;
  const double speed = w.velocity.norm();
  if (speed > kFastest) w.velocity *= kFastest / speed;
  w.position += dt * w.velocity;
}

// Out of a disc about `center`, keeping the velocity along its border.
void keep_out(Walker& w, const Vector2d& center, double radius) {
  const Vector2d out = w.position - center;
  const double d = out.norm();
  if (d >= radius || d < 1e-9) return;
  const Vector2d n = out / d;
  w.position = center + radius * n;
  w.velocity -= std::min(0.0, w.velocity.dot(n)) * n;
}

void keep_out_of_robots(Walker& w, std::span<const RoundObstacle> robots) {
  for (const RoundObstacle& robot : robots) {
    keep_out(w, robot.position, robot.radius + kHardFraction * w.radius);
  }
}

void keep_out_of_walls(Walker& w, const NavigationMap& map, std::span<const Wall> doors,
                       double hard) {
  for (const Wall& wall : doors) keep_out(w, nearest_point(wall, w.position), hard);
  for (const Wall& wall : map.walls_near(w.position)) {
    keep_out(w, nearest_point(wall, w.position), hard);
  }
}

}  // namespace

void advance(std::vector<Walker>& walkers, const NavigationMap& map, std::span<const Wall> doors,
             std::span<const RoundObstacle> robots, const SocialForceOptions& options, double dt) {
  std::vector<Vector2d> forces(walkers.size(), Vector2d::Zero());
  add_forces_between(walkers, forces, options);
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    forces[i] += force_of_robots(walkers[i], robots, options);
  }
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    Walker& w = walkers[i];
    const WallForce walls = force_of_walls(w, map, doors, options);
    const Vector2d before = w.position;
    move(w, forces[i] + walls.force, options, dt);
    keep_out_of_robots(w, robots);
    // Only who may have got too near has to be looked at again.
    const double hard = kHardFraction * options.shoulder * w.radius;
    if (walls.nearest - (w.position - before).norm() < hard) {
      keep_out_of_walls(w, map, doors, hard);
    }
  }
}

}  // namespace mapbed
