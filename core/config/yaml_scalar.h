#pragma once

#include <string>
#include <string_view>

namespace mapbed {

// A text as a YAML value that reads back as this text, inside brackets too: bare where that is
// safe ("2 cm"), else in double quotes ("\"a: b\"").
std::string yaml_scalar(std::string_view text);

}  // namespace mapbed
