#include "bench/experiments/rfid_reads/reads_file.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::size_t kFields = 9;

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double number_of(std::string_view text, const std::string& what, const SourceLocation& place) {
  Tokens tokens(text);
  const double value = tokens.number();
  if (!tokens.ok() || !tokens.at_end() || !std::isfinite(value)) {
    throw InputError(place, what + " is " + in_quotes(text) + ", no number");
  }
  return value;
}

std::array<double, 2> pair_of(std::string_view text, const std::string& what,
                              const SourceLocation& place) {
  const auto parts = parts_of(text, ';');
  if (parts.size() != 2) {
    throw InputError(place,
                     what + " is " + in_quotes(text) + ", not one number for each of two ports",
                     "write them as '-70.5;-81.0'");
  }
  return {number_of(parts[0], what, place), number_of(parts[1], what, place)};
}

// "ANT3" is 2.
int antenna_of(std::string_view text, const SourceLocation& place) {
  constexpr double kMost = 64.0;
  const std::string reason = "the antenna is " + in_quotes(text) + ", not ANT1, ANT2, …";
  if (!text.starts_with("ANT")) throw InputError(place, reason);
  const double number = number_of(text.substr(3), "the antenna's number", place);
  if (number < 1.0 || number > kMost || number != std::floor(number)) {
    throw InputError(place, reason);
  }
  return static_cast<int>(number) - 1;
}

// A row by itself; place and tag are by what was met first.
struct Row {
  Eigen::Vector3d place;
  std::string tag;
  PlacedRead read;
};

Row row_of(std::string_view line, const SourceLocation& place) {
  const auto fields = parts_of(line, ',');
  if (fields.size() != kFields) {
    throw InputError(place, "there are " + std::to_string(fields.size()) + " fields, not nine",
                     "a read is tag_x,tag_y,tag_z,t_ms,antenna,freq_MHz,epc,rssi;rssi,phase;phase");
  }
  Row row;
  row.place = {number_of(fields[0], "tag_x", place), number_of(fields[1], "tag_y", place),
               number_of(fields[2], "tag_z", place)};
  number_of(fields[3], "the time", place);
  row.read.antenna = antenna_of(fields[4], place);
  if (fields[5] != "None") {
    row.read.frequency = 1e6 * number_of(fields[5], "the frequency", place);
    if (*row.read.frequency < 1e8 || *row.read.frequency > 1e10) {
      throw InputError(place, "the frequency is " + in_quotes(fields[5]) + " MHz",
                       "it is between 100 and 10000 MHz, or None");
    }
  }
  row.tag = fields[6];
  if (row.tag.empty()) throw InputError(place, "the tag has no name");
  row.read.strength = pair_of(fields[7], "the RSSI", place);
  row.read.phase = pair_of(fields[8], "the phase", place);
  for (double& phase : row.read.phase) phase = radians(phase);
  return row;
}

}  // namespace

PlacedReads parse_reads(const std::string& name, std::string_view text) {
  const auto before = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
  };
  std::map<Eigen::Vector3d, int, decltype(before)> places(before);
  std::map<std::string, int> tags;
  std::vector<Row> rows;
  next_line(text);
  for (long line = 2; !text.empty(); ++line) {
    const std::string_view content = next_line(text);
    if (without_blanks(content).empty()) continue;
    rows.push_back(row_of(content, {name, line}));
    places[rows.back().place] = 0;
    tags[rows.back().tag] = 0;
  }
  if (rows.empty()) throw InputError({name}, "there are no reads");
  PlacedReads result;
  for (auto& [place, number] : places) {
    number = static_cast<int>(result.places.size());
    result.places.push_back(place);
  }
  for (auto& [tag, number] : tags) {
    number = static_cast<int>(result.tags.size());
    result.tags.push_back(tag);
  }
  for (Row& row : rows) {
    row.read.place = places.at(row.place);
    row.read.tag = tags.at(row.tag);
    result.antennas = std::max(result.antennas, row.read.antenna + 1);
    result.reads.push_back(row.read);
  }
  return result;
}

PlacedReads load_reads(const std::string& path) {
  return parse_reads(path, read_text_file(path));
}

const PlacedReads& ReadsFiles::at(const std::string& path) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = by_path_.find(path);
  if (found != by_path_.end()) return found->second;
  return by_path_.emplace(path, load_reads(path)).first->second;
}

}  // namespace mapbed
