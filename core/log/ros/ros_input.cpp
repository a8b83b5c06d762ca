#include "core/log/ros/ros_input.h"

#include "core/log/ros/unrounded.h"

namespace mapbed {

RosInput::RosInput(std::string_view bytes, RosEncoding encoding)
    : input_(bytes), is_cdr_(encoding == RosEncoding::cdr) {
  if (!is_cdr_) return;
  const std::string_view kind = input_.take(4);
  is_foreign_ = input_.ok() && (kind[0] != 0 || kind[1] != 1);
}

// Counted from behind the four bytes in front, of which there are thus none too many.
void RosInput::align(std::size_t size) {
  if (!is_cdr_) return;
  const std::size_t over = input_.position() % size;
  const std::size_t shift = (4 + size - over) % size;
  if (shift != 0) input_.take(shift);
}

bool RosInput::is_at_end() const {
  return input_.ok() && input_.left() < (is_cdr_ ? std::size_t{8} : std::size_t{1});
}

std::string_view RosInput::text() {
  std::string_view found = input_.take(number<std::uint32_t>());
  if (is_cdr_ && !found.empty() && found.back() == '\0') found.remove_suffix(1);
  return found;
}

double RosInput::stamp() {
  const std::int64_t seconds =
      is_cdr_ ? std::int64_t{number<std::int32_t>()} : std::int64_t{number<std::uint32_t>()};
  return seconds_of(1'000'000'000 * seconds + number<std::uint32_t>());
}

void RosInput::skip_sequence() {
  if (!is_cdr_) number<std::uint32_t>();
}

std::size_t RosInput::count(std::size_t least_bytes) {
  const std::size_t elements = number<std::uint32_t>();
  if (elements <= input_.left() / least_bytes) return elements;
  input_.take(input_.left() + 1);  // there are not so many: not ok from here on
  return 0;
}

std::vector<double> RosInput::floats() {
  const std::size_t elements = count(sizeof(float));
  std::vector<double> values(elements);
  const char* bytes = input_.take(elements * sizeof(float)).data();
  for (double& value : values) {
    float single = 0.0F;
    std::memcpy(&single, bytes, sizeof single);
    bytes += sizeof single;
    value = unrounded(single);
  }
  return values;
}

void RosInput::skip_doubles(std::size_t count) {
  align(sizeof(double));
  input_.take(count * sizeof(double));
}

}  // namespace mapbed
