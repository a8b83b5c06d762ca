#include "sim/drivers/car_driver.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/check.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr double kDecideEvery = 0.05;       // [s]
constexpr double kSeesPeople = 1.5;         // [m] along its path
constexpr double kReserve = 1.1;            // of the turning circle, for what the pursuit corrects
constexpr double kOffPath = 0.25;           // [m] further from its path it plans anew
constexpr double kNearerThanPlanned = 0.7;  // of people_margin: then it stops
constexpr double kAtEnd = 0.03;             // [m]
constexpr double kStandOff = 4.0;           // times its patience: then it makes room ...
constexpr double kGotOn = 0.05;             // [m]
constexpr double kRetreat = 1.5;            // [m] ... by so much
constexpr double kLongestPause = 30.0;      // [s] between plans that came to nothing
constexpr int kDetour = 12'000;             // places that are tried for a way round somebody

// What the car's own arcs are planned with.
CarBody body_of(const Robot& robot) {
  CarBody body{.ahead = robot.drive.kind == DriveKind::ackermann ? robot.drive.wheel_base / 2 : 0.0,
               .length = robot.footprint.length,
               .width = robot.footprint.width,
               .turning_radius = kReserve * std::max(robot.drive.turning_radius(), 0.1)};
  if (robot.footprint.radius > 0.0) body.length = body.width = 2.0 * robot.footprint.radius;
  return body;
}

CarPathOptions path_options(const PathFollowingOptions& options, std::span<const Obstacle> people) {
  CarPathOptions result{.margin = options.margin, .people_margin = options.people_margin};
  if (!people.empty()) result.most_places = kDetour;
  return result;
}

double length_of(const std::vector<CarPathPoint>& plan) {
  double length = 0.0;
  for (std::size_t i = 1; i < plan.size(); ++i) {
    length += (plan[i].pose.position() - plan[i - 1].pose.position()).norm();
  }
  return length;
}

}  // namespace

CarDriver::CarDriver(const Simulation& simulation, const NamedPath& path,
                     const CarDriverOptions& options)
    : simulation_(simulation),
      path_(path),
      options_(options),
      body_(body_of(simulation.robot())),
      ends_(path.points.size(), 0) {
  CHECK(path_.points.size() >= 2);
  if (plan_anew({})) plan_on(path_.points.size());
  if (planned_ < path_.points.size()) {
    const Vector2d& to = path_.points[planned_].position;
    throw InputError(fmt::format(
        "robot '{}' finds no way along path '{}' to ({:.2f} m, {:.2f} m) that its turning circle "
        "of {:.2f} m allows; take another path, a smaller driver.margin or another robot",
        simulation.robot().name, path_.name, to.x(), to.y(), body_.turning_radius));
  }
  length_ = length_of(plan_);
}

double CarDriver::longest_time() const {
  double seconds = 300.0;
  double slowest = std::min(options_.speed, simulation_.robot().drive.max_speed);
  for (const WayPoint& point : path_.points) {
    if (point.speed > 0.0) slowest = std::min(slowest, point.speed);
    seconds += 30.0 + point.pause;
  }
  return seconds + 5.0 * length_ / slowest;
}

Pose2 CarDriver::axle() const {
  return simulation_.now().robot * Pose2{-body_.ahead, 0.0, 0.0};
}

bool CarDriver::plan_anew(std::span<const Obstacle> people) {
  auto way = plan_car_path(simulation_.navigation_map(), body_, axle(), path_.points[leg_].position,
                           people, path_options(options_, people));
  if (!way) return false;
  plan_.resize(plan_.empty() ? 0 : at_ + 1);  // what it has driven stays
  at_ = plan_.size();
  planned_ = leg_;
  append(*way);
  plan_on(leg_ + 2);
  return true;
}

void CarDriver::append(const std::vector<CarPathPoint>& way_to_next) {
  plan_.insert(plan_.end(), way_to_next.begin(), way_to_next.end());
  ends_[planned_++] = plan_.size() - 1;
  is_dead_end_ = false;
}

