#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/geometry/pose2.h"

namespace mapbed {

// A bag of ROS 1 for tests, put together byte by byte, by nothing that reads bags or writes logs.
class TestBag {
 public:
  struct Scan {
    double time = 0.0;  // [s]
    std::string frame = "laser";
    float angle_min = -1.0F;
    float angle_increment = 0.5F;
    float time_increment = 0.0F;
    float range_min = 0.0F;
    float range_max = 8.0F;
    std::vector<float> ranges = {1.0F, 2.0F, 3.0F, 2.0F, 1.0F};
    double recorded = 0.0;  // [s] 0: when it was taken
  };
  struct Transform {
    std::string parent, child;
    Pose2 pose;
    double roll = 0.0;  // [rad] turned by this after the heading
    double time = 0.0;  // [s]
  };

  TestBag& add(const std::string& topic, const Scan& scan);
  TestBag& add_transform(const std::string& topic, const Transform& transform);
  TestBag& add_odometry(const std::string& topic, double time, const Pose2& pose,
                        const std::string& child = "base_link");
  TestBag& add_pose(const std::string& topic, double time, const Pose2& pose);
  // Of a scan whose beams have several echoes.
  TestBag& add_echoes(const std::string& topic, double time,
                      const std::vector<std::vector<float>>& ranges,
                      const std::vector<std::vector<float>>& intensities);
  TestBag& add_raw(const std::string& topic, const std::string& type, const std::string& md5sum,
                   double time, const std::string& message);

  std::string bytes() const;       // in one chunk, with an index that nobody reads
  std::string records() const;     // of connections and messages, without the chunk
  static std::string beginning();  // the first line and the bag header
  static std::string chunk(const std::string& records, const std::string& packing = "none",
                           std::size_t size = 0);  // 0: that of the records
  // Of the chunk before; `told` is the length that it claims to have [bytes].
  static std::string index(std::uint32_t messages, std::uint32_t told);

 private:
  std::map<std::string, std::uint32_t> connections_;
  std::string records_;
};

}  // namespace mapbed
