#include "sim/truth.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

// The lines, in this order; blanks between fields, names last since they may have blanks:
//   TRUTH 1
//   WORLD name
//   ROBOT name
//   MATERIAL index name
//   ENTITY id kind name
//   PART id index name
// and for every sweep
//   SCAN time laser robot_x robot_y robot_theta
//   AT entity x y theta moving                       one a tracked thing
//   BEAMS n range,entity,part,material,moving …      range inf and -1 where nothing was hit
// [m], [rad], [s]; moving 0 or 1.

namespace mapbed {
namespace {

constexpr int kVersion = 1;
constexpr int kKinds = 8;  // of EntityKind

EntityKind kind_by_name(std::string_view name, const SourceLocation& place) {
  for (int k = 0; k < kKinds; ++k) {
    if (name_of(static_cast<EntityKind>(k)) == name) return static_cast<EntityKind>(k);
  }
  throw InputError(place, "unknown kind '" + std::string(name) + "' of an entity",
                   "the file is damaged or of another version");
}

class Reader {
 public:
  Reader(const std::string& name, std::string_view text) : text_(text), place_{name, 0} {}

  Truth read() {
    while (!text_.empty()) {
      line_ = next_line(text_);
      ++place_.line;
      read_line();
    }
    if (!has_header_) fail("not a truth file");
    return std::move(truth_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(place_, reason, "write it again with 'mapbed simulate'");
  }

  double number(std::string_view word) const {
    if (word == "inf") return std::numeric_limits<double>::infinity();
    double value = 0.0;
    if (!parse_number(word, value)) fail("'" + std::string(word) + "' is no number");
    return value;
  }
  double number() { return number(next_word(line_)); }
  int integer(std::string_view word) const {
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) {
      fail("'" + std::string(word) + "' is no whole number");
    }
    return value;
  }
  int integer() { return integer(next_word(line_)); }
  std::string rest() {
    const std::size_t first = line_.find_first_not_of(' ');
    return first == std::string_view::npos ? std::string() : std::string(line_.substr(first));
  }
  Pose2 pose() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }
  TruthScan& scan() {
    if (truth_.scans.empty()) fail("no SCAN line before this");
    return truth_.scans.back();
  }

  void read_line() {
    const std::string_view key = next_word(line_);
    if (key.empty()) return;
    if (key == "TRUTH") {
      if (integer() != kVersion) fail("of another version");
      has_header_ = true;
      return;
    }
    if (!has_header_) fail("not a truth file");
    if (key == "WORLD") {
      truth_.world = rest();
    } else if (key == "ROBOT") {
      truth_.robot = rest();
    } else if (key == "MATERIAL") {
      integer();
      truth_.materials.push_back(rest());
    } else if (key == "ENTITY") {
      TruthEntity& entity = truth_.entities.emplace_back();
      entity.id = integer();
      entity.kind = kind_by_name(next_word(line_), place_);
      entity.name = rest();
    } else if (key == "PART") {
      if (truth_.entities.empty() || truth_.entities.back().id != integer()) {
        fail("a part of another entity than the last one");
      }
      integer();
      truth_.entities.back().parts.push_back(rest());
    } else if (key == "SCAN") {
      TruthScan& scan = truth_.scans.emplace_back();
      scan.time = number();
      scan.laser = integer();
      scan.world_from_robot = pose();
    } else if (key == "AT") {
      TrackedPose& at = scan().tracked.emplace_back();
      at.entity = integer();
      at.pose = pose();
      at.is_moving = integer() != 0;
    } else if (key == "BEAMS") {
      read_beams();
    } else {
      fail("unknown line '" + std::string(key) + "'");
    }
  }

  void read_beams() {
    const int count = integer();
    for (std::string_view word = next_word(line_); !word.empty(); word = next_word(line_)) {
      const auto next_field = [&word] {
        const std::size_t comma = word.find(',');
        const std::string_view field = word.substr(0, comma);
        word = comma == std::string_view::npos ? std::string_view() : word.substr(comma + 1);
        return field;
      };
      BeamTruth& beam = scan().beams.emplace_back();
      beam.range = static_cast<float>(number(next_field()));
      beam.entity = integer(next_field());
      beam.part = integer(next_field());
      beam.material = integer(next_field());
      beam.is_moving = integer(next_field()) != 0;
    }
    if (static_cast<int>(scan().beams.size()) != count) fail("the line was cut short");
  }

  std::string_view text_;
  std::string_view line_;
  SourceLocation place_;
  Truth truth_;
  bool has_header_ = false;
};

}  // namespace

bool TruthEntity::is_dynamic() const {
  return kind == EntityKind::person || kind == EntityKind::door || kind == EntityKind::vehicle ||
         kind == EntityKind::robot;
}

Trajectory trajectory_of(const Truth& truth) {
  Trajectory trajectory;
  for (const TruthScan& scan : truth.scans) {
    trajectory.push_back({scan.time, scan.world_from_robot});
  }
  return trajectory;
}

std::string truth_text(const Truth& truth) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "TRUTH {}\nWORLD {}\nROBOT {}\n", kVersion, truth.world, truth.robot);
  for (std::size_t i = 0; i < truth.materials.size(); ++i) {
    fmt::format_to(out, "MATERIAL {} {}\n", i, truth.materials[i]);
  }
  for (const TruthEntity& e : truth.entities) {
    fmt::format_to(out, "ENTITY {} {} {}\n", e.id, name_of(e.kind), e.name);
    for (std::size_t i = 0; i < e.parts.size(); ++i) {
      fmt::format_to(out, "PART {} {} {}\n", e.id, i, e.parts[i]);
    }
  }
  for (const TruthScan& s : truth.scans) {
    const Pose2& p = s.world_from_robot;
    fmt::format_to(out, "SCAN {:.6f} {} {:.6f} {:.6f} {:.7f}\n", s.time, s.laser, p.x, p.y,
                   p.theta);
    for (const TrackedPose& t : s.tracked) {
      fmt::format_to(out, "AT {} {:.4f} {:.4f} {:.5f} {:d}\n", t.entity, t.pose.x, t.pose.y,
                     t.pose.theta, t.is_moving);
    }
    fmt::format_to(out, "BEAMS {}", s.beams.size());
    for (const BeamTruth& b : s.beams) {
      fmt::format_to(out, " {:.5f},{},{},{},{:d}", b.range, b.entity, b.part, b.material,
                     b.is_moving);
    }
    fmt::format_to(out, "\n");
  }
  return fmt::to_string(text);
}

Truth parse_truth(const std::string& name, std::string_view text) {
  return Reader(name, text).read();
}

void write_truth(const std::string& path, const Truth& truth) {
  write_text_file(path, truth_text(truth));
}

Truth load_truth(const std::string& path) {
  return parse_truth(path, read_text_file(path, std::size_t{1} << 32));
}

}  // namespace mapbed
