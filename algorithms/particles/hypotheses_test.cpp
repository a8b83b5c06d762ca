#include "algorithms/particles/hypotheses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;

std::shared_ptr<HistoryNode> after(const std::shared_ptr<HistoryNode>& parent, double x) {
  return std::make_shared<HistoryNode>(Pose2{x, 0.0, 0.0}, parent ? parent->update + 1 : 0, parent);
}

// Two children of one start; the first has two children, the second one:
//
//   0 - 1 - 2
//     \   \ 3
//       4 - 5
class Hypothesis : public ::testing::Test {
 protected:
  const std::shared_ptr<HistoryNode> start_ = after(nullptr, 0.0);
  const std::shared_ptr<HistoryNode> left_ = after(start_, 1.0);
  const std::shared_ptr<HistoryNode> first_ = after(left_, 2.0), second_ = after(left_, 3.0);
  const std::shared_ptr<HistoryNode> third_ = after(after(start_, 4.0), 5.0);
  const std::vector<const HistoryNode*> particles_{first_.get(), second_.get(), third_.get()};
  const std::vector<Diversity> updates_{{.time = 10.0}, {.time = 11.0}, {.time = 12.0}};
};

TEST_F(Hypothesis, APathStandsInTheOrderOfItsUpdates) {
  EXPECT_THAT(path_of(*third_),
              ElementsAre(Pose2{0.0, 0.0, 0.0}, Pose2{4.0, 0.0, 0.0}, Pose2{5.0, 0.0, 0.0}));
}

TEST_F(Hypothesis, AncestorsOfSeveralParticlesCountOnce) {
  EXPECT_THAT(diversity_of(particles_, updates_),
              ElementsAre(Field(&Diversity::distinct_ancestors, 1),
                          Field(&Diversity::distinct_ancestors, 2),
                          Field(&Diversity::distinct_ancestors, 3)));
  EXPECT_THAT(diversity_of({first_.get(), first_.get(), second_.get()}, updates_),
              ElementsAre(Field(&Diversity::distinct_ancestors, 1),
                          Field(&Diversity::distinct_ancestors, 1),
                          Field(&Diversity::distinct_ancestors, 2)));
}

TEST_F(Hypothesis, ABranchBeginsWhereItPartedFromOneBefore) {
  const auto at = [](double time, double x) {
    return ::testing::AllOf(Field(&Stamped<Pose2>::time, time),
                            Field(&Stamped<Pose2>::pose, Pose2{x, 0.0, 0.0}));
  };
  EXPECT_THAT(branches_of(particles_, updates_),
              ElementsAre(ElementsAre(at(10.0, 0.0), at(11.0, 1.0), at(12.0, 2.0)),
                          ElementsAre(at(11.0, 1.0), at(12.0, 3.0)),
                          ElementsAre(at(10.0, 0.0), at(11.0, 4.0), at(12.0, 5.0))));
}

TEST_F(Hypothesis, ParticlesAtOneNodeShareABranch) {
  EXPECT_EQ(branches_of({first_.get(), first_.get()}, updates_).size(), 1U);
}

}  // namespace
}  // namespace mapbed
