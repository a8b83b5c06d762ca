#include "algorithms/pose_graph/fronts/block_cholesky.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "algorithms/pose_graph/elimination_order.h"
#include "algorithms/pose_graph/fronts/dense_front.h"
#include "core/random.h"

namespace mapbed {
namespace {

template <class Size>
class BlockCholeskyOf : public ::testing::Test {};
using Sizes = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>,
                               std::integral_constant<int, 6>>;
TYPED_TEST_SUITE(BlockCholeskyOf, Sizes);

// A chain, and random chords: several trees of fronts of all sizes.
std::vector<std::pair<int, int>> chain_with_chords(Rng& rng, int unknowns, int chords) {
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i + 1 < unknowns; ++i) {
    if (i % 40 != 39) pairs.emplace_back(i, i + 1);
  }
  for (int i = 0; i < chords; ++i) {
    const int a = static_cast<int>(rng.index(static_cast<std::uint64_t>(unknowns)));
    const int b = static_cast<int>(rng.index(static_cast<std::uint64_t>(unknowns)));
    if (a != b) pairs.emplace_back(a, b);
  }
  return pairs;
}

TYPED_TEST(BlockCholeskyOf, AGraphSolvesAsTheDenseMatrixDoes) {
  constexpr int kSize = TypeParam::value;
  for (const int chords : {0, 8, 60, 400}) {
    Rng rng(20);
    constexpr int kUnknowns = 120;
    const auto pairs = chain_with_chords(rng, kUnknowns, chords);
    BlockCholesky<kSize> matrix(kUnknowns, pairs);
    for (int round = 0; round < 2; ++round) {  // filled again in place
      matrix.set_zero();
      Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(matrix.size(), matrix.size());
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const typename BlockCholesky<kSize>::Block block =
            BlockCholesky<kSize>::Block::NullaryExpr([&] { return rng.normal(); });
        const int a = matrix.place_of(pairs[i].first);
        const int b = matrix.place_of(pairs[i].second);
        matrix.off_diagonal(matrix.block_of(i)) += block;
        dense.block<kSize, kSize>(kSize * std::max(a, b), kSize * std::min(a, b)) += block;
        dense.block<kSize, kSize>(kSize * std::min(a, b), kSize * std::max(a, b)) +=
            block.transpose();
      }
      // Diagonally dominant.
      for (int place = 0; place < kUnknowns; ++place) {
        matrix.diagonal(place).diagonal().setConstant(10.0);
      }
      dense.diagonal().setConstant(10.0);
      Eigen::VectorXd added(matrix.size());
      for (int i = 0; i < matrix.size(); ++i) added[i] = dense.row(i).cwiseAbs().sum();
      const Eigen::VectorXd vector = Eigen::VectorXd::Random(matrix.size());
      EXPECT_LT((matrix.times(vector) - dense * vector).norm(), 1e-12 * dense.norm());

      ASSERT_TRUE(matrix.factorize(added));
      dense.diagonal() += added;
      const Eigen::MatrixXd right = Eigen::MatrixXd::Random(matrix.size(), 2);
      EXPECT_LT((dense * matrix.solve(right) - right).norm(), 1e-12 * right.norm());
      EXPECT_FALSE(matrix.factorize(-2.0 * added));
    }
  }
}

TEST(EliminationTree, IsThatOfLiusExample) {
  // Entries of a 5 x 5 matrix; eliminating column 0 joins 2 and 4.
  EXPECT_EQ(elimination_tree(5, {{0, 2}, {4, 0}, {1, 3}, {3, 4}}),
            (std::vector<int>{2, 3, 4, 4, -1}));
}

TEST(EliminationTree, ItsPostorderHasChildrenBeforeTheirParents) {
  const std::vector<int> places = postorder({2, 3, 4, 4, -1, -1});
  EXPECT_EQ(places, (std::vector<int>{0, 2, 1, 3, 4, 5}));
}

TEST(MinimumDegree, EliminatesAStarFromItsLeaves) {
  std::vector<std::pair<int, int>> star;
  for (int leaf = 1; leaf < 9; ++leaf) star.emplace_back(0, leaf);
  EXPECT_GE(elimination_places(9, star)[0], 7);
}

TEST(DenseFront, GivesTheSameBytesOnEachProcessor) {
  Rng rng(21);
  for (const auto& [rows, columns] : {std::pair{3, 3}, {9, 3}, {31, 12}, {77, 40}}) {
    Eigen::MatrixXd root(rows, rows);
    for (double& entry : root.reshaped()) entry = rng.normal();
    const Eigen::MatrixXd matrix =
        root * root.transpose() + rows * Eigen::MatrixXd::Identity(rows, rows);
    const auto factored = [&](Processor processor) {
      const Eigen::MatrixXd left = matrix.leftCols(columns);
      const Eigen::MatrixXd right = matrix.bottomRightCorner(rows - columns, rows - columns);
      std::vector<double> panel(left.data(), left.data() + left.size());
      std::vector<double> rest(right.data(), right.data() + right.size());
      panel.resize(panel.size() + kSlack);
      EXPECT_TRUE(factorize_front(rows, columns, panel.data(), rest.data(), processor));
      // The rest is what the columns leave: that of the whole matrix's factor.
      const Eigen::MatrixXd lower = matrix.llt().matrixL();
      const Eigen::MatrixXd corner = lower.bottomRightCorner(rows - columns, rows - columns);
      const Eigen::MatrixXd expected = corner * corner.transpose();
      const Eigen::Map<Eigen::MatrixXd> found(rest.data(), rows - columns, rows - columns);
      EXPECT_LT(Eigen::MatrixXd((found - expected).triangularView<Eigen::Lower>()).norm(),
                1e-12 * matrix.norm());
      panel.insert(panel.end(), rest.begin(), rest.end());
      return panel;
    };
    EXPECT_EQ(factored(Processor::any), factored(this_processor()));
  }
}

}  // namespace
}  // namespace mapbed
