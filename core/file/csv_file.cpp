#include "core/file/csv_file.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr std::size_t kMostMemory = std::size_t{1} << 30;  // [bytes] of parsed fields

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

// Cuts the first row off `text`; `line` goes on to the one behind it.
CsvRow next_row(std::string_view& text, const std::string& name, long& line) {
  CsvRow row(1);
  const SourceLocation place{name, line};
  bool in_quotes = false;
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '\n') ++line;
    if (in_quotes && c == '"' && at + 1 < text.size() && text[at + 1] == '"') {
      row.back() += text[++at];
    } else if (c == '"') {
      in_quotes = !in_quotes;
    } else if (in_quotes) {
      row.back() += c;
    } else if (c == ',') {
      row.emplace_back();
    } else if (c == '\n') {
      break;
    } else if (c != '\r') {
      row.back() += c;
    }
  }
  if (in_quotes) throw InputError(place, "a quote is never closed");
  text.remove_prefix(std::min(text.size(), at + 1));
  return row;
}

}  // namespace

std::string csv_line(const CsvRow& row) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? "" : ",") + quoted(row[i]);
  return text + "\n";
}

std::string csv_text(const std::vector<CsvRow>& rows) {
  std::string text;
  for (const CsvRow& row : rows) text += csv_line(row);
  return text;
}

std::vector<CsvRow> parse_csv(const std::string& name, std::string_view text) {
  std::vector<CsvRow> rows;
  std::size_t memory = 0;
  for (long line = 1; !text.empty();) {
    const SourceLocation place{name, line};
    rows.push_back(next_row(text, name, line));
    memory += 2 * sizeof(CsvRow) + rows.back().size() * sizeof(std::string);
    if (memory > kMostMemory)
      throw InputError(place, "the table up to here takes more than 1 GB", "is it one of ours?");
    if (rows.back().size() != rows.front().size()) {
      throw InputError(place, fmt::format("{} fields where the first line has {}",
                                          rows.back().size(), rows.front().size()));
    }
  }
  return rows;
}

std::string csv_number(double value) {
  return std::isnan(value) ? std::string() : fmt::format("{}", value);
}

double parse_csv_number(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const bool is_number = !text.empty() && read_number(text.data(), end, value) == end;
  return is_number ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mapbed
