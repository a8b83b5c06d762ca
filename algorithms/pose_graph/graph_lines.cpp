#include "algorithms/pose_graph/graph_lines.h"

#include <array>
#include <cmath>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

struct NamedKind {
  std::string_view tag;
  GraphKind kind;
};

constexpr NamedKind kKinds[] = {
    {"VERTEX_SE2", {}},
    {"EDGE_SE2", {.is_edge = true}},
    {"VERTEX_SE3:QUAT", {.is_in_space = true}},
    {"EDGE_SE3:QUAT", {.is_edge = true, .is_in_space = true}},
    {"VERTEX2", {.is_toro = true}},
    {"EDGE2", {.is_edge = true, .is_toro = true}},
    {"VERTEX3", {.is_in_space = true, .is_toro = true}},
    {"EDGE3", {.is_edge = true, .is_in_space = true, .is_toro = true}},
};

constexpr double kLargest = 1e100;  // squares of it are numbers still

double read_finite(Tokens& tokens, const SourceLocation& place, std::string_view what) {
  const double number = tokens.number();
  if (!tokens.ok()) {
    const std::string_view wrong = tokens.wrong();
    throw InputError(place,
                     wrong.empty()
                         ? fmt::format("ends within the {}", what)
                         : fmt::format("{} is no number of the {}", in_quotes(wrong), what),
                     "is the file complete, and each line of the form that its first word says?");
  }
  if (!(std::abs(number) <= kLargest)) {
    throw InputError(place, fmt::format("a number of the {} is not finite or too large", what),
                     "whatever wrote it has failed there; leave the line out");
  }
  return number;
}

template <int kCount>
std::array<double, kCount> read_numbers(Tokens& tokens, const SourceLocation& place,
                                        std::string_view what) {
  std::array<double, kCount> numbers{};
  for (double& number : numbers) number = read_finite(tokens, place, what);
  return numbers;
}

// Where row and column of TORO's entries are.
constexpr std::array<std::array<int, 2>, 6> kToroEntries = {
    {{0, 0}, {0, 1}, {1, 1}, {2, 2}, {0, 2}, {1, 2}}};

// TORO's information is of angles, the errors of PoseConstraint are sines of half the angles.
template <class Pose>
PoseInformation<Pose> with_turns_scaled(PoseInformation<Pose> information, double factor) {
  if constexpr (kDegreesOfFreedom<Pose> == 6) {
    information.template bottomRows<3>() *= factor;
    information.template rightCols<3>() *= factor;
  }
  return information;
}

// No direction in which an error would lower the cost; rounded zeros are zero.
template <class Pose>
void check_information(const PoseInformation<Pose>& information, const SourceLocation& place) {
  if (Eigen::LLT<PoseInformation<Pose>>(information).info() == Eigen::Success) return;
  const Eigen::SelfAdjointEigenSolver<PoseInformation<Pose>> solver(information,
                                                                    Eigen::EigenvaluesOnly);
  const double least = solver.eigenvalues().minCoeff();
  if (least >= -1e-6 * solver.eigenvalues().maxCoeff()) return;
  throw InputError(place, fmt::format("the information matrix has the eigenvalue {:.3g}", least),
                   "it is an inverse covariance, whose eigenvalues are not negative");
}

}  // namespace

std::optional<GraphKind> graph_kind(std::string_view tag) {
  for (const NamedKind& named : kKinds) {
    if (named.tag == tag) return named.kind;
  }
  return {};
}

std::string_view graph_tag(const GraphKind& kind) {
  for (const NamedKind& named : kKinds) {
    if (named.kind.is_edge == kind.is_edge && named.kind.is_in_space == kind.is_in_space &&
        named.kind.is_toro == kind.is_toro) {
      return named.tag;
    }
  }
  return {};
}

std::int64_t read_id(Tokens& tokens, const SourceLocation& place) {
  const std::string_view word = tokens.word();
  std::int64_t id = 0;
  if (!parse_number(word, id)) {
    throw InputError(place, fmt::format("{} is no node's id", in_quotes(word)),
                     "ids are whole numbers");
  }
  return id;
}

template <>
Pose2 read_pose<Pose2>(const GraphKind&, Tokens& tokens, const SourceLocation& place) {
  const auto n = read_numbers<3>(tokens, place, "pose");
  return {n[0], n[1], normalized_angle(n[2])};
}

