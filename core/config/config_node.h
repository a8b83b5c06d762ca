#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/option.h"
#include "core/config/settings.h"
#include "core/input_error.h"

namespace mapbed {

// One node of a configuration file: a value, a list or a map, with the place where it stands.
//
//   const ConfigNode file = load_config("robots/b21r.yaml");
//   robot.drive = file.at("drive").choice({"differential", "synchro"});
//   for (const ConfigNode& entry : file.at("sensors").items()) {
//     SickLms& laser = robot.lasers.emplace_back();
//     laser.name = entry.at("name").text();
//     read_options(entry, options_of(laser));
//   }
//   file.check_all_used();
//
// Every reader throws InputError with file and line where the node is not what it asks for. A node
// remembers what was asked for, so that a key which nobody asked for is an error and not silently
// without effect; hence one node is not for several threads at a time.
class ConfigNode {
 public:
  enum class Kind { value, list, map };

  ConfigNode(std::string text, SourceLocation place);               // a value
  ConfigNode(std::vector<ConfigNode> items, SourceLocation place);  // a list
  // A map; keys and values go together and no key comes twice.
  ConfigNode(std::vector<std::string> keys, std::vector<ConfigNode> values, SourceLocation place);

  Kind kind() const { return kind_; }
  const SourceLocation& place() const { return place_; }

  // Values.
  const std::string& text() const;
  double number(Unit unit = Unit::none, const Bounds& bounds = kAnyValue) const;  // in SI
  int whole_number(const Bounds& bounds = kAnyValue) const;
  std::uint64_t unsigned_number(const Bounds& bounds = kAnyValue) const;
  bool flag() const;                                        // true or false
  int choice(const std::vector<std::string>& names) const;  // index into names

  // Lists.
  const std::vector<ConfigNode>& items() const;
  std::vector<std::string> texts() const;
  std::vector<double> numbers(Unit unit = Unit::none, const Bounds& bounds = kAnyValue) const;
  std::vector<int> whole_numbers(const Bounds& bounds = kAnyValue) const;

  // Maps. `keys` gives all keys in the order of the file and counts as asking for each of them.
  const ConfigNode& at(std::string_view key) const;    // InputError if missing
  const ConfigNode* find(std::string_view key) const;  // null if missing
  const std::vector<std::string>& keys() const;

  // Throws InputError on the first key, here or below, that nobody asked for, with the nearest one
  // of those that were. `context` names what this map describes.
  void check_all_used(const std::string& context = {}) const;
  void use_all() const;  // everything here and below counts as asked for

  // On one line, as YAML would read it again: "2 cm", "[1 cm, 2 cm]", "{x: 1 m}".
  std::string flow_text() const;

 private:
  void expect(Kind kind) const;

  Kind kind_;
  SourceLocation place_;
  std::string text_;
  std::vector<std::string> keys_;     // of a map
  std::vector<ConfigNode> children_;  // items of a list, values of a map
  mutable bool used_ = false;
  mutable std::vector<std::string> asked_;
};

// Reads a YAML file: one document, maps with unique keys, no anchors, aliases or tags, every key
// with a value. A file of comments only is an empty map. Throws InputError.
ConfigNode load_config(const std::string& yaml_path);

// The same from text; its first line stands at `place`.
ConfigNode parse_config(std::string_view yaml, const SourceLocation& place);

// Writes the node's values into the options they name. Keys that no option has are left for other
// readers; check_all_used refuses what is left in the end.
void read_options(const ConfigNode& node, const OptionList& options);

// All leaves as dotted paths, each counting as asked for. Throws InputError where two ways of
// writing ("a.b: 1" and "a: {b: 1}") say the same path twice.
Settings settings_of(const ConfigNode& node);

// The same of what stands under a key: one setting of that path, or those of a map below it.
Settings settings_of(const std::string& key, const ConfigNode& node);

}  // namespace mapbed
