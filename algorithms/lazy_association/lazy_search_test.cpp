#include "algorithms/lazy_association/lazy_search.h"

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

constexpr int kLevels = 7, kBranches = 3;

// A tree in which what each decision adds is known: by the decisions before it too, as a wrong one
// is only found out later.
class KnownTree {
 public:
  explicit KnownTree(int seed) : rng_(static_cast<std::uint64_t>(seed)) {
    most_.assign(kLevels, -std::numeric_limits<double>::infinity());
    fill({}, 0.0);
  }

  // Of decisions from the first on.
  double added(const std::vector<int>& decisions) const { return added_.at(key(decisions)); }
  double most(int level) const { return most_[static_cast<std::size_t>(level)]; }
  // Exhaustively, of all leaves at a level.
  double best_of(int level) const { return best_[static_cast<std::size_t>(level)]; }

 private:
  static std::size_t key(const std::vector<int>& decisions) {
    std::size_t key = 1;
    for (const int decision : decisions) {
      key = key * (kBranches + 1) + static_cast<std::size_t>(decision) + 1;
    }
    return key;
  }
  void fill(const std::vector<int>& decisions, double sum) {
    const std::size_t level = decisions.size();
    if (level > 0) {
      if (best_.size() < level) best_.resize(level, -std::numeric_limits<double>::infinity());
      best_[level - 1] = std::max(best_[level - 1], sum);
    }
    if (level == kLevels) return;
    for (int branch = 0; branch < kBranches; ++branch) {
      std::vector<int> next = decisions;
      next.push_back(branch);
      const double added = -10.0 * rng_.uniform() * rng_.uniform();
      added_[key(next)] = added;
      most_[level] = std::max(most_[level], added);
      fill(next, sum + added);
    }
  }

  Rng rng_;
  std::map<std::size_t, double> added_;
  std::vector<double> most_;
  std::vector<double> best_;
};

// The search over a known tree; the root is no decision.
class SearchOfKnownTree {
 public:
  SearchOfKnownTree(const KnownTree& tree, const LazySearchOptions& options)
      : tree_(tree), search_(options) {
    search_.start({});
    decisions_.push_back({});
  }

  void advance(double most) {
    const auto expand = [&](std::size_t node) {
      std::vector<LazySearch::Outcome> outcomes;
      for (int branch = 0; branch < kBranches; ++branch) {
        std::vector<int> next = decisions_[node];
        next.push_back(branch);
        outcomes.push_back(
            {.associated = branch,
             .log_likelihood = search_.tree().nodes[node].log_likelihood + tree_.added(next)});
        decisions_.push_back(next);
      }
      return outcomes;
    };
    search_.advance(time_++, expand, {.value = most});
  }

  const AssociationTree& tree() const { return search_.tree(); }
  double chosen_value() const { return tree().nodes[tree().chosen].log_likelihood; }
  int chosen_level() const { return tree().nodes[tree().chosen].local_map; }

 private:
  const KnownTree& tree_;
  LazySearch search_;
  double time_ = 0.0;
  std::vector<std::vector<int>> decisions_;  // by node
};

class LazySearchOfTrees : public ::testing::TestWithParam<int> {};

TEST_P(LazySearchOfTrees, WithBoundsIsTheExhaustiveSearchAtEachLevel) {
  const KnownTree tree(GetParam());
  SearchOfKnownTree search(tree, {.max_expansions = 1'000'000, .max_frontier = 1'000'000});
  for (int level = 0; level < kLevels; ++level) {
    search.advance(tree.most(level));
    EXPECT_EQ(search.chosen_level(), level + 1);
    EXPECT_DOUBLE_EQ(search.chosen_value(), tree.best_of(level)) << "level " << level;
  }
  EXPECT_EQ(search.tree().given_up, 0);
}

