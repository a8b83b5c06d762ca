#include "algorithms/pose_graph/sparse_factor.h"

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

// The identity and noise whose largest singular value is about 0.6, so that a chain of them keeps
// its digits.
template <int B>
Eigen::Matrix<double, B, B> random_block(Rng& rng) {
  const auto noise = [&] { return 0.3 / std::sqrt(B) * rng.normal(); };
  return Eigen::Matrix<double, B, B>::Identity() + Eigen::Matrix<double, B, B>::NullaryExpr(noise);
}

template <int B>
NodeRows<B> random_rows(int first, int second, Rng& rng) {
  NodeRows<B> rows{first, second, random_block<B>(rng), -random_block<B>(rng), {}};
  rows.value = Eigen::Matrix<double, B, 1>::NullaryExpr([&] { return rng.normal(); });
  return rows;
}

// A chain of nodes whose first is tied to the origin.
template <int B>
std::vector<NodeRows<B>> chain(int nodes, Rng& rng) {
  std::vector<NodeRows<B>> all = {random_rows<B>(0, -1, rng)};
  for (int i = 1; i < nodes; ++i) all.push_back(random_rows<B>(i - 1, i, rng));
  return all;
}

template <int B>
struct System {
  int nodes = 0;
  std::vector<NodeBlock<B>> blocks = {};
  Eigen::MatrixXd matrix = {};
  Eigen::VectorXd h = {};
  double c = 0.0;
};

template <int B>
System<B> system_of(int nodes, const std::vector<NodeRows<B>>& all) {
  System<B> system{.nodes = nodes};
  system.matrix.setZero(nodes * B, nodes * B);
  system.h.setZero(nodes * B);
  for (const NodeRows<B>& rows : all) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(B, nodes * B);
    a.template middleCols<B>(rows.first * B) += rows.of_first;
    if (rows.second >= 0) a.template middleCols<B>(rows.second * B) += rows.of_second;
    system.matrix += a.transpose() * a;
    system.h += a.transpose() * rows.value;
    system.c += rows.value.squaredNorm();
    const auto add = [&](int row, int col) {
      const auto of = [&](int node) { return a.template middleCols<B>(node * B); };
      system.blocks.push_back({row, col, of(row).transpose() * of(col)});
    };
    add(rows.first, rows.first);
    if (rows.second < 0 || rows.second == rows.first) continue;
    add(rows.second, rows.second);
    // Either place of the pair will do.
    if (system.blocks.size() % 2 == 0) {
      add(rows.first, rows.second);
    } else {
      add(rows.second, rows.first);
    }
  }
  return system;
}

template <int B>
SparseFactor<B> factor_of(const System<B>& system) {
  SparseFactor<B> factor(system.nodes, system.blocks);
  EXPECT_TRUE(factor.factorize(system.blocks, system.h, system.c));
  return factor;
}

template <int B>
void expect_same(const SparseFactor<B>& factor, const SparseFactor<B>& again, double tolerance) {
  const Eigen::VectorXd x = again.minimizer();
  EXPECT_LE((factor.minimizer() - x).norm(), tolerance * x.norm());
  EXPECT_NEAR(factor.minimum(), again.minimum(), tolerance * (1.0 + again.minimum()));
  EXPECT_NEAR(factor.log_determinant(), again.log_determinant(),
              tolerance * std::abs(again.log_determinant()));
}

template <class Size>
class SparseFactorOf : public ::testing::Test {};

using Sizes = ::testing::Types<std::integral_constant<int, 3>, std::integral_constant<int, 4>,
                               std::integral_constant<int, 6>>;
TYPED_TEST_SUITE(SparseFactorOf, Sizes);

TYPED_TEST(SparseFactorOf, ARandomGraphAgreesWithTheDenseFactor) {
  constexpr int B = TypeParam::value;
  constexpr int kNodes = 30;
  Rng rng(1);
  std::vector<NodeRows<B>> all = chain<B>(kNodes, rng);
  for (int i = 0; i < 40; ++i) {
    all.push_back(random_rows<B>(static_cast<int>(rng.index(kNodes)),
                                 static_cast<int>(rng.index(kNodes)), rng));
  }
  const System<B> system = system_of(kNodes, all);
  const SparseFactor<B> factor = factor_of(system);

  const Eigen::LDLT<Eigen::MatrixXd> dense(system.matrix);
  const Eigen::VectorXd x = dense.solve(system.h);
  EXPECT_LE((factor.minimizer() - x).norm(), 1e-10 * x.norm());
  EXPECT_NEAR(factor.minimum(), system.c - system.h.dot(x), 1e-9 * system.c);
  EXPECT_NEAR(factor.log_determinant(), dense.vectorD().array().log().sum(), 1e-9);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(kNodes * B, -1.0, 2.0);
  EXPECT_LE((system.matrix * factor.solve(b) - b).norm(), 1e-9 * b.norm());

  NodeRows<B> between = random_rows<B>(3, 27, rng);  // which no constraint links
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(B, kNodes * B);
  a.template middleCols<B>(3 * B) = between.of_first;
  a.template middleCols<B>(27 * B) = between.of_second;
  const Eigen::MatrixXd covariance = a * dense.solve(a.transpose());
  EXPECT_LE((factor.covariance(between) - covariance).norm(), 1e-9 * covariance.norm());
}

