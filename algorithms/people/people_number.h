#pragma once

#include <vector>

#include "core/config/option.h"

namespace mapbed {

// P(m | N): how many features are counted where N people are in view.
class FeatureNumbers {
 public:
  // Each person detected with `detection`, independently, and false alarms as a Poisson process.
  static FeatureNumbers closed_form(double detection, double false_alarms, int max_people);

  // `rows[n][m]`, each summing up to one; more features than a row has are as its last.
  explicit FeatureNumbers(std::vector<std::vector<double>> rows);

  double probability(int features, int people) const;
  int max_people() const { return static_cast<int>(rows_.size()) - 1; }
  int max_features() const { return static_cast<int>(rows_.back().size()) - 1; }

 private:
  std::vector<std::vector<double>> rows_;
};

struct PeopleNumberOptions {
  double change_rate = 1.0;  // [1/s]
};

template <class Visitor>
void visit_fields(PeopleNumberOptions& o, Visitor&& visit) {
  visit("change_rate", o.change_rate, between(0.0, 100.0),
        "how often in a second somebody comes into view or leaves it");
}

// (3.5): how many people are in view. Uniform over 0 ... max_people at first; between scans
// somebody comes or somebody leaves, P(N_t | N_{t-1}), as often the one as the other.
class PeopleNumber {
 public:
  PeopleNumber(FeatureNumbers numbers, const PeopleNumberOptions& options);

  void add(int features, double seconds);  // since the scan before

  int most_likely() const;
  const std::vector<double>& density() const { return density_; }  // by number

 private:
  FeatureNumbers numbers_;
  PeopleNumberOptions options_;
  std::vector<double> density_;
};

}  // namespace mapbed
