#include "core/testing/is_near.h"

#include <cmath>
#include <ostream>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

class NearPose : public ::testing::MatcherInterface<const Pose2&> {
 public:
  NearPose(const Pose2& expected, const Tolerance& tolerance)
      : expected_(expected), tolerance_(tolerance) {}

  bool MatchAndExplain(const Pose2& pose, ::testing::MatchResultListener* listener) const override {
    const double off = distance(pose, expected_);
    const double turned = std::abs(angle_difference(pose.theta, expected_.theta));
    *listener << "which is off by " << off << " m and " << turned << " rad";
    return off <= tolerance_.position && turned <= tolerance_.heading;
  }

  void DescribeTo(std::ostream* out) const override {
    *out << "is near ";
    PrintTo(expected_, out);
  }

 private:
  Pose2 expected_;
  Tolerance tolerance_;
};

}  // namespace

void PrintTo(const Pose2& pose, std::ostream* out) {
  *out << "(" << pose.x << " m, " << pose.y << " m, " << degrees(pose.theta) << " deg)";
}

::testing::Matcher<const Pose2&> IsNear(const Pose2& expected, const Tolerance& tolerance) {
  return ::testing::MakeMatcher(new NearPose(expected, tolerance));
}

}  // namespace mapbed
