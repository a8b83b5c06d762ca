#include "core/log/ros/ros_definitions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

const std::string kRule(80, '=');

TEST(RosDefinitions, TypesAreKnownByTheNamesOfRos1AndRos2) {
  EXPECT_EQ(ros_type_of("sensor_msgs/LaserScan"), RosType::laser_scan);
  EXPECT_EQ(ros_type_of("sensor_msgs/msg/LaserScan"), RosType::laser_scan);
  EXPECT_EQ(ros_type_of("tf/tfMessage"), RosType::transforms);
  EXPECT_EQ(ros_type_of("sensor_msgs/PointCloud2"), RosType::other);
}

TEST(RosDefinitions, CommentsConstantsAndWholeNamesMakeNoOtherFields) {
  const std::string text =
      "# A pose\n\nuint8 MODE=3 # a constant\nuint8 OTHER = 4\nHeader header   # "
      "when\ngeometry_msgs/Pose pose\n" +
      kRule + "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + kRule +
      "\nMSG: geometry_msgs/Pose\nPoint position\nQuaternion  orientation\n" + kRule +
      "\nMSG: geometry_msgs/Quaternion\nfloat64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n" +
      kRule + "\nMSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n";
  EXPECT_TRUE(has_fields_of(RosType::pose, RosEncoding::cdr, text));
  EXPECT_FALSE(has_fields_of(RosType::pose, RosEncoding::ros1, text)) << "there a header counts";
}

TEST(RosDefinitions, AnotherFieldOrOrderIsSeenAtAnyDepth) {
  const std::string text = definition_of(RosType::pose, RosEncoding::cdr);
  EXPECT_TRUE(has_fields_of(RosType::pose, RosEncoding::cdr, text));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    return other.replace(other.find(from), from.size(), to);
  };
  EXPECT_FALSE(has_fields_of(RosType::pose, RosEncoding::cdr, with("float64 x", "float32 x")));
  EXPECT_FALSE(has_fields_of(RosType::pose, RosEncoding::cdr, with("string frame_id\n", "")));
  EXPECT_FALSE(has_fields_of(RosType::pose, RosEncoding::cdr, with("float64 z\n", "float64 u\n")));
  EXPECT_FALSE(has_fields_of(RosType::pose, RosEncoding::cdr, "int32 x\n"));
  EXPECT_FALSE(has_fields_of(RosType::pose, RosEncoding::cdr, ""));
}

TEST(RosDefinitions, ATypeThatContainsItselfEnds) {
  const std::string text = "A a\nA b\n" + kRule + "\nMSG: x/A\nA a\nA b\nA c\nA d\n";
  EXPECT_FALSE(has_fields_of(RosType::pose, RosEncoding::cdr, text));
}

}  // namespace
}  // namespace mapbed
