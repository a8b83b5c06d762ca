// Whatever the bytes: parse_config gives a tree or an InputError, and what it gives reads back.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/check.h"
#include "core/config/config_node.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view yaml(reinterpret_cast<const char*>(data), size);
  try {
    const mapbed::ConfigNode tree = mapbed::parse_config(yaml, {"fuzz.yaml", 1});
    if (tree.kind() != mapbed::ConfigNode::Kind::value) {
      const std::string text = tree.flow_text();
      CHECK(mapbed::parse_config(text, {"again.yaml", 1}).flow_text() == text);
    }
    (void)mapbed::settings_of(tree);
  } catch (const mapbed::InputError&) {
  }
  return 0;
}
