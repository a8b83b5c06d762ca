#include "core/log/log_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/core.h>

#include "core/file/fields.h"
#include "core/file/text_blocks.h"
#include "core/log/dialects/carmen_log.h"
#include "core/log/dialects/coreslam_log.h"
#include "core/log/dialects/dpslam_log.h"
#include "core/log/dialects/scan_list_log.h"

namespace mapbed {
namespace {

using namespace std::string_view_literals;

// Some editors write it in front of UTF-8 text.
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf"sv;

[[noreturn]] void refuse_bag(const std::string& name, const char* ros) {
  throw InputError({name}, fmt::format("is a {} bag, which is not read here", ros),
                   "write its scans and odometry out as a CARMEN log (FLASER or ROBOTLASER1 "
                   "lines) or as `t n ranges` lines, for example with the Python package rosbags");
}

// ROS 2 records into a folder.
void refuse_bag_folder(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return;
  for (const auto& entry : std::filesystem::directory_iterator(path, ignored)) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".db3" || kind == ".mcap") refuse_bag(path, "ROS 2");
  }
}

void refuse_binary(const std::string& name, std::string_view text) {
  if (text.starts_with("#ROSBAG"sv)) refuse_bag(name, "ROS 1");
  if (text.starts_with("SQLite format 3"sv) || text.starts_with("\x89MCAP0\r\n"sv))
    refuse_bag(name, "ROS 2");
  if (text.substr(0, 4096).find('\0') != std::string_view::npos)
    throw InputError({name}, "is no text", "logs are read as plain text or gzipped text");
}

// The first line that says something, after the comments.
struct Beginning {
  std::string_view header;  // all comments before it
  std::string_view line;
};

Beginning beginning_of(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    const std::size_t word = line.find_first_not_of(" \t\r");
    if (word != std::string_view::npos && line[word] != '#')
      return {text.substr(0, at), line.substr(word)};
    at = end + 1;
  }
  return {text, {}};
}

std::size_t fields_in(std::string_view line) {
  Fields fields(line);
  std::size_t count = 0;
  for (; !fields.at_end(); ++count) fields.word();
  return count;
}

// `t n r…` with as many ranges as it says.
bool is_scan_list(std::string_view line) {
  Fields fields(line);
  fields.number();
  const std::size_t n = fields.count();
  return fields.ok() && n > 0 && fields_in(fields.characters()) == n;
}

std::unique_ptr<LogReader> make_reader(const std::string& name, std::string_view text,
                                       const LogOptions& options) {
  refuse_binary(name, text);
  const Beginning beginning = beginning_of(text);
  if (beginning.line.empty())
    throw InputError({name}, "is empty", "a log has lines such as FLASER or ROBOTLASER1");
  const std::string_view word = beginning.line.substr(0, beginning.line.find_first_of(" \t\r"));
  if (word == "Odometry" || word == "Laser") return make_dpslam_reader(name, options);
  if (std::isupper(static_cast<unsigned char>(word[0])) != 0)
    return make_carmen_reader(name, options);
  double number = 0.0;
  if (read_number(word.data(), word.data() + word.size(), number) == word.data() + word.size()) {
    const bool has_header = beginning.header.find("angle_min") != std::string_view::npos;
    if (has_header || is_scan_list(beginning.line)) return make_scan_list_reader(name, options);
    if (fields_in(beginning.line) > 600) return make_coreslam_reader(name, options);
  }
  throw InputError({name}, "is in no log format that is known here",
                   "known are CARMEN, CoreSLAM, DP-SLAM and `t n ranges` with a header line");
}

// The log's first seconds.
void keep_beginning(RecordedLog& log, const std::string& name, double longest) {
  if (longest <= 0.0) return;
  const double end = time_of(log.measurements.front()) + longest;
  std::erase_if(log.measurements, [end](const Measurement& m) { return time_of(m) > end; });
  std::erase_if(log.true_poses, [end](const Stamped<Pose2>& pose) { return pose.time > end; });
  const bool has_scan =
      std::any_of(log.measurements.begin(), log.measurements.end(),
                  [](const Measurement& m) { return std::holds_alternative<LaserScan>(m); });
  if (!has_scan) {
    throw InputError({name}, fmt::format("its first {:g} s hold no scan", longest),
                     "take more of it by log.longest");
  }
}

// Cuts blocks into lines and feeds them to the reader of the dialect.
class Splitter {
 public:
  Splitter(const std::string& name, const LogOptions& options) : name_(name), options_(options) {}

  void add(std::string_view text) {
    if (!reader_) {
      if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
      reader_ = make_reader(name_, text, options_);
    }
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      reader_->add_line(text.substr(0, end), ++line_);
      if (end == std::string_view::npos) break;
      text.remove_prefix(end + 1);
    }
  }

  RecordedLog finish() {
    if (!reader_) reader_ = make_reader(name_, {}, options_);
    RecordedLog log = reader_->finish();
    keep_beginning(log, name_, options_.longest);
    return log;
  }

 private:
  std::string name_;
  LogOptions options_;
  std::unique_ptr<LogReader> reader_;
  long line_ = 0;
};

}  // namespace

std::string to_string(const LogWarning& warning) {
  std::string text = warning.place.file;
  if (warning.place.line > 0) text += fmt::format(":{}", warning.place.line);
  text += ": " + warning.reason;
  if (warning.count > 1) text += fmt::format(" ({} times)", warning.count);
  return text;
}

RecordedLog load_log(const std::string& path, const LogOptions& options) {
  refuse_bag_folder(path);
  Splitter splitter(path, options);
  for_each_text_block(path, options.max_text, [&](std::string_view block) { splitter.add(block); });
  return splitter.finish();
}

RecordedLog parse_log(const std::string& name, std::string_view text, const LogOptions& options) {
  Splitter splitter(name, options);
  if (!text.empty()) splitter.add(text);
  return splitter.finish();
}

}  // namespace mapbed
