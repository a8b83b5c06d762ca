#include "bench/scenario/journal.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/file/csv_file.h"
#include "core/file/hash.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::size_t kChecksum = 16;  // [hexadecimal digits]
constexpr std::size_t kFixedFields = 11;

std::string with_checksum(const std::string& line) {
  return sha256(line).substr(0, kChecksum) + "," + line;
}

std::string line_of(const Journal::Entry& entry) {
  CsvRow row{fmt::to_string(entry.row.run),
             fmt::to_string(entry.row.seed),
             csv_number(entry.cost.seconds),
             csv_number(entry.cost.recording_seconds),
             csv_number(entry.cost.method_seconds),
             csv_number(entry.cost.recorded_seconds),
             csv_number(entry.cost.peak_memory),
             csv_number(entry.cost.method_wall_seconds),
             csv_number(entry.cost.program_memory),
             entry.given,
             entry.row.failure};
  for (const double value : entry.row.values) row.push_back(csv_number(value));
  return csv_line(row);
}

// None where somebody wrote something else, whatever the checksum.
std::optional<Journal::Entry> entry_of(const CsvRow& row) {
  Journal::Entry entry;
  const bool has_run = parse_number(row[0], entry.row.run);
  const bool has_seed = parse_number(row[1], entry.row.seed);
  if (!has_run || !has_seed || entry.row.run < 0) return std::nullopt;
  entry.cost.run = entry.row.run;
  entry.cost.seconds = parse_csv_number(row[2]);
  entry.cost.recording_seconds = parse_csv_number(row[3]);
  entry.cost.method_seconds = parse_csv_number(row[4]);
  entry.cost.recorded_seconds = parse_csv_number(row[5]);
  entry.cost.peak_memory = parse_csv_number(row[6]);
  entry.cost.method_wall_seconds = parse_csv_number(row[7]);
  entry.cost.program_memory = parse_csv_number(row[8]);
  entry.given = row[9];
  entry.row.failure = row[10];
  for (std::size_t i = kFixedFields; i < row.size(); ++i) {
    entry.row.values.push_back(parse_csv_number(row[i]));
  }
  return entry;
}

// The line that begins there, with its end, where it is whole and its checksum right; else empty.
std::string_view valid_line(std::string_view text, std::size_t begin) {
  const std::size_t end = text.find('\n', begin);
  if (end == std::string_view::npos) return {};
  const std::string_view line = text.substr(begin, end + 1 - begin);
  if (line.size() <= kChecksum + 1) return {};
  return line == with_checksum(std::string(line.substr(kChecksum + 1))) ? line : std::string_view();
}

// As it stands on the disk: it is written on at its end, so no byte is skipped or unpacked.
std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// What is whole of a journal.
struct Content {
  std::string identity;  // empty: not even the head is
  std::vector<Journal::Entry> entries;
  std::size_t size = 0;  // [bytes]
};

Content content_of(const std::string& path, const std::string& text, std::size_t metrics) {
  Content content;
  std::string_view line;
  while (!(line = valid_line(text, content.size)).empty()) {
    const CsvRow row = parse_csv(path, line.substr(kChecksum + 1)).front();
    const bool is_head = content.size == 0;
    content.size += line.size();
    if (is_head) {
      content.identity = row.front();
      continue;
    }
    const auto entry = row.size() == kFixedFields + metrics ? entry_of(row) : std::nullopt;
    if (entry) content.entries.push_back(*entry);
  }
  return content;
}

}  // namespace

std::string Journal::identity_of(const std::string& path) {
  const std::string text = text_of(path);
  const std::string_view line = valid_line(text, 0);
  return line.empty() ? "" : parse_csv(path, line.substr(kChecksum + 1)).front().front();
}

Journal::Journal(const std::string& path, const std::string& identity, std::size_t metrics)
    : path_(path) {
  Content content = content_of(path, text_of(path), metrics);
  if (content.size > 0 && content.identity != identity) {
    throw InputError({path}, "these unfinished runs are of another configuration or program",
                     "--restart throws them away, --out chooses another folder");
  }
  file_ = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_APPEND, 0644);
  if (file_ < 0) {
    throw InputError({path}, std::string("cannot be written: ") + std::strerror(errno),
                     "choose another folder with --out");
  }
  found_ = std::move(content.entries);
  size_ = static_cast<off_t>(content.size);
  if (ftruncate(file_, size_) != 0) {  // what is not whole
    throw InputError({path_}, std::string("cannot be written: ") + std::strerror(errno));
  }
  if (size_ == 0) write_line(identity + "\n");
}

Journal::~Journal() {
  close(file_);
}

std::vector<Journal::Entry> Journal::entries_of(const std::string& path, std::size_t metrics) {
  return content_of(path, text_of(path), metrics).entries;
}

void Journal::append(const Entry& entry) {
  write_line(line_of(entry));
}

// One call a line: a program that is killed leaves whole lines, and at most one torn one.
void Journal::write_line(const std::string& line) {
  const std::string text = with_checksum(line);
  const std::scoped_lock lock(mutex_);
  const ssize_t written = write(file_, text.data(), text.size());
  if (written == static_cast<ssize_t>(text.size())) {
    size_ += written;
    return;
  }
  const std::string reason = written < 0 ? std::strerror(errno) : "the disk is full";
  // Lines of other threads behind a torn one would be lost with it.
  (void)!ftruncate(file_, size_);
  throw InputError({path_}, "cannot be written: " + reason,
                   "make room and start again; the runs so far are kept");
}

}  // namespace mapbed
