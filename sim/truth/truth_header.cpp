#include "sim/truth/truth_header.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/file/tokens.h"

namespace mapbed {
namespace {

constexpr std::string_view kFirstLine = "MAPBED TRUTH 2";
constexpr long kMostLines = 1'000'000;
constexpr int kKinds = 9;  // of EntityKind

// On one line, whatever somebody called it.
std::string printable(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
  return name;
}

// All after the one blank that ends the word before.
std::string rest_of(std::string_view line) {
  return std::string(line.starts_with(' ') ? line.substr(1) : line);
}

}  // namespace

std::string header_text(const TruthHeader& header) {
  std::string text = fmt::format("{}\nWORLD {}\nROBOT {}\n", kFirstLine, printable(header.world),
                                 printable(header.robot));
  for (std::size_t i = 0; i < header.materials.size(); ++i) {
    text += fmt::format("MATERIAL {} {}\n", i, printable(header.materials[i]));
  }
  for (const TruthTag& tag : header.tags) {
    const Eigen::Vector3d& p = tag.world_from_tag.position;
    const Eigen::Quaterniond& q = tag.world_from_tag.rotation;
    text += fmt::format("TAG {} {} {} {} {} {} {} {} {}\n", printable(tag.id), p.x(), p.y(), p.z(),
                        q.x(), q.y(), q.z(), q.w(), tag.material);
  }
  for (const TruthEntity& e : header.entities) {
    text += fmt::format("ENTITY {} {} {}\n", e.id, name_of(e.kind), printable(e.name));
    for (std::size_t i = 0; i < e.parts.size(); ++i) {
      text += fmt::format("PART {} {} {}\n", e.id, i, printable(e.parts[i]));
    }
  }
  return text + "BLOCKS\n";
}

bool TruthHeaderReader::take(std::string_view line, bool is_whole) {
  ++place_.line;
  const bool is_first = place_.line == 1;
  if (is_first && (is_whole || !line.empty())) check_first_line(line);
  if (!is_whole) fail("the file ends before its blocks");
  if (place_.line > kMostLines) fail("a header of more than a million lines");
  if (is_first) return false;
  const std::string_view key = next_word(line);
  if (key == "BLOCKS") return true;
  if (key == "WORLD") {
    header.world = rest_of(line);
  } else if (key == "ROBOT") {
    header.robot = rest_of(line);
  } else if (key == "MATERIAL") {
    expect_index(line, header.materials.size());
    header.materials.push_back(rest_of(line));
  } else if (key == "ENTITY") {
    expect_index(line, header.entities.size());
    TruthEntity& entity = header.entities.emplace_back();
    entity.id = static_cast<int>(header.entities.size()) - 1;
    entity.kind = kind_of(next_word(line));
    entity.name = rest_of(line);
  } else if (key == "PART") {
    if (header.entities.empty()) fail("a part before any entity");
    TruthEntity& entity = header.entities.back();
    expect_index(line, static_cast<std::size_t>(entity.id));
    expect_index(line, entity.parts.size());
    entity.parts.push_back(rest_of(line));
  } else if (key == "TAG") {
    header.tags.push_back(tag_in(line));
  } else {
    fail("unknown line " + in_quotes(key));
  }
  return false;
}

void TruthHeaderReader::fail(const std::string& reason) const {
  throw InputError(place_, reason, "record it again with 'mapbed simulate'");
}

void TruthHeaderReader::check_first_line(std::string_view line) const {
  if (line == kFirstLine) return;
  if (line == "TRUTH 1") fail("a truth file of an older version, which was all text");
  if (line.starts_with("MAPBED TRUTH ")) fail("a truth file of another version");
  fail("not a truth file");
}

// Things are numbered on from 0.
void TruthHeaderReader::expect_index(std::string_view& line, std::size_t expected) const {
  const std::string_view word = next_word(line);
  if (word == std::to_string(expected)) return;
  fail(fmt::format("{} stands where {} comes next", in_quotes(word), expected));
}

TruthTag TruthHeaderReader::tag_in(std::string_view line) const {
  TruthTag tag;
  tag.id = std::string(next_word(line));
  std::array<double, 7> pose{};
  bool is_whole = !tag.id.empty();
  for (double& value : pose) is_whole = is_whole && parse_number(next_word(line), value);
  int material = -1;
  is_whole = is_whole && parse_number(next_word(line), material);
  const auto materials = static_cast<int>(header.materials.size());
  const auto& [x, y, z, qx, qy, qz, qw] = pose;
  const Eigen::Quaterniond rotation(qw, qx, qy, qz);
  tag.world_from_tag = {{x, y, z}, rotation};
  tag.material = material;
  const bool makes_sense = is_whole && is_finite(tag.world_from_tag) &&
                           std::abs(rotation.norm() - 1.0) < 1e-6 && material >= -1 &&
                           material < materials;
  if (!makes_sense) fail("a tag's line that does not say where it is");
  return tag;
}

EntityKind TruthHeaderReader::kind_of(std::string_view name) const {
  for (int k = 0; k < kKinds; ++k) {
    if (name_of(static_cast<EntityKind>(k)) == name) return static_cast<EntityKind>(k);
  }
  fail("unknown kind " + in_quotes(name) + " of an entity");
}

}  // namespace mapbed
