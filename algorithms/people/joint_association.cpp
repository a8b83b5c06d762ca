#include "algorithms/people/joint_association.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "algorithms/people/k_best_assignments.h"
#include "core/check.h"

namespace mapbed {
namespace {

using Index = Eigen::Index;

struct Cluster {
  std::vector<Index> people;
  std::vector<Index> features;
};

// People who share a gate with each other, if by way of others.
std::vector<Cluster> clusters_of(const Eigen::MatrixXd& likelihood) {
  std::vector<Cluster> clusters;
  std::vector<bool> person_done(static_cast<std::size_t>(likelihood.rows()), false);
  std::vector<bool> feature_done(static_cast<std::size_t>(likelihood.cols()), false);
  for (Index first = 0; first < likelihood.rows(); ++first) {
    if (person_done[static_cast<std::size_t>(first)]) continue;
    person_done[static_cast<std::size_t>(first)] = true;
    Cluster& cluster = clusters.emplace_back();
    cluster.people.push_back(first);
    for (std::size_t next = 0; next < cluster.people.size(); ++next) {
      for (Index j = 0; j < likelihood.cols(); ++j) {
        const auto feature = static_cast<std::size_t>(j);
        if (feature_done[feature] || likelihood(cluster.people[next], j) <= 0.0) continue;
        feature_done[feature] = true;
        cluster.features.push_back(j);
        for (Index i = 0; i < likelihood.rows(); ++i) {
          if (person_done[static_cast<std::size_t>(i)] || likelihood(i, j) <= 0.0) continue;
          person_done[static_cast<std::size_t>(i)] = true;
          cluster.people.push_back(i);
        }
      }
    }
  }
  return clusters;
}

// Sums up the joint events of a cluster. Weights are relative to the event in which all features
// are false alarms, so that each pair brings p(j, i) / p_fa(j).
class EventSum {
 public:
  explicit EventSum(const Eigen::MatrixXd& ratios, const Eigen::VectorXd& missed)
      : ratios_(ratios),
        missed_(missed),
        gamma_(Eigen::MatrixXd::Zero(ratios.rows(), ratios.cols())),
        gamma_missed_(Eigen::VectorXd::Zero(ratios.rows())),
        chosen_(static_cast<std::size_t>(ratios.rows()), -1),
        taken_(static_cast<std::size_t>(ratios.cols()), false) {}

  // False where there are more.
  bool has_at_most(long events) {
    left_ = events;
    return count_from(0);
  }

  void add_all() { add_from(0, 1.0); }

  void add(const std::vector<int>& columns, double weight) {
    ++events_;
    total_ += weight;
    for (Index i = 0; i < ratios_.rows(); ++i) {
      const int j = columns[static_cast<std::size_t>(i)];
      if (j >= 0 && j < ratios_.cols()) {
        gamma_(i, j) += weight;
      } else {
        gamma_missed_(i) += weight;
      }
    }
  }

  long events() const { return events_; }
  double gamma(Index i, Index j) const { return gamma_(i, j) / total_; }
  double missed(Index i) const { return gamma_missed_(i) / total_; }

 private:
  bool count_from(Index i) {
    if (i == ratios_.rows()) return left_-- > 0;
    if (!count_from(i + 1)) return false;
    for (Index j = 0; j < ratios_.cols(); ++j) {
      if (!is_open(i, j)) continue;
      taken_[static_cast<std::size_t>(j)] = true;
      const bool fits = count_from(i + 1);
      taken_[static_cast<std::size_t>(j)] = false;
      if (!fits) return false;
    }
    return true;
  }

  void add_from(Index i, double weight) {
    if (i == ratios_.rows()) return add(chosen_, weight);
    chosen_[static_cast<std::size_t>(i)] = -1;
    add_from(i + 1, weight * missed_(i));
    for (Index j = 0; j < ratios_.cols(); ++j) {
      if (!is_open(i, j)) continue;
      taken_[static_cast<std::size_t>(j)] = true;
      chosen_[static_cast<std::size_t>(i)] = static_cast<int>(j);
      add_from(i + 1, weight * ratios_(i, j));
      taken_[static_cast<std::size_t>(j)] = false;
    }
    chosen_[static_cast<std::size_t>(i)] = -1;
  }

  bool is_open(Index i, Index j) const {
    return !taken_[static_cast<std::size_t>(j)] && ratios_(i, j) > 0.0;
  }

  const Eigen::MatrixXd& ratios_;
  const Eigen::VectorXd& missed_;
  Eigen::MatrixXd gamma_;
  Eigen::VectorXd gamma_missed_;
  std::vector<int> chosen_;
  std::vector<bool> taken_;
  double total_ = 0.0;
  long events_ = 0;
  long left_ = 0;
};

// As an assignment: a column for each feature, and one for each person who is missed.
void add_best(EventSum& sum, const Eigen::MatrixXd& ratios, const Eigen::VectorXd& missed,
              int count) {
  Eigen::MatrixXd cost = Eigen::MatrixXd::Constant(ratios.rows(), ratios.cols() + ratios.rows(),
                                                   std::numeric_limits<double>::infinity());
  for (Index i = 0; i < ratios.rows(); ++i) {
    for (Index j = 0; j < ratios.cols(); ++j) {
      if (ratios(i, j) > 0.0) cost(i, j) = -std::log(ratios(i, j));
    }
    cost(i, ratios.cols() + i) = -std::log(missed(i));
  }
  const std::vector<RankedAssignment> best = k_best_assignments(cost, count);
  for (const RankedAssignment& event : best) {
    sum.add(event.columns, std::exp(best.front().cost - event.cost));
  }
}

}  // namespace

JointAssociation associate(const Eigen::MatrixXd& likelihood, const Eigen::VectorXd& missed,
                           const Eigen::VectorXd& p_fa, const JointAssociationOptions& options) {
  CHECK(missed.size() == likelihood.rows() && p_fa.size() == likelihood.cols());
  CHECK((missed.array() > 0.0).all() && (p_fa.array() > 0.0).all());
  JointAssociation result{.gamma = Eigen::MatrixXd::Zero(likelihood.rows(), likelihood.cols()),
                          .missed = Eigen::VectorXd::Zero(likelihood.rows())};
  for (const Cluster& cluster : clusters_of(likelihood)) {
    const auto people = static_cast<Index>(cluster.people.size());
    const auto features = static_cast<Index>(cluster.features.size());
    Eigen::MatrixXd ratios(people, features);
    Eigen::VectorXd missed_here(people);
    for (Index i = 0; i < people; ++i) {
      const Index person = cluster.people[static_cast<std::size_t>(i)];
      missed_here(i) = missed(person);
      for (Index j = 0; j < features; ++j) {
        const Index feature = cluster.features[static_cast<std::size_t>(j)];
        ratios(i, j) = likelihood(person, feature) / p_fa(feature);
      }
    }
    EventSum sum(ratios, missed_here);
    const bool is_exact = sum.has_at_most(options.max_events);
    if (is_exact) {
      sum.add_all();
    } else {
      add_best(sum, ratios, missed_here, options.best_events);
      ++result.cut_clusters;
    }
    result.events += sum.events();
    for (Index i = 0; i < people; ++i) {
      const Index person = cluster.people[static_cast<std::size_t>(i)];
      result.missed(person) = sum.missed(i);
      for (Index j = 0; j < features; ++j) {
        result.gamma(person, cluster.features[static_cast<std::size_t>(j)]) = sum.gamma(i, j);
      }
    }
  }
  return result;
}

}  // namespace mapbed
