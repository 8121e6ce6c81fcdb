#include "app/recency.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(Recency, WhatWasUsedTheLongestAgoGivesWayFirstButNothingOfThisRound) {
  Recency recency(4);
  for (const std::size_t thing : {2u, 0u, 1u}) {
    recency.beginRound();
    recency.use(thing);
    recency.keep(thing, 10);
  }
  EXPECT_EQ(recency.leastRecent(), 2u);
  recency.keep(2, 0);
  EXPECT_EQ(recency.leastRecent(), 0u);
  recency.use(0);
  EXPECT_EQ(recency.leastRecent(), Recency::kNone) << "0 and 1 are of this round";
  recency.beginRound();
  EXPECT_EQ(recency.leastRecent(), 0u) << "of two as old the first";
}

TEST(Recency, AddsUpWhatIsKeptHoweverItChanges) {
  Recency recency(2);
  recency.keep(0, 100);
  recency.keep(1, 7);
  recency.keep(0, 30);
  EXPECT_EQ(recency.bytes(), 37u);
  recency.keep(0, 0);
  EXPECT_FALSE(recency.keeps(0));
  EXPECT_EQ(recency.bytes(), 7u);
}

}  // namespace
}  // namespace enfilade
