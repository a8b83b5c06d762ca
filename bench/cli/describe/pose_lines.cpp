#include "bench/cli/describe/pose_lines.h"

#include "core/file/tokens.h"

namespace mapbed {

bool holds_pose_lines(std::string_view text) {
  while (!text.empty()) {
    std::string_view line = next_line(text);
    std::string_view word = next_word(line);
    if (word.empty() || word.starts_with('#')) continue;
    int count = 0;
    for (double number = 0.0; parse_number(word, number); word = next_word(line)) ++count;
    return word.empty() && (count == 4 || count == 8);
  }
  return false;
}

}  // namespace mapbed
