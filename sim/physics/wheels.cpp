#include "sim/physics/wheels.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

constexpr double kGravity = 9.81;       // [m/s^2]
constexpr double kRegularSlip = 0.02;   // [m/s] Coulomb friction is viscous below this
constexpr double kLongestStep = 0.001;  // [s] the friction above is stable up to about 3 ms

double approach(double value, double target, double largest_step) {
  return value + std::clamp(target - value, -largest_step, largest_step);
}

}  // namespace

double inertia_per_mass(const RobotFootprint& f) {
  if (f.radius > 0.0) return f.radius * f.radius / 2.0;
  return (f.length * f.length + f.width * f.width) / 12.0;
}

Wheels::Wheels(const Robot& robot, const Rng& rng)
    : model_(robot.drive),
      inertia_per_mass_(inertia_per_mass(robot.footprint)),
      believed_track_(robot.drive.track),
      floor_(rng.stream("floor")) {
  const double b = model_.track / 2.0;
  const double a = model_.wheel_base / 2.0;
  Rng radii = rng.stream("wheel radii");
  const double left = model_.wheel_spread * radii.normal();
  const double right = model_.wheel_spread * radii.normal();
  if (model_.kind == DriveKind::differential) {
    contacts_ = {{{0.0, b, left}, {0.0, -b, right}}};
    contact_count_ = 2;
    return;
  }
  contacts_ = {{{a, b, left}, {-a, b, left}, {a, -b, right}, {-a, -b, right}}};
  contact_count_ = 4;
  if (model_.kind == DriveKind::skid_steer) believed_track_ = 2.0 * (a * a + b * b) / b;
}

void Wheels::drive(const DriveCommand& command, double dt) {
  const double v = std::clamp(command.forward_velocity, -model_.max_speed, model_.max_speed);
  const double w = std::clamp(command.turn_velocity, -model_.max_turn_speed, model_.max_turn_speed);
  motors_.forward_velocity = approach(motors_.forward_velocity, v, model_.acceleration * dt);
  motors_.turn_velocity = approach(motors_.turn_velocity, w, model_.turn_acceleration * dt);
}

// Friction sideways over friction lengthwise, by square patches of floor.
double Wheels::sideways_friction(const Pose2& world_from_robot) const {
  if (model_.surface_spread <= 0.0) return 1.0;
  const auto patch = [this](double v) {
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(std::floor(v / model_.surface_patch)));
  };
  Rng here = floor_.stream("patch", patch(world_from_robot.x), patch(world_from_robot.y));
  return std::clamp(1.0 + model_.surface_spread * here.normal(), 0.3, 3.0);
}

Twist2 Wheels::acceleration(const Twist2& body, double sideways) const {
  const double per_contact = model_.friction * kGravity / static_cast<double>(contact_count_);
  const bool steers = model_.kind == DriveKind::synchro;
  Twist2 result;
  for (std::size_t i = 0; i < contact_count_; ++i) {
    const Contact& p = contacts_[i];
    // What the motor makes of the wheel's surface, against the floor.
    const double v = motors_.forward_velocity;
    const double w = motors_.turn_velocity;
    const double rolled = steers ? v : v - w * (p.y > 0.0 ? 0.5 : -0.5) * believed_track_;
    const double rolling = rolled * (1.0 + p.radius_error) - (steers ? w * p.y : 0.0);
    const double swivelling = steers ? w * p.x : 0.0;

    const double slip_x = body.forward - body.turn * p.y - rolling;
    const double slip_y = sideways * (body.left + body.turn * p.x - swivelling);
    const double push = -per_contact / std::max(std::hypot(slip_x, slip_y), kRegularSlip);
    const double force_x = push * slip_x;
    const double force_y = push * sideways * slip_y;
    result.forward += force_x;
    result.left += force_y;
    result.turn += (p.x * force_y - p.y * force_x) / inertia_per_mass_;
  }
  return result;
}

Twist2 Wheels::push(const Twist2& start, const Pose2& world_from_robot, double dt) {
  const double sideways = sideways_friction(world_from_robot);
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kLongestStep - 1e-9)));
  const double h = dt / steps;
  Twist2 body = start;
  for (int i = 0; i < steps; ++i) {
    const Twist2 a = acceleration(body, sideways);
    const double turn = body.turn * h;  // the frame turns under the velocity
    const double forward = body.forward + a.forward * h;
    const double left = body.left + a.left * h;
    body.forward = forward + left * turn;
    body.left = left - forward * turn;
    body.turn += a.turn * h;
  }
  // Encoders count the wheels' turns, whatever the floor does.
  const double turned = motors_.turn_velocity * dt;
  const double way = motors_.forward_velocity * dt;
  odometry_ = odometry_ * Pose2{way * std::cos(turned / 2.0), way * std::sin(turned / 2.0), turned};
  return body;
}

}  // namespace mapbed
