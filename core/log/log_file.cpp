#include "core/log/log_file.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/core.h>

#include "core/file/file_reader.h"
#include "core/file/tokens.h"
#include "core/log/dialects/dialects.h"

namespace mapbed {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kLongestBeginning = 16u << 20;  // [bytes]

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

void refuse_bag_file(const std::string& name, std::string_view bytes) {
  if (bytes.starts_with("#ROSBAG"sv)) refuse_bag(name, "ROS 1");
  if (bytes.starts_with("SQLite format 3"sv) || bytes.starts_with("\x89MCAP0\r\n"sv))
    refuse_bag(name, "ROS 2");
}

bool is_text(std::string_view bytes) {
  return bytes.substr(0, 4096).find('\0') == std::string_view::npos;
}

LogBeginning beginning_of(std::string_view bytes) {
  if (!is_text(bytes)) return {bytes, {}, {}};
  std::string_view rest = bytes;
  while (!rest.empty()) {
    const auto at = static_cast<std::size_t>(rest.data() - bytes.data());
    const std::string_view line = without_blanks(next_line(rest));
    if (!line.empty() && line[0] != '#') return {bytes, bytes.substr(0, at), line};
  }
  return {bytes, bytes, {}};
}

// Whether more bytes would not change what is_text() and beginning_of() say.
bool is_complete(std::string_view bytes) {
  const LogBeginning beginning = beginning_of(bytes);
  return bytes.size() > kLongestBeginning || !is_text(bytes) ||
         (!beginning.line.empty() && bytes.find('\n', beginning.header.size()) != bytes.npos);
}

std::unique_ptr<LogReader> make_reader(const std::string& name, std::string_view bytes,
                                       const LogOptions& options) {
  refuse_bag_file(name, bytes);
  const LogBeginning beginning = beginning_of(bytes);
  std::string known;
  for (const LogDialect& dialect : log_dialects()) {
    if (dialect.fits(beginning)) return dialect.make_reader(name, options);
    known += (known.empty() ? "" : ", ") + std::string(dialect.name);
  }
  if (!is_text(bytes))
    throw InputError({name}, "is not text", "logs are read as plain text or gzipped text");
  if (beginning.line.empty())
    throw InputError({name}, "is empty", "a log has lines such as FLASER or ROBOTLASER1");
  throw InputError({name}, "is in no log format that is known here", "known are " + known);
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

// Tells the dialect by the first pieces and hands all of them to its reader.
class LogParser {
 public:
  LogParser(const std::string& name, const LogOptions& options) : name_(name), options_(options) {}

  void add(std::string_view piece) {
    if (reader_) return reader_->add(piece);
    beginning_ += piece;
    if (is_complete(beginning_)) start();
  }

  RecordedLog finish() {
    if (!reader_) start();
    RecordedLog log = reader_->finish();
    keep_beginning(log, name_, options_.longest);
    return log;
  }

 private:
  void start() {
    if (beginning_.starts_with(kByteOrderMark)) beginning_.erase(0, kByteOrderMark.size());
    reader_ = make_reader(name_, beginning_, options_);
    reader_->add(beginning_);
    beginning_ = {};
  }

  std::string name_;
  LogOptions options_;
  std::string beginning_;  // until the reader is there
  std::unique_ptr<LogReader> reader_;
};

}  // namespace

std::string to_string(const LogWarning& warning) {
  std::string text = warning.place.file;
  if (warning.place.line > 0) text += fmt::format(":{}", warning.place.line);
  text += ": " + warning.reason;
  if (warning.count > 1) text += fmt::format(" ({} times)", warning.count);
  return text;
}

RecordedLog load_log(const std::string& path, const LogOptions& options, const GoesOn& goes_on) {
  refuse_bag_folder(path);
  LogParser parser(path, options);
  FileReader file(path);
  double total = 0.0;
  for (std::string_view piece = file.next(); !piece.empty(); piece = file.next()) {
    throw_unless(goes_on);
    total += static_cast<double>(piece.size());
    if (total > options.max_text)
      throw InputError({path}, fmt::format("unpacks to more than {} MB", options.max_text / 1e6),
                       "set max_text if the file is to be trusted");
    parser.add(piece);
  }
  return parser.finish();
}

RecordedLog parse_log(const std::string& name, std::string_view text, const LogOptions& options) {
  LogParser parser(name, options);
  parser.add(text);
  return parser.finish();
}

}  // namespace mapbed