TEST_P(LazySearchOfTrees, ALooseBoundFindsTheSameWithMoreWork) {
  const KnownTree tree(GetParam());
  const LazySearchOptions unlimited{.max_expansions = 1'000'000, .max_frontier = 1'000'000};
  SearchOfKnownTree tight(tree, unlimited), loose(tree, unlimited);
  for (int level = 0; level < kLevels; ++level) {
    tight.advance(tree.most(level));
    loose.advance(0.0);
  }
  EXPECT_DOUBLE_EQ(loose.chosen_value(), tight.chosen_value());
  EXPECT_GE(loose.tree().nodes.size(), tight.tree().nodes.size());
}

TEST_P(LazySearchOfTrees, ABoundedEffortStillReachesTheNewestLevel) {
  const KnownTree tree(GetParam());
  SearchOfKnownTree search(tree, {.max_expansions = 2, .max_frontier = 4});
  for (int level = 0; level < kLevels; ++level) {
    search.advance(0.0);
    EXPECT_EQ(search.chosen_level(), level + 1);
    EXPECT_LE(search.chosen_value(), tree.best_of(level));
  }
}

TEST_P(LazySearchOfTrees, RevisionsSayWhatChanged) {
  const KnownTree tree(GetParam());
  SearchOfKnownTree search(tree, {.max_expansions = 1'000'000, .max_frontier = 1'000'000});
  for (int level = 0; level < kLevels; ++level) search.advance(tree.most(level));
  for (const AssociationTree::Revision& revision : search.tree().revisions) {
    EXPECT_GT(revision.changed, 0);
    EXPECT_LT(revision.since, revision.at);
    EXPECT_GE(revision.log_likelihood_after, revision.log_likelihood_before);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, LazySearchOfTrees, ::testing::Range(1, 13));

TEST(LazySearch, SaysHowOftenItEndedBeforeItWasSure) {
  int given_up = 0;
  for (int seed = 1; seed < 13; ++seed) {
    const KnownTree tree(seed);
    SearchOfKnownTree search(tree, {.max_expansions = 2, .max_frontier = 4});
    for (int level = 0; level < kLevels; ++level) search.advance(0.0);
    given_up += search.tree().given_up;
  }
  EXPECT_GT(given_up, 0);
}

// Two ways; the better one at first turns out wrong two levels later.
TEST(LazySearch, TakesADecisionBackWhenItTurnsOutWrong) {
  LazySearch search({});
  search.start({});
  std::vector<std::vector<int>> decisions{{}};
  const auto expand = [&](std::size_t node) {
    std::vector<LazySearch::Outcome> outcomes;
    const std::vector<int> before = decisions[node];
    for (int branch = 0; branch < 2; ++branch) {
      if (!before.empty() && branch == 1) break;  // only the first level has a choice
      std::vector<int> next = before;
      next.push_back(branch);
      const bool is_wrong = next.front() == 0;
      const double added = next.size() == 1 ? (is_wrong ? -1.0 : -3.0)
                                            : (is_wrong && next.size() == 3 ? -20.0 : -0.5);
      outcomes.push_back({.associated = branch,
                          .log_likelihood = search.tree().nodes[node].log_likelihood + added});
      decisions.push_back(next);
    }
    return outcomes;
  };
  search.advance(1.0, expand, {.value = -0.5, .is_bound = false});
  EXPECT_EQ(decisions[search.chosen()].front(), 0);
  search.advance(2.0, expand, {.value = -0.5, .is_bound = false});
  EXPECT_EQ(decisions[search.chosen()].front(), 0);
  EXPECT_TRUE(search.tree().revisions.empty());
  search.advance(3.0, expand, {.value = -0.5, .is_bound = false});
  EXPECT_EQ(decisions[search.chosen()].front(), 1);
  ASSERT_EQ(search.tree().revisions.size(), 1U);
  const AssociationTree::Revision& revision = search.tree().revisions.front();
  EXPECT_EQ(revision.since, 1);
  EXPECT_EQ(revision.at, 3);
  EXPECT_EQ(revision.changed, 1);
  EXPECT_DOUBLE_EQ(revision.log_likelihood_before, -21.5);
  EXPECT_DOUBLE_EQ(revision.log_likelihood_after, -4.0);
}

}  // namespace
}  // namespace mapbed
