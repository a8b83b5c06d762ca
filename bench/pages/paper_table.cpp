#include "bench/pages/paper_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "bench/plot/axis.h"
#include "core/config/quantity.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

const std::string kNoValue = "\u2013";

std::vector<int> chosen_metrics(const Results& results, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Metric& metric : results.metrics) known.push_back(metric.name);
  std::vector<int> chosen;
  for (const std::string& name : names.empty() ? known : names) {
    chosen.push_back(metric_index(results, name));
    if (chosen.back() >= 0) continue;
    throw InputError({"--metric"}, in_quotes(name) + " is not measured in " + in_quotes(results.id),
                     suggestion(name, known));
  }
  return chosen;
}

std::string title_of(const Metric& metric) {
  const std::string unit = display_symbol(metric.unit);
  return words_of(metric.name) + (unit.empty() ? "" : " [" + unit + "]");
}

// "0.22 [0.21, 0.23]"; failures are told, as a mean is over the others.
std::string text_of(const SummaryRow& row, Unit unit) {
  if (row.runs == 0) return kNoValue;
  const auto number = [unit](double value) { return number_text(displayed(value, unit)); };
  std::string text = std::isnan(row.mean) ? kNoValue : number(row.mean);
  if (row.low < row.high && number(row.low) != number(row.high)) {
    text += " [" + number(row.low) + ", " + number(row.high) + "]";
  }
  if (row.failed > 0) text += fmt::format(" ({} failed)", row.failed);
  return text;
}

// The rows of a result's summary, by where they are.
class Cells {
 public:
  explicit Cells(const Results& results) : results_(results) {}

  std::string text(int level, int variant, int metric) const {
    for (const SummaryRow& row : results_.summary) {
      if (row.level == level && row.variant == variant && row.metric == metric) {
        return text_of(row, results_.metrics[static_cast<std::size_t>(metric)].unit);
      }
    }
    return kNoValue;
  }

 private:
  const Results& results_;
};

std::string runs_text(const Results& results) {
  int least = std::numeric_limits<int>::max(), most = 0;
  for (const SummaryRow& row : results.summary) {
    if (row.runs == 0) continue;
    least = std::min(least, row.runs);
    most = std::max(most, row.runs);
  }
  if (most <= 1) return "one run each";
  return fmt::format("mean of {} runs with its 95 % interval",
                     least == most ? fmt::to_string(most) : fmt::format("{} to {}", least, most));
}

void leave_out_empty(PaperTable& table) {
  const auto has_value = [&](const std::string& text) { return !text.empty() && text != kNoValue; };
  std::erase_if(table.rows, [&](const auto& row) {
    return std::none_of(row.begin() + static_cast<std::ptrdiff_t>(table.names), row.end(),
                        has_value);
  });
  for (std::size_t i = table.head.size(); i-- > 0;) {
    if (std::any_of(table.rows.begin(), table.rows.end(),
                    [&](const auto& row) { return has_value(row[i]); })) {
      continue;
    }
    const auto at = static_cast<std::ptrdiff_t>(i);
    table.head.erase(table.head.begin() + at);
    for (auto& row : table.rows) row.erase(row.begin() + at);
    if (i < table.names) --table.names;
  }
}

// The names of a level's values, one for each axis.
std::vector<std::string> names_of(const Results& results, std::size_t level) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < results.axes.size(); ++i) {
    const int choice = results.levels[level].choice[i];
    names.push_back(results.axes[i].texts[static_cast<std::size_t>(choice)]);
  }
  return names;
}

