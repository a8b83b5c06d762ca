#include "algorithms/rfid/tags_file.h"

#include <cmath>
#include <set>
#include <utility>

#include "core/file/csv_file.h"
#include "core/file/text_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kLeastWeight = 1e-6;  // of the heaviest; lighter positions are not written

void normalize(TagBelief& tag, const SourceLocation& place) {
  double sum = 0.0;
  for (const double weight : tag.weights) sum += weight;
  if (!(sum > 0.0)) throw InputError(place, "all weights of tag " + in_quotes(tag.tag) + " are 0");
  for (double& weight : tag.weights) weight /= sum;
}

struct TagRow {
  std::string tag;
  Eigen::Vector2d position;
  double weight = 1.0;
};

TagRow row_in(const CsvRow& fields, const SourceLocation& place) {
  TagRow row{fields[0], {parse_csv_number(fields[1]), parse_csv_number(fields[2])}};
  if (fields.size() > 3) row.weight = parse_csv_number(fields[3]);
  if (row.tag.empty()) throw InputError(place, "a tag without a name");
  const bool sensible = row.position.allFinite() && row.position.cwiseAbs().maxCoeff() <= 1e6;
  if (!sensible) throw InputError(place, "tag " + in_quotes(row.tag) + " has no position");
  if (!(row.weight >= 0.0 && row.weight <= 1e300)) {
    throw InputError(place, "tag " + in_quotes(row.tag) + " has a weight that is none");
  }
  return row;
}

}  // namespace

std::string tags_text(const std::vector<TagBelief>& tags) {
  std::string text = csv_line({"tag", "x", "y", "weight"});
  for (const TagBelief& tag : tags) {
    double most = 0.0;
    for (const double weight : tag.weights) most = std::max(most, weight);
    for (std::size_t i = 0; i < tag.positions.size(); ++i) {
      if (tag.weights[i] < kLeastWeight * most) continue;
      text += csv_line({tag.tag, csv_number(tag.positions[i].x()), csv_number(tag.positions[i].y()),
                        csv_number(tag.weights[i])});
    }
  }
  return text;
}

std::vector<TagBelief> parse_tags(const std::string& name, std::string_view text) {
  const std::vector<CsvRow> rows = parse_csv(name, text);
  const CsvRow header{"tag", "x", "y", "weight"};
  const bool has_weights = !rows.empty() && rows[0] == header;
  if (!has_weights && (rows.empty() || rows[0] != CsvRow{"tag", "x", "y"})) {
    throw InputError({name, 1}, "is no table of tags", "its first line is tag,x,y,weight");
  }
  std::vector<TagBelief> tags;
  std::set<std::string> seen;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const SourceLocation place{name, static_cast<long>(i + 1)};
    const TagRow row = row_in(rows[i], place);
    if (tags.empty() || tags.back().tag != row.tag) {
      if (!seen.insert(row.tag).second) {
        throw InputError(
            place, "tag " + in_quotes(row.tag) + " comes a second time",
            "let the rows of a tag stand together, and give each tag a name of its own");
      }
      if (!tags.empty()) normalize(tags.back(), place);
      tags.push_back({row.tag, {}, {}});
    } else if (!has_weights) {
      throw InputError(place, "tag " + in_quotes(row.tag) + " has two places, and no weights",
                       "give it one place, or a column `weight`");
    }
    tags.back().positions.push_back(row.position);
    tags.back().weights.push_back(row.weight);
  }
  if (tags.empty()) throw InputError({name}, "has no tags");
  normalize(tags.back(), {name, static_cast<long>(rows.size())});
  return tags;
}

std::vector<TagBelief> load_tags(const std::string& path) {
  return parse_tags(path, read_text_file(path));
}

}  // namespace mapbed
