// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "metrics/matching.h"
#include "tests/metrics/random_objects.h"

// Table I of the paper, recomputed. Its printed scores invert to small integers, which only the
// `exists` semantics explains (the numerator of P counts estimates, that of R ground truth). Every
// row is rebuilt as a world with exactly these counts at both thresholds and goes through the
// shipped matching.
namespace hydrabench {
namespace {

struct Counts {
  std::size_t matched_estimates;
  std::size_t found_truths;
};
struct Printed {
  double precision, recall, f1;
};
struct Row {
  const char* method;
  std::size_t estimates;
  Counts near, wide;  ///< at 0.2 m and at 0.5 m
  Printed printed_near, printed_wide;
};
constexpr std::size_t kTruths = 88;
// The printed recalls .546 and .671 are 48/88 = .5455 and 59/88 = .6705, rounded upwards.
constexpr Row kRows[] = {
    {"SlideSLAM", 34, {7, 5}, {27, 14}, {.206, .057, .089}, {.794, .159, .265}},
    {"Hydra", 68, {36, 36}, {61, 62}, {.529, .409, .461}, {.897, .705, .789}},
    {"Khronos", 69, {25, 21}, {67, 48}, {.362, .239, .288}, {.971, .546, .699}},
    {"ours w/o RMCC", 112, {75, 53}, {94, 60}, {.670, .602, .634}, {.839, .682, .752}},
    {"ours", 89, {70, 52}, {82, 59}, {.787, .591, .675}, {.921, .671, .776}},
};

struct World {
  std::vector<DetectionObject> estimates;
  std::vector<DetectionObject> truths;
};

/// Truths stand 10 m apart. Estimates at 0.1 m come first and make the counts at 0.2 m; estimates
/// at 0.3 m complete those at 0.5 m. Surplus estimates share a truth; surplus truths stand 0.6 m
/// from their neighbour, with one estimate halfway.
World worldWith(const Row& row) {
  World world;
  for (std::size_t g = 0; g < kTruths; ++g) {
    world.truths.push_back({1000 - g, 1, {10.0 * static_cast<double>(g), 0, 0}, 0.4});
  }
  const auto add = [&](std::size_t truth, double distance, Label label = 1) {
    const Eigen::Vector3d offset(0, distance, 0);
    world.estimates.push_back(
        {world.estimates.size(), label, world.truths[truth].center + offset, 0.4});
  };
  for (std::size_t e = 0; e < row.near.matched_estimates; ++e) {
    add(std::min(e, row.near.found_truths - 1), 0.1);
  }
  std::size_t next_truth = row.near.found_truths;
  const std::size_t more_estimates = row.wide.matched_estimates - row.near.matched_estimates;
  std::size_t surplus_truths = 0;
  if (row.wide.found_truths - next_truth > more_estimates) {
    surplus_truths = row.wide.found_truths - next_truth - more_estimates;
  }
  for (std::size_t e = 0; e < more_estimates; ++e) {
    const std::size_t truth = std::min(next_truth, row.wide.found_truths - 1);
    add(truth, 0.3);
    ++next_truth;
    if (surplus_truths > 0) {
      world.truths[next_truth].center = world.truths[truth].center + Eigen::Vector3d(0, 0.6, 0);
      ++next_truth;
      --surplus_truths;
    }
  }
  // The rest match nothing: right place and wrong class, or nowhere near.
  while (world.estimates.size() < row.estimates) {
    const bool wrong_class = world.estimates.size() % 2 == 0;
    add(0, wrong_class ? 0.0 : 5.0, wrong_class ? 2 : 1);
  }
  return world;
}

void expectPrinted(const DetectionCounts& counts, const Printed& printed) {
  EXPECT_NEAR(*precision(counts), printed.precision, 1e-3);
  EXPECT_NEAR(*recall(counts), printed.recall, 1e-3);
  EXPECT_NEAR(*f1(counts), printed.f1, 1e-3);
}

TEST(PublishedCounts, GiveTheTenPrintedRows) {
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.method);
    expectPrinted({row.estimates, row.near.matched_estimates, kTruths, row.near.found_truths},
                  row.printed_near);
    expectPrinted({row.estimates, row.wide.matched_estimates, kTruths, row.wide.found_truths},
                  row.printed_wide);
  }
}

TEST(PublishedCounts, AreWhatMatchingCountsInWorldsBuiltLikeThis) {
  Random random(5);
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.method);
    World world = worldWith(row);
    shuffle(world.estimates, random);
    shuffle(world.truths, random);
    const DetectionCounts near =
        counts(matchExists(world.estimates, world.truths, Threshold::tau(0.2)));
    EXPECT_EQ(near, (DetectionCounts{row.estimates, row.near.matched_estimates, kTruths,
                                     row.near.found_truths}));
    expectPrinted(near, row.printed_near);
    const DetectionCounts wide =
        counts(matchExists(world.estimates, world.truths, Threshold::tau(0.5)));
    EXPECT_EQ(wide, (DetectionCounts{row.estimates, row.wide.matched_estimates, kTruths,
                                     row.wide.found_truths}));
    expectPrinted(wide, row.printed_wide);
  }
}

TEST(PublishedCounts, CannotComeFromOneToOneMatching) {
  // There P |E| = R |G| = number of pairs, which 7 of 34 and 5 of 88 contradict.
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.method);
    const World world = worldWith(row);
    const DetectionCounts wide =
        counts(matchOneToOne(world.estimates, world.truths, Threshold::tau(0.5)));
    EXPECT_EQ(wide.matched_estimates, wide.found_truths);
    EXPECT_NE(row.wide.matched_estimates, row.wide.found_truths);
  }
}

}  // namespace
}  // namespace hydrabench
