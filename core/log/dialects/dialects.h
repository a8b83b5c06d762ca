#pragma once

#include <span>
#include <string>

#include "core/log/log_reader.h"

namespace mapbed {

// All dialects, in the order in which they are asked whether a log is theirs.
std::span<const LogDialect> log_dialects();

// Of a text that is of none of them; says which there are.
[[noreturn]] void refuse_unknown_text(const std::string& name);

}  // namespace mapbed
