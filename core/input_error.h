#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace mapbed {

// Where a wrong input stands. `line` counts from 1; 0 where there is no line to name.
struct SourceLocation {
  std::string file;
  long line = 0;
};

// Somebody gave us a wrong file or option. what() is one line: place, reason, remedy, as in
//   scenarios/x.yaml:9: unknown key 'rotaton_sigma' in robot.odometry; did you mean
//   'rotation_sigma'?
// Thrown by loaders; main prints it and returns 1.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  InputError(const SourceLocation& place, const std::string& reason,
             const std::string& remedy = {});
};

// 'text' in quotes, for messages: on one line, without control characters, not too long.
std::string in_quotes(std::string_view text);

}  // namespace mapbed