PaperTable table_of_variants(const Results& results, int metric) {
  const Cells cells(results);
  PaperTable table{.about = title_of(results.metrics[static_cast<std::size_t>(metric)]) + ", " +
                            runs_text(results)};
  for (const SweepAxis& axis : results.axes) table.head.push_back(words_of(axis.path));
  table.names = table.head.size();
  table.head.insert(table.head.end(), results.variants.begin(), results.variants.end());
  for (std::size_t level = 0; level < results.levels.size(); ++level) {
    std::vector<std::string> row = names_of(results, level);
    for (std::size_t variant = 0; variant < results.variants.size(); ++variant) {
      row.push_back(cells.text(static_cast<int>(level), static_cast<int>(variant), metric));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

// Of several levels or of several variants, not of both.
PaperTable table_of_metrics(const Results& results, const std::vector<int>& metrics) {
  const Cells cells(results);
  PaperTable table{.about = results.id + ", " + runs_text(results)};
  for (const SweepAxis& axis : results.axes) table.head.push_back(words_of(axis.path));
  if (results.variants.size() > 1) table.head.push_back("variant");
  table.names = table.head.size();
  for (const int metric : metrics) {
    table.head.push_back(title_of(results.metrics[static_cast<std::size_t>(metric)]));
  }
  for (std::size_t level = 0; level < results.levels.size(); ++level) {
    for (std::size_t variant = 0; variant < results.variants.size(); ++variant) {
      std::vector<std::string> row = names_of(results, level);
      if (results.variants.size() > 1) row.push_back(results.variants[variant]);
      for (const int metric : metrics) {
        row.push_back(cells.text(static_cast<int>(level), static_cast<int>(variant), metric));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::string joined(const std::vector<std::string>& texts, const char* between) {
  std::string line;
  for (const std::string& text : texts) line += (line.empty() ? "" : between) + text;
  return line;
}

std::vector<std::string> escaped(const std::vector<std::string>& texts,
                                 std::string (*escape)(const std::string& text)) {
  std::vector<std::string> result;
  for (const std::string& text : texts) result.push_back(escape(text));
  return result;
}

}  // namespace

std::vector<PaperTable> paper_tables(const Results& results,
                                     const std::vector<std::string>& metrics) {
  const std::vector<int> chosen = chosen_metrics(results, metrics);
  std::vector<PaperTable> tables;
  if (results.levels.size() > 1 && results.variants.size() > 1) {
    for (const int metric : chosen) tables.push_back(table_of_variants(results, metric));
  } else {
    tables.push_back(table_of_metrics(results, chosen));
  }
  for (PaperTable& table : tables) leave_out_empty(table);
  std::erase_if(tables, [](const PaperTable& table) { return table.rows.empty(); });
  return tables;
}

std::string latex_of(const PaperTable& table) {
  const auto line = [](const std::vector<std::string>& texts) {
    return "  " + joined(escaped(texts, latex_escaped), " & ") + " \\\\\n";
  };
  std::string text = "% " + table.about + "; needs \\usepackage{booktabs}\n";
  text += "\\begin{tabular}{" + std::string(table.names, 'l') +
          std::string(table.head.size() - table.names, 'r') + "}\n  \\toprule\n";
  text += line(table.head) + "  \\midrule\n";
  for (const auto& row : table.rows) text += line(row);
  return text + "  \\bottomrule\n\\end{tabular}\n";
}

std::string markdown_of(const PaperTable& table) {
  const auto line = [](const std::vector<std::string>& texts) {
    return "| " + joined(texts, " | ") + " |\n";
  };
  std::vector<std::string> rule(table.names, "---");
  rule.resize(table.head.size(), "---:");
  std::string text = markdown_escaped(table.about) + ":\n\n";
  text += line(escaped(table.head, markdown_escaped)) + line(rule);
  for (const auto& row : table.rows) text += line(escaped(row, markdown_escaped));
  return text;
}

std::string latex_escaped(const std::string& text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kSigns = {
      {{"\\", "\\textbackslash{}"},
       {"{", "\\{"},
       {"}", "\\}"},
       {"$", "\\$"},
       {"&", "\\&"},
       {"#", "\\#"},
       {"%", "\\%"},
       {"_", "\\_"},
       {"^", "\\textasciicircum{}"},
       {"~", "\\textasciitilde{}"},
       {"<", "$<$"},
       {">", "$>$"},
       {"\u2212", "$-$"},
       {"\u2013", "--"},
       {"\u00B0", "$^\\circ$"},
       {"\u00B2", "$^2$"},
       {"\u00B5", "$\\mu$"},
       {"\u00D7", "$\\times$"}}};
  std::string result;
  for (std::string_view rest = text; !rest.empty();) {
    const auto sign = std::find_if(kSigns.begin(), kSigns.end(),
                                   [&](const auto& s) { return rest.starts_with(s.first); });
    if (sign == kSigns.end()) {
      // A row that begins with a bracket would be an option of the line break before it.
      if (rest[0] == '[' && result.empty()) result += "{}";
      result += rest[0] == '\n' ? ' ' : rest[0];
      rest.remove_prefix(1);
    } else {
      result += sign->second;
      rest.remove_prefix(sign->first.size());
    }
  }
  return result;
}

std::string markdown_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|#").find(c) != std::string_view::npos) result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

}  // namespace mapbed