// Hundreds of constraints that come and go, which link what was not linked when the order was
// found, on a chain that grows: as if factored anew.
TYPED_TEST(SparseFactorOf, WhatIsAddedAndRemovedIsThatOfTheGraphAsItIsThen) {
  constexpr int B = TypeParam::value;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Rng rng(seed);
    int nodes = 20;
    std::vector<NodeRows<B>> kept = chain<B>(nodes, rng);
    std::vector<NodeRows<B>> loops;
    SparseFactor<B> factor = factor_of(system_of(nodes, kept));
    for (int step = 0; step < 300; ++step) {
      if (step % 10 == 9) {
        NodeRows<B> odometry = random_rows<B>(nodes - 1, nodes, rng);
        if (step % 20 == 9) {
          std::swap(odometry.first, odometry.second);
          std::swap(odometry.of_first, odometry.of_second);
        }
        factor.append(odometry);
        kept.push_back(odometry);
        ++nodes;
      } else if (loops.empty() || rng.uniform() < 0.6) {
        const auto any = [&] {
          return static_cast<int>(rng.index(static_cast<std::uint64_t>(nodes)));
        };
        const int first = any();
        loops.push_back(random_rows<B>(first, rng.uniform() < 0.1 ? -1 : any(), rng));
        factor.add(loops.back());
      } else {
        std::swap(loops[rng.index(loops.size())], loops.back());
        EXPECT_TRUE(factor.remove(loops.back()));
        loops.pop_back();
      }
      if (step % 20 != 19) continue;
      std::vector<NodeRows<B>> all = kept;
      all.insert(all.end(), loops.begin(), loops.end());
      expect_same(factor, factor_of(system_of(nodes, all)), 1e-9);
    }
  }
}

TEST(SparseFactor, ARemovalThatWouldLeaveANodeFreeChangesNothing) {
  Rng rng(3);
  const std::vector<NodeRows<3>> all = chain<3>(8, rng);
  SparseFactor<3> factor = factor_of(system_of(8, all));
  const Eigen::VectorXd x = factor.minimizer();
  const double before = factor.log_determinant();
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_FALSE(factor.remove(all[i]));
    EXPECT_EQ(factor.minimizer(), x);
    EXPECT_EQ(factor.log_determinant(), before);
  }
}

TEST(SparseFactor, AMatrixThatIsNotPositiveDefiniteHasNone) {
  const std::vector<NodeBlock<3>> blocks = {{0, 0, Eigen::Matrix3d::Identity()},
                                            {1, 1, Eigen::Matrix3d::Identity()},
                                            {0, 1, 1.01 * Eigen::Matrix3d::Identity()}};
  SparseFactor<3> factor(2, blocks);
  EXPECT_FALSE(factor.factorize(blocks));
}

TEST(SparseFactor, ARemovalThatLeavesLittleIsToldToSpoilDigits) {
  Rng rng(3);
  std::vector<NodeRows<3>> all = chain<3>(8, rng);
  SparseFactor<3> factor = factor_of(system_of(8, all));
  EXPECT_EQ(factor.rounding(), 1.0);
  NodeRows<3> strong = random_rows<3>(0, 7, rng);
  strong.of_first *= 1e4;
  strong.of_second *= 1e4;
  factor.add(strong);
  EXPECT_EQ(factor.rounding(), 2.0);
  EXPECT_TRUE(factor.remove(strong));
  EXPECT_GE(factor.rounding(), 1e6);
  expect_same(factor, factor_of(system_of(8, all)), 1e-4);
}

// In whatever order: a ring of n nodes has n on the diagonal, n links, and each node that goes but
// the last three makes one more.
TEST(SparseFactor, GrowsByWhatALoopNeeds) {
  Rng rng(4);
  const std::vector<NodeRows<3>> all = chain<3>(50, rng);
  SparseFactor<3> factor = factor_of(system_of(50, all));
  EXPECT_EQ(factor.blocks(), 50u + 49u);
  const NodeRows<3> loop = random_rows<3>(0, 49, rng);
  factor.add(loop);
  EXPECT_EQ(factor.blocks(), 50u + 50u + 47u);
  EXPECT_TRUE(factor.remove(loop));
  EXPECT_EQ(factor.blocks(), 50u + 50u + 47u);
}

}  // namespace
}  // namespace mapbed
