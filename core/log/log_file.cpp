#include "core/log/log_file.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/core.h>

#include "core/file/file_reader.h"
#include "core/file/tokens.h"
#include "core/log/bags/bag_file.h"
#include "core/log/bags/bag_folder.h"
#include "core/log/dialects/dialects.h"

namespace mapbed {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kLongestBeginning = 16u << 20;  // [bytes]

// Some editors write it in front of UTF-8 text.
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf"sv;

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
                                       const LogOptions& options, bool& is_bag) {
  const LogBeginning beginning = beginning_of(bytes);
  for (const LogDialect& dialect : log_dialects()) {
    if (dialect.fits(beginning)) {
      is_bag = dialect.is_bag;
      return dialect.make_reader(name, options);
    }
  }
  if (!is_text(bytes))
    throw InputError({name}, "is neither text nor a bag of ROS that is known here",
                     "logs are read as plain text, gzipped text, bags of ROS 1 and 2 and MCAP");
  if (beginning.line.empty())
    throw InputError({name}, "is empty", "a log has lines such as FLASER or ROBOTLASER1");
  refuse_unknown_text(name);
}

// The log's first seconds.
RecordedLog first_seconds_of(RecordedLog log, const std::string& name, double longest) {
  if (longest <= 0.0) return log;
  const double end = time_of(log.measurements.front()) + longest;
  std::erase_if(log.measurements, [end](const Measurement& m) { return time_of(m) > end; });
  std::erase_if(log.true_poses, [end](const Stamped<Pose2>& pose) { return pose.time > end; });
  const bool has_scan =
      std::any_of(log.measurements.begin(), log.measurements.end(),
                  [](const Measurement& m) { return !std::holds_alternative<Odometry>(m); });
  if (!has_scan) {
    throw InputError({name}, fmt::format("its first {:g} s hold no scan", longest),
                     "take more of it by log.longest");
  }
  return log;
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

  bool is_bag() const { return is_bag_; }  // of which only what is used takes memory

  RecordedLog finish() {
    if (!reader_) start();
    return first_seconds_of(reader_->finish(), name_, options_.longest);
  }

 private:
  void start() {
    if (beginning_.starts_with(kByteOrderMark)) beginning_.erase(0, kByteOrderMark.size());
    reader_ = make_reader(name_, beginning_, options_, is_bag_);
    reader_->add(beginning_);
    beginning_ = {};
  }

  std::string name_;
  LogOptions options_;
  std::string beginning_;  // until the reader is there
  std::unique_ptr<LogReader> reader_;
  bool is_bag_ = false;
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
  if (is_bag(path)) {
    BagLog bag(path, options);
    const std::string format = read_bag(path, bag, goes_on);
    return first_seconds_of(bag.finish(format), path, options.longest);
  }
  LogParser parser(path, options);
  FileReader file(files_of_log(path).front());
  double total = 0.0;
  for (std::string_view piece = file.next(); !piece.empty(); piece = file.next()) {
    throw_unless(goes_on);
    total += static_cast<double>(piece.size());
    if (total > options.max_text && !parser.is_bag())
      throw InputError({path}, fmt::format("unpacks to more than {} MB", options.max_text / 1e6),
                       "set max_text if the file is to be trusted");
    parser.add(piece);
  }
  return parser.finish();
}

std::vector<std::string> files_of_log(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return {path};
  std::vector<std::string> files = bag_folder(path).files;
  if (files.empty())
    throw InputError({path}, "is a folder without a bag in it",
                     "give the path of a log, or the folder into which ROS 2 has recorded");
  const fs::path metadata = fs::path(path) / "metadata.yaml";
  if (fs::is_regular_file(metadata, ignored)) files.push_back(metadata.string());
  return files;
}

std::optional<BagContents> bag_contents(const std::string& path) {
  if (!is_bag(path)) return {};
  BagLog bag(path, {});
  bag.count_only();
  return bag.contents(read_bag(path, bag));
}

RecordedLog parse_log(const std::string& name, std::string_view text, const LogOptions& options) {
  LogParser parser(name, options);
  parser.add(text);
  return parser.finish();
}

}  // namespace mapbed
