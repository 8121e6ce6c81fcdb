#include "app/statistics.h"

#include <gtest/gtest.h>

#include <vector>

namespace enfilade {
namespace {

TEST(Statistics, PercentilesLieOnTheLineBetweenTheClosestRanks) {
  const std::vector<double> values = {40, 10, 30, 20};
  EXPECT_DOUBLE_EQ(percentile(values, 0), 10);
  EXPECT_DOUBLE_EQ(percentile(values, 50), 25);
  EXPECT_DOUBLE_EQ(percentile(values, 95), 38.5);  // rank 2.85
  EXPECT_DOUBLE_EQ(percentile(values, 100), 40);
}

TEST(Statistics, ASummaryHoldsEveryFigureOfItsColumn) {
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  const Summary summary = summarise(values);
  EXPECT_DOUBLE_EQ(summary.mean, 50);
  EXPECT_DOUBLE_EQ(summary.min, 0);
  EXPECT_DOUBLE_EQ(summary.p5, 5);
  EXPECT_DOUBLE_EQ(summary.p50, 50);
  EXPECT_DOUBLE_EQ(summary.p95, 95);
  EXPECT_DOUBLE_EQ(summary.p99, 99);
  EXPECT_DOUBLE_EQ(summary.max, 100);
}

TEST(Statistics, OneValueIsAllItsPercentilesAndNoneIsZero) {
  const std::vector<double> one = {7};
  EXPECT_DOUBLE_EQ(percentile(one, 95), 7);
  EXPECT_DOUBLE_EQ(summarise(one).p99, 7);
  EXPECT_DOUBLE_EQ(percentile({}, 50), 0);
  EXPECT_DOUBLE_EQ(summarise({}).max, 0);
}

}  // namespace
}  // namespace enfilade
