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
  if (model_.kind == DriveKind::omni) {  // each wheel by itself
    contacts_[1].radius_error = model_.wheel_spread * radii.normal();
    contacts_[3].radius_error = model_.wheel_spread * radii.normal();
  }
  if (model_.kind == DriveKind::ackermann) {
    steering_zero_ = model_.steering_spread * rng.stream("steering").normal();
  }
  if (model_.kind == DriveKind::skid_steer) believed_track_ = 2.0 * (a * a + b * b) / b;
}

void Wheels::drive(const DriveCommand& command, double dt) {
  if (model_.kind == DriveKind::omni) return drive_sideways(command, dt);
  if (model_.kind == DriveKind::ackermann) return steer(command, dt);
  const double v = std::clamp(command.forward_velocity, -model_.max_speed, model_.max_speed);
  const double w = std::clamp(command.turn_velocity, -model_.max_turn_speed, model_.max_turn_speed);
  motors_.forward_velocity = approach(motors_.forward_velocity, v, model_.acceleration * dt);
  motors_.turn_velocity = approach(motors_.turn_velocity, w, model_.turn_acceleration * dt);
}

// The limits of speed and acceleration hold for the way whatever its direction.
void Wheels::drive_sideways(const DriveCommand& command, double dt) {
  Eigen::Vector2d way(command.forward_velocity, command.left_velocity);
  if (way.norm() > model_.max_speed) way *= model_.max_speed / way.norm();
  const Eigen::Vector2d now(motors_.forward_velocity, motors_.left_velocity);
  Eigen::Vector2d change = way - now;
  const double most = model_.acceleration * dt;
  if (change.norm() > most) change *= most / change.norm();
  const double w = std::clamp(command.turn_velocity, -model_.max_turn_speed, model_.max_turn_speed);
  motors_.forward_velocity += change.x();
  motors_.left_velocity += change.y();
  motors_.turn_velocity = approach(motors_.turn_velocity, w, model_.turn_acceleration * dt);
  rolled_ = rolled_by_rollers();
}

// What is asked for is a curvature; where the car shall stand, the wheels stay as they are.
void Wheels::steer(const DriveCommand& command, double dt) {
  const double v = std::clamp(command.forward_velocity, -model_.max_speed, model_.max_speed);
  motors_.forward_velocity = approach(motors_.forward_velocity, v, model_.acceleration * dt);
  if (command.forward_velocity != 0.0) {
    const double curvature = command.turn_velocity / command.forward_velocity;
    const double asked = std::clamp(std::atan(model_.wheel_base * curvature), -model_.max_steering,
                                    model_.max_steering);
    steering_ = approach(steering_, asked, model_.steering_rate * dt);
  }
  motors_.turn_velocity = motors_.forward_velocity * std::tan(steering_) / model_.wheel_base;
  motors_.left_velocity = motors_.turn_velocity * model_.wheel_base / 2.0;
  rolled_ = rolled_by_car();
}

// Rollers at 45 deg: the wheel ahead on the left turns by vx - vy - (a + b) w, and so on; wheels of
// other radii make another motion of it.
Twist2 Wheels::rolled_by_rollers() const {
  const double lever = model_.track / 2.0 + model_.wheel_base / 2.0;
  Twist2 sum;
  for (const Contact& p : contacts_) {
    const double side = p.y > 0.0 ? -1.0 : 1.0;
    const double roller = (p.x > 0.0) == (p.y > 0.0) ? -1.0 : 1.0;
    const double turned = (motors_.forward_velocity + roller * motors_.left_velocity +
                           side * lever * motors_.turn_velocity) *
                          (1.0 + p.radius_error);
    sum.forward += turned / 4.0;
    sum.left += roller * turned / 4.0;
    sum.turn += side * turned / (4.0 * lever);
  }
  return sum;
}

// The rear wheels drive by a differential: by the mean of their radii.
Twist2 Wheels::rolled_by_car() const {
  const double error = (contacts_[1].radius_error + contacts_[3].radius_error) / 2.0;
  const double v = motors_.forward_velocity * (1.0 + error);
  const double w = v * std::tan(steering_ + steering_zero_) / model_.wheel_base;
  return {v, w * model_.wheel_base / 2.0, w};
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

// What motors and steering make of the wheel's surface, against the floor.
Eigen::Vector2d Wheels::surface_velocity(const Contact& p) const {
  if (model_.kind == DriveKind::omni || model_.kind == DriveKind::ackermann) {
    return {rolled_.forward - rolled_.turn * p.y, rolled_.left + rolled_.turn * p.x};
  }
  const bool steers = model_.kind == DriveKind::synchro;
  const double v = motors_.forward_velocity;
  const double w = motors_.turn_velocity;
  const double rolled = steers ? v : v - w * (p.y > 0.0 ? 0.5 : -0.5) * believed_track_;
  return {rolled * (1.0 + p.radius_error) - (steers ? w * p.y : 0.0), steers ? w * p.x : 0.0};
}

Twist2 Wheels::acceleration(const Twist2& body, double sideways) const {
  const double per_contact = model_.friction * kGravity / static_cast<double>(contact_count_);
  Twist2 result;
  for (std::size_t i = 0; i < contact_count_; ++i) {
    const Contact& p = contacts_[i];
    const Eigen::Vector2d surface = surface_velocity(p);
    const double slip_x = body.forward - body.turn * p.y - surface.x();
    const double slip_y = sideways * (body.left + body.turn * p.x - surface.y());
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
  const double side = motors_.left_velocity * dt;
  const double c = std::cos(turned / 2.0);
  const double s = std::sin(turned / 2.0);
  odometry_ = odometry_ * Pose2{way * c - side * s, way * s + side * c, turned};
  return body;
}

}  // namespace mapbed
