#include "core/log/log_reader.h"

namespace mapbed {

void LogLineReader::add(std::string_view piece) {
  lines_.add(piece, [this](std::string_view line) { add_line(line, ++number_); });
}

RecordedLog LogLineReader::finish() {
  lines_.finish([this](std::string_view line) { add_line(line, ++number_); });
  return finish_lines();
}

}  // namespace mapbed