void CarDriver::plan_on(std::size_t end) {
  while (!is_dead_end_ && planned_ < std::min(end, path_.points.size())) {
    const auto way = plan_car_path(simulation_.navigation_map(), body_, plan_.back().pose,
                                   path_.points[planned_].position, {}, path_options(options_, {}));
    if (way) append(*way);
    is_dead_end_ = !way;
  }
}

void CarDriver::try_plan(double time, std::span<const Obstacle> people) {
  if (time < plan_after_) return;
  const double least = std::max(options_.patience, kDecideEvery);
  const bool is_planned = plan_anew(people);
  plan_pause_ = is_planned ? least : std::clamp(2.0 * plan_pause_, least, kLongestPause);
  plan_after_ = time + plan_pause_;
}

std::size_t CarDriver::end_of_stretch() const {
  std::size_t end = at_;
  std::size_t leg = leg_;
  while (end + 1 < plan_.size() && plan_[end + 1].backwards == plan_[at_].backwards) {
    while (leg + 1 < planned_ && end > ends_[leg]) ++leg;
    if (end == ends_[leg] && path_.points[leg].pause > 0.0) break;
    ++end;
  }
  return end;
}

void CarDriver::follow_progress() {
  const Vector2d here = axle().position();
  const std::size_t end = end_of_stretch();
  const auto distance = [&](std::size_t i) { return (plan_[i].pose.position() - here).norm(); };
  while (at_ < end && distance(at_ + 1) <= distance(at_)) ++at_;
  while (leg_ + 1 < planned_ && at_ > ends_[leg_]) ++leg_;
  plan_on(leg_ + 2);
}

bool CarDriver::is_free_of_people() const {
  const Vector2d here = simulation_.now().robot.position();
  const std::size_t end = end_of_stretch();
  double seen = 0.0;
  for (std::size_t i = at_; i <= end && seen < kSeesPeople; ++i) {
    const Vector2d middle = plan_[i].pose * Vector2d(body_.ahead, 0.0);
    if (i > at_) seen += (plan_[i].pose.position() - plan_[i - 1].pose.position()).norm();
    for (const Obstacle& person : simulation_.obstacles()) {
      // Whoever is near already does not stop a way that leads away from him.
      const Vector2d to_person = person.pose.position() - here;
      if (to_person.dot(middle - here) < 0.0) continue;
      const double margin = kNearerThanPlanned * options_.people_margin;
      if (!is_free_of({&person, 1}, margin, body_, plan_[i].pose)) return false;
    }
  }
  return true;
}

// Slow enough to stop at the end, and to turn no faster than it can.
double CarDriver::speed_to(std::size_t end, double curvature) const {
  const DriveModel& drive = simulation_.robot().drive;
  const double asked = path_.points[leg_].speed;
  double left = 0.0;
  for (std::size_t i = at_; i < end; ++i) {
    left += (plan_[i + 1].pose.position() - plan_[i].pose.position()).norm();
  }
  const double braking = std::sqrt(2.0 * 0.5 * drive.acceleration * std::max(kAtEnd, left));
  const double turning = drive.max_turn_speed / std::max(std::abs(curvature), 1e-6);
  return std::min({asked > 0.0 ? asked : options_.speed, braking, turning});
}

// Pure pursuit: the circle through the axle, along its heading, and a point of the path ahead.
DriveCommand CarDriver::pursue() const {
  const Pose2 here = axle();
  const std::size_t end = end_of_stretch();
  const double direction = plan_[end].backwards ? -1.0 : 1.0;
  std::size_t ahead = at_;
  while (ahead < end &&
         (plan_[ahead].pose.position() - here.position()).norm() < options_.look_ahead) {
    ++ahead;
  }
  Vector2d aim = plan_[ahead].pose.position();
  const double missing = options_.look_ahead - (aim - here.position()).norm();
  if (missing > 0.0) aim = plan_[ahead].pose * Vector2d(direction * missing, 0.0);
  const Vector2d to = inverse(here) * aim;
  const double limit = kReserve / body_.turning_radius;
  const double curvature =
      std::clamp(2.0 * to.y() / std::max(1e-6, to.squaredNorm()), -limit, limit);
  const double speed = direction * speed_to(end, curvature);
  return {.forward_velocity = speed, .turn_velocity = curvature * speed};
}

