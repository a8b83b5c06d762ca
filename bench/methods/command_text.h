#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/input_error.h"

namespace mapbed {

// What stands in braces in a command, "{log}", and what takes its place.
using Placeholders = std::map<std::string, std::string>;

// The names in braces of a text, in their order. Braces around anything but a lower-case word are
// the text's own, as in a script of awk; "{{" and "}}" are single ones of the text.
std::vector<std::string> placeholders_in(const std::string& text);

// With their values in place. Each one must have a value.
std::string filled(const std::string& text, const Placeholders& values);

// The same for a shell's script: values in quotes, so that they are one word whatever is in them.
std::string filled_for_shell(const std::string& text, const Placeholders& values);

// Throws InputError where one of them is not in `known`, with the nearest one.
void check_placeholders(const std::string& text, const std::vector<std::string>& known,
                        const SourceLocation& place);

}  // namespace mapbed
