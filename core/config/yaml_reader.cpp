#include <sstream>
#include <unordered_set>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "core/check.h"
#include "core/config/config_node.h"
#include "core/config/yaml_limit.h"
#include "core/file/text_file.h"

namespace mapbed {
namespace {

constexpr std::size_t kDeepest = 32;  // nested lists and maps
constexpr std::size_t kLongestKey = 200;

// Builds the tree of nodes from the parser's events. Aliases are refused rather than followed: they
// let ten lines stand for a billion values.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(const SourceLocation& start) : start_(start) {}

  // The whole document; an empty map if there was none.
  ConfigNode result() && {
    if (root_.empty()) return ConfigNode({}, {}, start_);
    return std::move(root_.front());
  }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    if (open_.empty()) return;  // nothing but comments
    const Open& parent = open_.back();
    if (parent.kind == ConfigNode::Kind::list) {
      throw InputError(at(mark), "an entry of the list has no value", "write one or take it out");
    }
    if (!parent.has_key) throw InputError(at(mark), "a value without a key");
    throw InputError(parent.key_place, "key " + in_quotes(parent.keys.back()) + " has no value",
                     "write one, or take the key out to get the default");
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse_anchor(mark); }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check_plain(mark, tag, anchor);
    if (expects_key()) {
      add_key(value, at(mark));
    } else {
      add(ConfigNode(value, at(mark)));
    }
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(ConfigNode::Kind::list, mark, tag, anchor);
  }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(ConfigNode::Kind::map, mark, tag, anchor);
  }

  void OnSequenceEnd() override {
    Open done = pop();
    add(ConfigNode(std::move(done.children), done.place));
  }

  void OnMapEnd() override {
    Open done = pop();
    add(ConfigNode(std::move(done.keys), std::move(done.children), done.place));
  }

  SourceLocation at(const YAML::Mark& mark) const {
    return {start_.file, start_.line + std::max(mark.line, 0)};
  }

 private:
  // A list or map whose end has not come yet.
  struct Open {
    ConfigNode::Kind kind = ConfigNode::Kind::value;
    SourceLocation place;
    std::vector<std::string> keys;
    std::vector<ConfigNode> children;
    std::unordered_set<std::string> seen;
    bool has_key = false;  // a key that waits for its value
    SourceLocation key_place;
  };

  bool expects_key() const {
    return !open_.empty() && open_.back().kind == ConfigNode::Kind::map && !open_.back().has_key;
  }

  void refuse_anchor(const YAML::Mark& mark) const {
    throw InputError(at(mark), "anchors and aliases (&name, *name) are not read here",
                     "write the value out, or in quotes if it is a text");
  }

  void check_plain(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
    if (anchor != 0) refuse_anchor(mark);
    if (tag.empty() || tag == "?" || tag == "!") return;  // none, bare, quoted
    throw InputError(at(mark), "the tag " + in_quotes(tag) + " is not read here", "take it out");
  }

  void add_key(const std::string& key, const SourceLocation& place) {
    Open& parent = open_.back();
    if (key.empty()) throw InputError(place, "an empty key");
    if (key.size() > kLongestKey)
      throw InputError(place, in_quotes(key) + " is too long for a key");
    if (!parent.seen.insert(key).second) {
      throw InputError(place, "key " + in_quotes(key) + " comes twice", "keep one of them");
    }
    parent.keys.push_back(key);
    parent.has_key = true;
    parent.key_place = place;
  }

  void add(ConfigNode node) {
    if (open_.empty()) {
      root_.push_back(std::move(node));
      return;
    }
    open_.back().children.push_back(std::move(node));
    open_.back().has_key = false;
  }

  void open(ConfigNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor) {
    check_plain(mark, tag, anchor);
    if (expects_key()) {
      throw InputError(at(mark), "a list or a map stands where a key should be",
                       "close every bracket and brace, put a text that has them in quotes");
    }
    if (open_.size() >= kDeepest) {
      throw InputError(at(mark),
                       "nested more than " + std::to_string(kDeepest) + " lists and maps deep");
    }
    Open& opened = open_.emplace_back();
    opened.kind = kind;
    opened.place = at(mark);
  }

  Open pop() {
    CHECK(!open_.empty());
    Open done = std::move(open_.back());
    open_.pop_back();
    return done;
  }

  SourceLocation start_;
  std::vector<Open> open_;
  std::vector<ConfigNode> root_;  // at most one
};

// Length of the UTF-8 sequence at the front of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xc2 && first < 0xe0 ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
  }
  return length;
}

void check_is_text(std::string_view yaml, const SourceLocation& start) {
  long line = start.line;
  for (std::size_t i = 0; i < yaml.size();) {
    const auto byte = static_cast<unsigned char>(yaml[i]);
    const bool blank = byte == '\n' || byte == '\r' || byte == '\t';
    const std::size_t length = utf8_length(yaml.substr(i));
    if (length == 0 || (byte < 0x20 && !blank) || byte == 0x7f) {
      throw InputError(SourceLocation{start.file, line},
                       "this is not text (byte " + std::to_string(byte) + ")",
                       "a configuration file is YAML in UTF-8");
    }
    if (byte == '\n') ++line;
    i += length;
  }
}

}  // namespace

ConfigNode parse_config(std::string_view yaml, const SourceLocation& place) {
  if (yaml.size() > kLargestYaml) {
    throw InputError(SourceLocation{place.file, 0}, "is larger than 8 MB",
                     "is it a configuration file?");
  }
  check_is_text(yaml, place);
  TreeBuilder builder(place);
  try {
    std::istringstream stream(std::string(yaml) + "\n");
    YAML::Parser parser(stream);
    if (parser.HandleNextDocument(builder)) {
      TreeBuilder second(place);
      if (parser.HandleNextDocument(second)) {
        throw InputError(place, "there is more than one YAML document", "take out the '---'");
      }
    }
  } catch (const YAML::Exception& error) {
    throw InputError(builder.at(error.mark), "this is not valid YAML: " + error.msg);
  }
  return std::move(builder).result();
}

ConfigNode load_config(const std::string& yaml_path) {
  return parse_config(read_text_file(yaml_path, kLargestYaml), {yaml_path, 1});
}

}  // namespace mapbed