// Else something is in its way that it does not plan for, as a door's leaf.
bool CarDriver::gets_on(double time) {
  const Vector2d here = axle().position();
  if ((here - got_to_).norm() > kGotOn) {
    got_to_ = here;
    got_on_at_ = time;
  }
  return time - got_on_at_ < kStandOff * std::max(options_.patience, 1.0);
}

// Back the way it came, as far as that is free, and on again from there; once at each place, so
// that who stays in its way is told in the end.
void CarDriver::make_room() {
  if (at_ <= made_room_at_) return;
  const std::size_t here = at_;
  std::size_t back = here;
  double way = 0.0;
  while (back > 0 && way < kRetreat && plan_[back - 1].backwards == plan_[here].backwards) {
    if (!is_free_of(simulation_.obstacles(), kNearerThanPlanned * options_.people_margin, body_,
                    plan_[back - 1].pose)) {
      break;
    }
    --back;
    way += (plan_[back + 1].pose.position() - plan_[back].pose.position()).norm();
  }
  if (back == here) return;
  std::vector<CarPathPoint> there_and_back;
  for (std::size_t i = here + 1; i-- > back;) {
    there_and_back.push_back({plan_[i].pose, !plan_[i].backwards});
  }
  for (std::size_t i = back + 1; i <= here; ++i) there_and_back.push_back(plan_[i]);
  at_ = here + 1;
  made_room_at_ = here + there_and_back.size();
  plan_.insert(plan_.begin() + static_cast<std::ptrdiff_t>(here + 1), there_and_back.begin(),
               there_and_back.end());
  for (std::size_t leg = leg_; leg < planned_; ++leg) ends_[leg] += there_and_back.size();
}

// Somebody is in the way: waits, then looks for a way round, then makes room.
DriveCommand CarDriver::give_way(double time) {
  if (wait_since_ < 0.0) wait_since_ = time;
  const double waited = time - wait_since_;
  if (waited >= options_.patience) try_plan(time, simulation_.obstacles());
  if (waited >= kStandOff * options_.patience) {
    make_room();
    wait_since_ = -1.0;
  }
  got_on_at_ = time;
  return {};
}

// The plan did not get further than this way-point: perhaps there is a way from where it is.
void CarDriver::go_on_from_dead_end(double time) {
  leg_ = planned_;
  ends_[leg_] = plan_.size();  // none of its points
  try_plan(time, simulation_.obstacles());
}

DriveCommand CarDriver::command(double time) {
  if (is_done_ || time < pause_until_) return {};
  if (asked_ >= 0.0 && time < asked_ + kDecideEvery - 1e-9) return last_;
  asked_ = time;

  follow_progress();
  const Pose2 here = axle();
  const std::size_t end = end_of_stretch();
  const double direction = plan_[end].backwards ? -1.0 : 1.0;
  const Vector2d past_end = inverse(plan_[end].pose) * here.position();
  if (at_ == end && direction * past_end.x() > -kAtEnd) {
    if (end == ends_[leg_] && path_.points[leg_].pause > 0.0) {
      pause_until_ = time + path_.points[leg_].pause;
    }
    const bool is_planned_end = end + 1 == plan_.size();
    is_done_ = is_planned_end && planned_ == path_.points.size();
    if (!is_planned_end) ++at_;
    if (is_planned_end && !is_done_) go_on_from_dead_end(time);
    got_on_at_ = std::max(time, pause_until_);
    return last_ = {};
  }
  // Pushed off its path; where there is no way on from here either, it stays on what it has.
  if ((plan_[at_].pose.position() - here.position()).norm() > kOffPath) try_plan(time, {});
  if (!is_free_of_people()) return last_ = give_way(time);
  wait_since_ = -1.0;
  if (!gets_on(time)) {
    make_room();
    got_on_at_ = time;
  }
  return last_ = pursue();
}

}  // namespace mapbed
