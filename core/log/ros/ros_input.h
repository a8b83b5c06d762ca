#pragma once

#include <string_view>
#include <vector>

#include "core/log/ros/byte_input.h"

namespace mapbed {

// How the fields of a message stand in its bytes. Both little-endian, one field after the other.
enum class RosEncoding : int {
  ros1,   // without gaps
  cdr,    // of ROS 2: four bytes that name it, numbers at multiples of their size, strings end in 0
  other,  // JSON, protobuf, …: not read here
};

// [s] The nearest to so many nanoseconds.
constexpr double seconds_of(std::int64_t nanoseconds) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  constexpr std::int64_t kWhole = std::int64_t{1} << 53;  // that a double has to the last one
  if (nanoseconds > -kWhole && nanoseconds < kWhole) return static_cast<double>(nanoseconds) / 1e9;
  return static_cast<double>(nanoseconds / kSecond) +
         static_cast<double>(nanoseconds % kSecond) / 1e9;
}

// Fields of a message in the order of its definition. As ByteInput: after the end ok() is false.
class RosInput {
 public:
  RosInput(std::string_view bytes, RosEncoding encoding);

  bool ok() const { return input_.ok() && !is_foreign_; }
  // What its first bytes name is not little-endian CDR.
  bool is_foreign() const { return is_foreign_; }
  bool is_cdr() const { return is_cdr_; }
  bool is_at_end() const;  // but for the padding that CDR may have

  template <class T>
  T number() {
    align(sizeof(T));
    return input_.number<T>();
  }
  std::string_view text();
  double stamp();        // [s]
  void skip_sequence();  // the number that a ROS 1 header begins with
  // The number of elements that follow, of which each takes at least so many bytes.
  std::size_t count(std::size_t least_bytes);
  std::vector<double> floats();  // a counted list of 32-bit numbers, as unrounded.h reads them
  void skip_doubles(std::size_t count);

 private:
  void align(std::size_t size);

  ByteInput input_;
  bool is_cdr_ = false;
  bool is_foreign_ = false;
};

}  // namespace mapbed
