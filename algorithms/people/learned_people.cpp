#include "algorithms/people/learned_people.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mapbed {
namespace {

using Row = std::array<double, 4>;  // by Evidence::Left: nowhere, unknown, free, same

// By Evidence::is_steady and SeenBefore: nothing, free, mixed, same. Counted in the first 4 s of
// whatever a tracker took up: within 0.4 m of somebody who walks, or farther than 0.9 m from
// everybody; four drives of the B21r in the corridor with 5 people and three of the Pioneer in the
// museum with 15, `mapbed simulate --seed 1001` to 1004 and to 1003; rounded. Of `same` there were
// few, as nobody is taken up there: they are as `mixed`.
constexpr std::array<std::array<Row, 4>, 2> kStep{{
    {{{-1.9, -0.9, -0.5, -2.1},
      {-0.8, 0.5, 0.6, -2.1},
      {-4.0, -3.0, -2.0, -4.0},
      {-4.0, -3.0, -2.0, -4.0}}},
    {{{-0.2, 0.5, 2.2, -1.9},
      {1.1, 4.0, 3.6, 0.2},
      {-2.9, -2.4, -1.8, -4.0},
      {-2.9, -2.4, -1.8, -4.0}}},
}};
constexpr Row kStay{-2.8, -0.7, -3.2, -3.2};  // by SeenBefore
constexpr double kMissed = -2.7;

// Scans in which so many people who had walked were in view (row) and so many features counted
// (column): the drives above, and the museum with the B21r and 8 people (seed 1004) and with 25
// (1005), the corridor with the Pioneer and 12 (1005) and with 3 (1006).
const std::vector<std::vector<double>>& counted() {
  static const std::vector<std::vector<double>> scans{
      {1651, 1001, 511, 196, 63, 21, 10},   {35, 1696, 914, 376, 133, 36, 17, 6, 1, 1},
      {4, 47, 986, 486, 215, 94, 26, 8, 4}, {0, 6, 73, 437, 180, 85, 34, 23, 8},
      {0, 2, 14, 38, 174, 79, 20, 13, 5},   {0, 2, 4, 8, 28, 61, 42, 16, 1},
      {0, 0, 0, 6, 17, 44, 44, 35, 3},      {0, 0, 1, 1, 2, 12, 17, 16, 2, 2},
      {0, 0, 0, 0, 0, 8, 3, 10, 6, 2},      {0, 0, 0, 0, 0, 0, 6, 3, 2, 2, 1},
      {0, 0, 0, 0, 0, 0, 0, 0, 4},
  };
  return scans;
}

constexpr double kAsScans = 20.0;  // that the closed form counts with

}  // namespace

double Evidence::log_ratio() const {
  const auto row = static_cast<std::size_t>(before);
  if (kind == Kind::step) return kStep[is_steady ? 1 : 0][row][static_cast<std::size_t>(left)];
  return kind == Kind::stay ? kStay[row] : kMissed;
}

FeatureNumbers learned_feature_numbers(double detection, double false_alarms, int max_people) {
  const FeatureNumbers form = FeatureNumbers::closed_form(detection, false_alarms, max_people);
  std::vector<std::vector<double>> rows;
  for (int n = 0; n <= max_people; ++n) {
    const auto row_of_n = static_cast<std::size_t>(n);
    const std::vector<double> scans =
        row_of_n < counted().size() ? counted()[row_of_n] : std::vector<double>{};
    double all = kAsScans;
    for (const double count : scans) all += count;
    std::vector<double>& row = rows.emplace_back();
    for (int m = 0; m <= form.max_features(); ++m) {
      const auto column = static_cast<std::size_t>(m);
      const double count = column < scans.size() ? scans[column] : 0.0;
      row.push_back((count + kAsScans * form.probability(m, n)) / all);
    }
  }
  return FeatureNumbers(std::move(rows));
}

}  // namespace mapbed
