#include "algorithms/people/joint_association.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

// All joint events, one after the other, without clusters or gates.
struct Enumerated {
  Eigen::MatrixXd gamma;
  Eigen::VectorXd missed;
  double total = 0.0;
};

void enumerate(const Eigen::MatrixXd& p, const Eigen::VectorXd& missed, const Eigen::VectorXd& p_fa,
               std::vector<int>& event, Enumerated& sum) {
  const auto i = static_cast<Eigen::Index>(event.size());
  if (i == p.rows()) {
    double weight = 1.0;
    for (Eigen::Index j = 0; j < p.cols(); ++j) {
      bool is_assigned = false;
      for (const int k : event) is_assigned = is_assigned || k == j;
      if (!is_assigned) weight *= p_fa(j);
    }
    for (Eigen::Index k = 0; k < p.rows(); ++k) {
      const int j = event[static_cast<std::size_t>(k)];
      weight *= j < 0 ? missed(k) : p(k, j);
    }
    sum.total += weight;
    for (Eigen::Index k = 0; k < p.rows(); ++k) {
      const int j = event[static_cast<std::size_t>(k)];
      (j < 0 ? sum.missed(k) : sum.gamma(k, j)) += weight;
    }
    return;
  }
  for (int j = -1; j < p.cols(); ++j) {
    bool is_taken = false;
    for (const int k : event) is_taken = is_taken || (j >= 0 && k == j);
    if (is_taken) continue;
    event.push_back(j);
    enumerate(p, missed, p_fa, event, sum);
    event.pop_back();
  }
}

Enumerated enumerated(const Eigen::MatrixXd& p, const Eigen::VectorXd& missed,
                      const Eigen::VectorXd& p_fa) {
  Enumerated sum{Eigen::MatrixXd::Zero(p.rows(), p.cols()), Eigen::VectorXd::Zero(p.rows())};
  std::vector<int> event;
  enumerate(p, missed, p_fa, event, sum);
  sum.gamma /= sum.total;
  sum.missed /= sum.total;
  return sum;
}

struct Example {
  Eigen::MatrixXd likelihood;
  Eigen::VectorXd missed;
  Eigen::VectorXd p_fa;
};

// Likelihoods of people and features, a part of them outside of all gates.
Example example(Rng rng, Eigen::Index people, Eigen::Index features, double outside) {
  Example e{Eigen::MatrixXd(people, features), Eigen::VectorXd(people), Eigen::VectorXd(features)};
  for (double& p : e.likelihood.reshaped()) p = rng.uniform() < outside ? 0.0 : rng.uniform(0.1, 5);
  for (double& p : e.missed) p = rng.uniform(0.05, 1.0);
  for (double& p : e.p_fa) p = rng.uniform(0.05, 0.5);
  return e;
}

TEST(JointAssociation, IsTheSumOverAllJointEvents) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Example e = example(Rng(seed), 4, 4, 0.4);
    const Enumerated expected = enumerated(e.likelihood, e.missed, e.p_fa);
    const JointAssociation found = associate(e.likelihood, e.missed, e.p_fa, {});
    EXPECT_TRUE(found.gamma.isApprox(expected.gamma, 1e-12)) << "seed " << seed;
    EXPECT_TRUE(found.missed.isApprox(expected.missed, 1e-12)) << "seed " << seed;
    EXPECT_EQ(found.cut_clusters, 0);
  }
}

TEST(JointAssociation, OfAsManyBestEventsAsThereAreIsTheSame) {
  const Example e = example(Rng(5), 3, 3, 0.2);
  const Enumerated expected = enumerated(e.likelihood, e.missed, e.p_fa);
  const JointAssociation found =
      associate(e.likelihood, e.missed, e.p_fa, {.max_events = 1, .best_events = 1000});
  EXPECT_TRUE(found.gamma.isApprox(expected.gamma, 1e-9));
  EXPECT_EQ(found.cut_clusters, 1);
}

TEST(JointAssociation, OfTheBestEventsAloneIsNearTheSumOverAll) {
  Example e = example(Rng(6), 4, 4, 0.0);
  e.likelihood.diagonal().array() += 100.0;  // clear whose each is
  const Enumerated expected = enumerated(e.likelihood, e.missed, e.p_fa);
  const JointAssociation found =
      associate(e.likelihood, e.missed, e.p_fa, {.max_events = 10, .best_events = 50});
  EXPECT_EQ(found.events, 50);
  EXPECT_TRUE(found.gamma.isApprox(expected.gamma, 0.02));
}

// (3.2): one person, two features. The events are: none is his, with both false alarms; the first
// one, with the other a false alarm; and the other way round.
TEST(JointAssociation, CountsAFalseAlarmForEachFeatureThatAnEventLeavesUnassigned) {
  const Eigen::MatrixXd p = (Eigen::MatrixXd(1, 2) << 2.0, 0.5).finished();
  const double missed = 0.3;
  const double p_fa = 0.1;
  const JointAssociation found =
      associate(p, Eigen::VectorXd::Constant(1, missed), Eigen::VectorXd::Constant(2, p_fa), {});
  const double sum = missed * p_fa * p_fa + 2.0 * p_fa + 0.5 * p_fa;
  EXPECT_NEAR(found.gamma(0, 0), 2.0 * p_fa / sum, 1e-12);
  EXPECT_NEAR(found.gamma(0, 1), 0.5 * p_fa / sum, 1e-12);
  EXPECT_NEAR(found.missed(0), missed * p_fa * p_fa / sum, 1e-12);
}

TEST(JointAssociation, WhoIsHiddenIsRatherMissed) {
  const Eigen::MatrixXd p = (Eigen::MatrixXd(1, 1) << 0.2).finished();
  const Eigen::VectorXd p_fa = Eigen::VectorXd::Constant(1, 0.1);
  const double seen = associate(p, Eigen::VectorXd::Constant(1, 0.1), p_fa, {}).missed(0);
  const double hidden = associate(p, Eigen::VectorXd::Constant(1, 1.0), p_fa, {}).missed(0);
  EXPECT_NEAR(seen, 0.1 / (0.1 + 2.0), 1e-12);
  EXPECT_NEAR(hidden, 1.0 / (1.0 + 2.0), 1e-12);
}

TEST(JointAssociation, OfNobodyIsEmpty) {
  const JointAssociation found =
      associate(Eigen::MatrixXd(0, 3), {}, Eigen::VectorXd::Constant(3, 0.1), {});
  EXPECT_EQ(found.gamma.rows(), 0);
  EXPECT_EQ(found.events, 0);
}

}  // namespace
}  // namespace mapbed
