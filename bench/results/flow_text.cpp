#include "bench/results/flow_text.h"

#include "core/config/yaml_scalar.h"

namespace mapbed {

std::string flow_list(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) {
    result += (result.empty() ? "" : ", ") + yaml_scalar(text);
  }
  return "[" + result + "]";
}

std::string flow_map(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string result;
  for (const auto& [key, value] : entries) {
    if (!value.empty()) result += (result.empty() ? "" : ", ") + key + ": " + value;
  }
  return "{" + result + "}";
}

std::string flow_scalar(const std::string& text) {
  return text.empty() ? "" : yaml_scalar(text);
}

}  // namespace mapbed
