#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mapbed {

// YAML on one line.

std::string flow_list(const std::vector<std::string>& texts);  // "[a, 'b c']"

// "{key: value, …}" of the values that are not empty. They stand as they are given: a text that may
// be anything goes through flow_scalar.
std::string flow_map(const std::vector<std::pair<std::string, std::string>>& entries);

std::string flow_scalar(const std::string& text);  // quoted where it must be; empty stays empty

}  // namespace mapbed
