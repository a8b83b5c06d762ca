#include "algorithms/people/people_number.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kLeast = 1e-6;  // of any number of features: nothing is impossible

double binomial(int successes, int trials, double p) {
  if (successes < 0 || successes > trials) return 0.0;
  double value = 1.0;
  for (int i = 0; i < successes; ++i) value *= p * (trials - i) / (successes - i);
  return value * std::pow(1.0 - p, trials - successes);
}

double poisson(int count, double mean) {
  double value = std::exp(-mean);
  for (int i = 1; i <= count; ++i) value *= mean / i;
  return value;
}

void normalize(std::vector<double>& density) {
  const double sum = std::accumulate(density.begin(), density.end(), 0.0);
  for (double& p : density) p /= sum;
}

}  // namespace

FeatureNumbers FeatureNumbers::closed_form(double detection, double false_alarms, int max_people) {
  std::vector<std::vector<double>> rows;
  const int max_features = 2 * max_people + 10;
  std::vector<double> false_ones;
  for (int m = 0; m <= max_features; ++m) false_ones.push_back(poisson(m, false_alarms));
  for (int n = 0; n <= max_people; ++n) {
    std::vector<double> detected;
    for (int k = 0; k <= n; ++k) detected.push_back(binomial(k, n, detection));
    std::vector<double>& row = rows.emplace_back();
    for (int m = 0; m <= max_features; ++m) {
      double p = 0.0;
      for (int k = 0; k <= std::min(m, n); ++k) {
        p += detected[static_cast<std::size_t>(k)] * false_ones[static_cast<std::size_t>(m - k)];
      }
      row.push_back(p);
    }
  }
  return FeatureNumbers(std::move(rows));
}

FeatureNumbers::FeatureNumbers(std::vector<std::vector<double>> rows) : rows_(std::move(rows)) {
  CHECK(!rows_.empty());
  for (const std::vector<double>& row : rows_) CHECK(!row.empty());
}

double FeatureNumbers::probability(int features, int people) const {
  CHECK(features >= 0 && people >= 0 && people <= max_people());
  const std::vector<double>& row = rows_[static_cast<std::size_t>(people)];
  const std::size_t m = std::min(static_cast<std::size_t>(features), row.size() - 1);
  return std::max(row[m], kLeast);
}

PeopleNumber::PeopleNumber(FeatureNumbers numbers, const PeopleNumberOptions& options)
    : numbers_(std::move(numbers)), options_(options) {
  density_.assign(static_cast<std::size_t>(numbers_.max_people()) + 1,
                  1.0 / (numbers_.max_people() + 1));
}

void PeopleNumber::add(int features, double seconds) {
  const double one_way = 0.5 * (1.0 - std::exp(-options_.change_rate * std::max(seconds, 0.0)));
  const std::size_t last = density_.size() - 1;
  std::vector<double> predicted(density_.size(), 0.0);
  for (std::size_t n = 0; n <= last; ++n) {
    predicted[n] += (1.0 - 2.0 * one_way) * density_[n];
    predicted[n == 0 ? 0 : n - 1] += one_way * density_[n];
    predicted[std::min(n + 1, last)] += one_way * density_[n];
  }
  for (std::size_t n = 0; n <= last; ++n) {
    predicted[n] *= numbers_.probability(features, static_cast<int>(n));
  }
  density_ = std::move(predicted);
  normalize(density_);
}

int PeopleNumber::most_likely() const {
  return static_cast<int>(std::max_element(density_.begin(), density_.end()) - density_.begin());
}

}  // namespace mapbed
