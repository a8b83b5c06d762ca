#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/file/file_reader.h"
#include "core/log/log_file.h"

namespace mapbed {

// The reader of a dialect: takes the bytes of a log piece by piece.
class LogReader {
 public:
  virtual ~LogReader() = default;
  virtual void add(std::string_view piece) = 0;  // cut anywhere, valid during the call only
  virtual RecordedLog finish() = 0;              // once, at the end; throws InputError
};

// The same of a dialect of text, with a message a line.
class LogLineReader : public LogReader {
 public:
  explicit LogLineReader(const std::string& name) : lines_(name) {}
  void add(std::string_view piece) final;
  RecordedLog finish() final;

 protected:
  virtual void add_line(std::string_view line, long number) = 0;  // without its line end
  virtual RecordedLog finish_lines() = 0;

 private:
  LineSplitter lines_;
  long number_ = 0;
};

// What a log begins with, by which its dialect is told.
struct LogBeginning {
  std::string_view bytes;   // as they stand in the file, at most 16 MiB
  std::string_view header;  // of a text: all comments before
  std::string_view line;    // the first line that says something; empty where it is not text
};

// A way of writing logs. A new one is a pair of files in dialects/ and a line in the table.
struct LogDialect {
  const char* name = "";  // "CARMEN"
  bool (*fits)(const LogBeginning& beginning) = nullptr;
  std::unique_ptr<LogReader> (*make_reader)(const std::string& name,
                                            const LogOptions& options) = nullptr;
  bool is_bag = false;  // not text; only what is used of it takes memory
};

}  // namespace mapbed