template <>
Pose3 read_pose<Pose3>(const GraphKind& kind, Tokens& tokens, const SourceLocation& place) {
  const auto p = read_numbers<3>(tokens, place, "position");
  Pose3 pose;
  pose.position = {p[0], p[1], p[2]};
  if (kind.is_toro) {
    const auto [roll, pitch, yaw] = read_numbers<3>(tokens, place, "angles");
    pose.rotation = rotation_of(yaw, pitch, roll);
    return pose;
  }
  const auto q = read_numbers<4>(tokens, place, "quaternion");
  pose.rotation.coeffs() << q[0], q[1], q[2], q[3];
  const double length = pose.rotation.norm();
  if (!(std::abs(length - 1.0) <= 0.01)) {
    throw InputError(place, fmt::format("the quaternion has length {:.3g}, not 1", length),
                     "its order is qx qy qz qw");
  }
  // What was written of a unit quaternion stays as it is.
  if (std::abs(length - 1.0) > 1e-15) pose.rotation.normalize();
  return pose;
}

template <class Pose>
PoseInformation<Pose> read_information(const GraphKind& kind, Tokens& tokens,
                                       const SourceLocation& place) {
  constexpr int kSize = kDegreesOfFreedom<Pose>;
  const auto n = read_numbers<kSize*(kSize + 1) / 2>(tokens, place, "information matrix");
  PoseInformation<Pose> information;
  std::size_t next = 0;
  for (int r = 0; r < kSize; ++r) {
    for (int c = r; c < kSize; ++c) {
      const bool has_own_order = kind.is_toro && kSize == 3;
      const int row = has_own_order ? kToroEntries[next][0] : r;
      const int column = has_own_order ? kToroEntries[next][1] : c;
      information(row, column) = information(column, row) = n[next++];
    }
  }
  check_information<Pose>(information, place);
  return kind.is_toro ? with_turns_scaled<Pose>(information, 2.0) : information;
}

void check_line_end(Tokens& tokens, const SourceLocation& place) {
  if (tokens.at_end() || tokens.rest().front() == '#') return;
  throw InputError(place,
                   fmt::format("goes on with {} after its last number", in_quotes(tokens.rest())),
                   "is it of the form that its first word says?");
}

template <>
std::string pose_words<Pose2>(const GraphKind&, const Pose2& pose) {
  return fmt::format(" {} {} {}", pose.x, pose.y, pose.theta);
}

template <>
std::string pose_words<Pose3>(const GraphKind& kind, const Pose3& pose) {
  const Eigen::Vector3d& p = pose.position;
  const Eigen::Quaterniond& q = pose.rotation;
  if (!kind.is_toro) {
    return fmt::format(" {} {} {} {} {} {} {}", p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
  }
  const Eigen::Matrix3d r = q.toRotationMatrix();
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  // Nose up or down, roll and yaw turn about one axis: all of it is yaw.
  const bool is_upright = std::hypot(r(0, 0), r(1, 0)) < 1e-9;
  const double roll = is_upright ? 0.0 : std::atan2(r(2, 1), r(2, 2));
  const double yaw = is_upright ? std::atan2(-r(0, 1), r(1, 1)) : std::atan2(r(1, 0), r(0, 0));
  return fmt::format(" {} {} {} {} {} {}", p.x(), p.y(), p.z(), roll, pitch, yaw);
}

template <class Pose>
std::string information_words(const GraphKind& kind, const PoseInformation<Pose>& information) {
  constexpr int kSize = kDegreesOfFreedom<Pose>;
  const PoseInformation<Pose> own =
      kind.is_toro ? with_turns_scaled<Pose>(information, 0.5) : information;
  std::string words;
  std::size_t next = 0;
  for (int r = 0; r < kSize; ++r) {
    for (int c = r; c < kSize; ++c) {
      const bool has_own_order = kind.is_toro && kSize == 3;
      words += fmt::format(
          " {}", has_own_order ? own(kToroEntries[next][0], kToroEntries[next][1]) : own(r, c));
      ++next;
    }
  }
  return words;
}

template PoseInformation<Pose2> read_information<Pose2>(const GraphKind&, Tokens&,
                                                        const SourceLocation&);
template PoseInformation<Pose3> read_information<Pose3>(const GraphKind&, Tokens&,
                                                        const SourceLocation&);
template std::string information_words<Pose2>(const GraphKind&, const PoseInformation<Pose2>&);
template std::string information_words<Pose3>(const GraphKind&, const PoseInformation<Pose3>&);

}  // namespace mapbed
