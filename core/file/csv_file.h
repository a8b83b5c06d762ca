#pragma once

#include <string>
#include <string_view>
#include <vector>

// Tables as text: CSV (RFC 4180) with "\n" at the ends of lines.

namespace mapbed {

using CsvRow = std::vector<std::string>;

std::string csv_line(const CsvRow& row);  // with its line end
std::string csv_text(const std::vector<CsvRow>& rows);

// Throws InputError, with the line, where quotes do not match or a row has another number of fields
// than the first; `name` is the file's.
std::vector<CsvRow> parse_csv(const std::string& name, std::string_view text);

// As many digits as it takes to read the same number back; empty for NaN.
std::string csv_number(double value);
double parse_csv_number(const std::string& text);  // NaN for an empty field and for anything else

}  // namespace mapbed
