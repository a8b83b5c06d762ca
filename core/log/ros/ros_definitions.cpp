#include "core/log/ros/ros_definitions.h"

#include <map>
#include <vector>

#include <fmt/format.h>

#include "core/check.h"
#include "core/file/tokens.h"

namespace mapbed {
namespace {

struct Known {
  RosType type;
  std::string_view name;
  std::string_view md5sum;
  std::vector<std::string_view> parts;  // that its definition names, in their order
};

const std::vector<Known>& known_types() {
  static const std::vector<Known> known{
      {RosType::laser_scan,
       "sensor_msgs/LaserScan",
       "90c7ef2dc6895d81024acba2ac42f369",
       {"std_msgs/Header"}},
      {RosType::multi_echo_scan,
       "sensor_msgs/MultiEchoLaserScan",
       "6fefb0c6da89d7c8abe4b339f5c2f8fb",
       {"std_msgs/Header", "sensor_msgs/LaserEcho"}},
      {RosType::odometry,
       "nav_msgs/Odometry",
       "cd5e73d190d741a2f92e81eda573aca7",
       {"std_msgs/Header", "geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose",
        "geometry_msgs/Point", "geometry_msgs/Quaternion", "geometry_msgs/TwistWithCovariance",
        "geometry_msgs/Twist", "geometry_msgs/Vector3"}},
      {RosType::transforms,
       "tf2_msgs/TFMessage",
       "94810edda583a504dfda3829e70d7eec",
       {"geometry_msgs/TransformStamped", "std_msgs/Header", "geometry_msgs/Transform",
        "geometry_msgs/Vector3", "geometry_msgs/Quaternion"}},
      {RosType::pose,
       "geometry_msgs/PoseStamped",
       "d3812c3cbc69362b77dc0b19b345f8f5",
       {"std_msgs/Header", "geometry_msgs/Pose", "geometry_msgs/Point",
        "geometry_msgs/Quaternion"}},
  };
  return known;
}

const Known& known_type(RosType type) {
  for (const Known& known : known_types())
    if (known.type == type) return known;
  CHECK(!"a type that has a definition");
  return known_types().front();
}

constexpr std::string_view kScanGeometry =
    "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
    "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n";

// By the short name of the type, for ROS 2; only the header and the stamp in it differ in ROS 1.
std::string fields_of(std::string_view name, RosEncoding encoding) {
  static const std::map<std::string_view, std::string> fields{
      {"sensor_msgs/LaserScan",
       fmt::format("{}float32[] ranges\nfloat32[] intensities\n", kScanGeometry)},
      {"sensor_msgs/MultiEchoLaserScan",
       fmt::format("{}sensor_msgs/LaserEcho[] ranges\nsensor_msgs/LaserEcho[] intensities\n",
                   kScanGeometry)},
      {"sensor_msgs/LaserEcho", "float32[] echoes\n"},
      {"nav_msgs/Odometry",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
       "geometry_msgs/TwistWithCovariance twist\n"},
      {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
      {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
      {"geometry_msgs/TransformStamped",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
      {"geometry_msgs/Transform",
       "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
      {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
      {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n"},
      {"geometry_msgs/Pose",
       "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
      {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
      {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
  };
  if (name == "std_msgs/Header")
    return encoding == RosEncoding::ros1 ? "uint32 seq\ntime stamp\nstring frame_id\n"
                                         : "builtin_interfaces/Time stamp\nstring frame_id\n";
  return fields.at(name);
}

// The text of a definition, cut into the types that it tells.
struct Definition {
  std::string_view main;
  std::map<std::string, std::string_view> parts;  // by their names without the package
};

std::string last_name(std::string_view type) {
  return std::string(type.substr(type.rfind('/') + 1));
}

Definition parts_of(std::string_view text) {
  Definition result;
  std::string_view* open = &result.main;
  const char* begin = text.data();
  const auto close = [&](const char* end) {
    if (open != nullptr) *open = {begin, static_cast<std::size_t>(end - begin)};
  };
  while (!text.empty()) {
    const char* const line_begin = text.data();
    std::string_view line = without_blanks(next_line(text));
    if (!line.starts_with("====")) continue;
    close(line_begin);
    open = nullptr;
    line = without_blanks(next_line(text));
    begin = text.data();
    if (line.starts_with("MSG:")) open = &result.parts[last_name(without_blanks(line.substr(4)))];
  }
  close(text.data());
  return result;
}

// Writes the fields one a line, those of types within as "header.stamp".
class FieldList {
 public:
  explicit FieldList(const Definition& definition) : definition_(definition) {}

  std::string text() {
    add(definition_.main, "", 0);
    return text_;
  }

 private:
  static constexpr int kDeepest = 8;
  static constexpr std::size_t kLongest = 1 << 14;  // [bytes]

  void add(std::string_view fields, const std::string& prefix, int depth) {
    while (!fields.empty() && text_.size() < kLongest) {
      std::string_view line = next_line(fields);
      line = line.substr(0, line.find('#'));
      const std::string_view type = next_word(line);
      const std::string_view name = next_word(line);
      const bool is_constant = line.find('=') != line.npos || name.find('=') != name.npos;
      if (!type.empty() && !is_constant) add_field(type, prefix + std::string(name), depth);
    }
  }

  void add_field(std::string_view type, const std::string& name, int depth) {
    const std::size_t bracket = std::min(type.find('['), type.size());
    std::string base = last_name(type.substr(0, bracket));
    if (base == "Time") base = "time";  // of ROS 2
    const auto found = definition_.parts.find(base);
    text_ += fmt::format("{}{} {}\n", base, type.substr(bracket), name);
    if (found != definition_.parts.end() && depth < kDeepest)
      add(found->second, name + ".", depth + 1);
  }

  const Definition& definition_;
  std::string text_;
};

std::string field_list(std::string_view definition) {
  const Definition parts = parts_of(definition);
  return FieldList(parts).text();
}

}  // namespace

std::string short_type_name(std::string_view type) {
  std::string name(type);
  const std::size_t middle = name.find("/msg/");
  if (middle != name.npos) name.erase(middle, 4);
  return name;
}

RosType ros_type_of(std::string_view type) {
  const std::string name = short_type_name(type);
  if (name == "tf/tfMessage") return RosType::transforms;  // before tf2, with the same fields
  for (const Known& known : known_types())
    if (known.name == name) return known.type;
  return RosType::other;
}

std::string_view type_name_of(RosType type) {
  return known_type(type).name;
}

std::string_view md5sum_of(RosType type) {
  return known_type(type).md5sum;
}

std::string definition_of(RosType type, RosEncoding encoding) {
  const Known& known = known_type(type);
  std::string text = fields_of(known.name, encoding);
  const auto add = [&](std::string_view part) {
    text += fmt::format("{:=<80}\nMSG: {}\n{}", "", part, fields_of(part, encoding));
  };
  for (const std::string_view part : known.parts) add(part);
  if (encoding == RosEncoding::cdr) add("builtin_interfaces/Time");
  return text;
}

bool has_fields_of(RosType type, RosEncoding encoding, std::string_view definition) {
  constexpr std::size_t kLongest = 1 << 16;  // [bytes] no definition of ROS is so long
  return definition.size() <= kLongest &&
         field_list(definition) == field_list(definition_of(type, encoding));
}

}  // namespace mapbed
