// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/patchwork.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "tests/core/mapping/ground/analytic_scan.h"

namespace hydrabench {
namespace {

constexpr double kCar = 1.73;    // height of the sensor on a car [m]
constexpr double kRobot = 0.5;   // and on a robot
constexpr double kNoise = 0.02;  // of ranges [m]

double rangeOf(const Eigen::Vector3f& point) { return static_cast<double>(point.head<2>().norm()); }

/// Indices of the points that fit a description.
template <typename Wanted>
std::vector<std::size_t> pointsWhere(const AnalyticScan& scan, const Wanted& wanted) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (wanted(scan.points[i])) indices.push_back(i);
  }
  return indices;
}
double shareOf(const GroundMask& mask, const std::vector<std::size_t>& indices,
               GroundClass wanted = GroundClass::kGround) {
  double count = 0;
  for (const std::size_t i : indices) count += mask.classes[i] == wanted;
  return count / static_cast<double>(indices.size());
}

TEST(Patchwork, LevelGroundIsGroundWithinTheRange) {
  const AnalyticScan scan = lookAt({level(-kCar)}, hdl64(), kCar, kNoise);
  const GroundMask mask = Patchwork{{}}.segment(scan.view());
  EXPECT_EQ(mask.count(GroundClass::kNonGround), 0u);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const double range = rangeOf(scan.points[i]);
    // Bins farther out have too few points.
    if (range > 2.7 && range < 60) {
      ASSERT_EQ(mask.classes[i], GroundClass::kGround) << range;
    } else if (range <= 2.7 || range > 80) {
      ASSERT_EQ(mask.classes[i], GroundClass::kNotJudged) << range;
    }
  }
}

TEST(Patchwork, ASlopeOfTenPercentIsGround) {
  const Sheet slope{{-0.1, 0, 1}, -kCar, {}, true};
  const AnalyticScan scan = lookAt({slope}, hdl64(), kCar, kNoise);
  Patchwork patchwork{{}};
  for (int i = 0; i < 3; ++i) {
    const GroundMask mask = patchwork.segment(scan.view());
    EXPECT_GT(scoreOf(scan, mask, 2.7, 40).recall(), 0.99) << i;
  }
}

TEST(Patchwork, BothSidesOfAKerbAreGround) {
  const double top = -kCar + 0.15;
  Sheet face = wall(6, -kCar, top);
  const AnalyticScan scan =
      lookAt({level(-kCar, -kFar, 6), level(top, 6), face}, hdl64(), kCar, kNoise);
  const GroundMask mask = Patchwork{{}}.segment(scan.view());
  for (const bool above : {false, true}) {
    const auto side = pointsWhere(scan, [&](const Eigen::Vector3f& p) {
      return rangeOf(p) > 2.7 && rangeOf(p) < 30 && (p.x() > 6.1f) == above;
    });
    EXPECT_GT(shareOf(mask, side), 0.95) << "above " << above;
  }
}

TEST(Patchwork, AWallIsNotGroundAboveItsFoot) {
  const AnalyticScan scan =
      lookAt({level(-kCar, -kFar, 8), wall(8, -kCar, 6)}, hdl64(), kCar, kNoise);
  const GroundMask mask = Patchwork{{}}.segment(scan.view());
  // The foot: the thickness of a plane (0.125 m), and what noise tilts it.
  const auto upper = pointsWhere(scan, [&](const Eigen::Vector3f& p) {
    return std::abs(p.x() - 8) < 0.1f && rangeOf(p) < 40 && p.z() > -1.73f + 0.25f;
  });
  EXPECT_GT(upper.size(), 5000u);
  EXPECT_EQ(shareOf(mask, upper), 0);
  const auto floor = pointsWhere(scan, [&](const Eigen::Vector3f& p) {
    return p.x() < 7.5f && rangeOf(p) > 2.7 && rangeOf(p) < 40;
  });
  EXPECT_GT(shareOf(mask, floor), 0.99);
}

/// Level ground, and what a puddle mirrors: points 1.2 m below it, seen steeply.
AnalyticScan groundWithReflections(float strength) {
  AnalyticScan scan = lookAt({level(-kCar)}, hdl64(), kCar, kNoise);
  for (int i = 0; i < 30; ++i) {
    scan.add({5 + 0.02 * i, 1, -kCar - 1.2 - 0.01 * (i % 3)}, false, strength);
  }
  return scan;
}
double shareOfReflections(const GroundMask& mask) {
  std::vector<std::size_t> last;
  for (std::size_t i = mask.classes.size() - 30; i < mask.classes.size(); ++i) last.push_back(i);
  return shareOf(mask, last);
}

TEST(Patchwork, WeakReturnsFromBelowTheGroundAreNoGround) {
  const AnalyticScan weak = groundWithReflections(0.1f);
  EXPECT_EQ(shareOfReflections(Patchwork{{}}.segment(weak.view())), 0);
  EXPECT_GT(scoreOf(weak, Patchwork{{}}.segment(weak.view()), 2.7, 60).recall(), 0.999);
}

TEST(Patchwork, WeakReturnsAtAShallowAngleAreNoReflections) {
  AnalyticScan scan = lookAt({level(-kCar)}, hdl64(), kCar, kNoise);
  for (int i = 0; i < 30; ++i)
    scan.add({12 + 0.02 * i, 1, -kCar - 1.2}, false, 0.1f);  // 14 degrees
  EXPECT_EQ(shareOfReflections(Patchwork{{}}.segment(scan.view())), 1);
}

TEST(Patchwork, OtherReturnsFromBelowCountAsGroundAsPublished) {
  const AnalyticScan strong = groundWithReflections(0.3f);
  EXPECT_EQ(shareOfReflections(Patchwork{{}}.segment(strong.view())), 1);
  const AnalyticScan weak = groundWithReflections(0.1f);
  GroundScan without = weak.view();
  without.intensity = {};
  EXPECT_EQ(shareOfReflections(Patchwork{{}}.segment(without)), 1);
  Patchwork::Config off;
  off.reflection.enabled = false;
  EXPECT_EQ(shareOfReflections(Patchwork{off}.segment(weak.view())), 1);
  // The ground around them stays what it is.
  EXPECT_GT(scoreOf(strong, Patchwork{{}}.segment(strong.view()), 2.7, 60).recall(), 0.999);
}

/// Level ground, and a sector of the first ring filled by something else.
template <typename Height>
AnalyticScan groundWithPatch(const Height& height, int count = 1000) {
  AnalyticScan scan = lookAt({level(-kCar)}, hdl64(), kCar, kNoise);
  const ConcentricZones zones({});
  AnalyticScan kept;
  kept.sensor_height_m = kCar;
  const auto inPatch = [&](const Eigen::Vector3f& p) {
    return zones.binOf(double{p.x()}, double{p.y()}) == 2;
  };
  for (const std::size_t i :
       pointsWhere(scan, [&](const Eigen::Vector3f& p) { return !inPatch(p); })) {
    kept.add(scan.points[i].cast<double>(), true);
  }
  Random random(5);
  for (int i = 0; i < count; ++i) {
    const double angle = random.uniform(0.9, 1.1);
    const double range = random.uniform(4, 6);
    kept.add({range * std::cos(angle), range * std::sin(angle), height(random)}, false);
  }
  return kept;
}
double shareOfPatch(const GroundMask& mask) {
  std::vector<std::size_t> last;
  for (std::size_t i = mask.classes.size() - 1000; i < mask.classes.size(); ++i) last.push_back(i);
  return shareOf(mask, last);
}

TEST(Patchwork, ABushIsGroundOnlyUntilTheThresholdsHaveMoved) {
  const AnalyticScan bush = groundWithPatch([](Random& r) { return r.uniform(-0.9, -0.3); });
  const AnalyticScan plain = lookAt({level(-kCar)}, hdl64(), kCar, kNoise);
  Patchwork fresh{{}};
  EXPECT_GT(shareOfPatch(fresh.segment(bush.view())), 0.1) << "below the sensor: the first limit";
  Patchwork patchwork{{}};
  patchwork.segment(plain.view());
  EXPECT_NEAR(patchwork.thresholds().elevation(0), -kCar, 0.01);
  EXPECT_NEAR(patchwork.thresholds().sensorHeight().value(), kCar, 0.005);
  EXPECT_EQ(shareOfPatch(patchwork.segment(bush.view())), 0);
}

/// What becomes of the patch after a scan of plain ground.
double shareOfPatchAfterPlainGround(const AnalyticScan& scan, bool revert) {
  Patchwork::Config config;
  config.revert.enabled = revert;
  Patchwork patchwork(config);
  patchwork.segment(lookAt({level(-kCar)}, hdl64(), kCar, kNoise).view());
  return shareOfPatch(patchwork.segment(scan.view()));
}

TEST(Patchwork, AHighButFlatPatchIsGround) {
  const AnalyticScan deck = groundWithPatch([](Random&) { return -1.0; });
  EXPECT_EQ(shareOfPatchAfterPlainGround(deck, false), 1) << "flatness makes up for height";
}

TEST(Patchwork, AHighAndUnevenPatchIsGroundOnlyWhereItIsDense) {
  const auto lawn = [](Random& random) { return -1 + 0.02 * random.normal(); };
  EXPECT_GT(shareOfPatchAfterPlainGround(groundWithPatch(lawn, 2000), true), 0.99);
  EXPECT_EQ(shareOfPatchAfterPlainGround(groundWithPatch(lawn, 2000), false), 0);
  EXPECT_EQ(shareOfPatchAfterPlainGround(groundWithPatch(lawn, 1000), true), 0);
}

TEST(Patchwork, WhatTheSensorSeesFromBelowIsNoGround) {
  const AnalyticScan roof = groundWithPatch([](Random&) { return 0.8; });
  EXPECT_EQ(shareOfPatch(Patchwork{{}}.segment(roof.view())), 0);
}

TEST(Patchwork, APatchThatIsNotUprightIsNoGround) {
  // A bank of 50 degrees, seen from its foot.
  const Sheet bank{{-std::tan(50 * std::numbers::pi / 180), 0, 1},
                   -kCar - 5 * std::tan(50 * std::numbers::pi / 180),
                   {{5, -kFar, -kFar}, {kFar, kFar, kFar}},
                   false};
  const AnalyticScan scan = lookAt({level(-kCar, -kFar, 5), bank}, hdl64(), kCar, kNoise);
  const GroundMask mask = Patchwork{{}}.segment(scan.view());
  const auto high =
      pointsWhere(scan, [](const Eigen::Vector3f& p) { return p.x() > 5.3f && p.z() > -1.2f; });
  EXPECT_GT(high.size(), 1000u);
  EXPECT_LT(shareOf(mask, high), 0.01);
}

TEST(Patchwork, BinsWithFewPointsAreNotJudged) {
  AnalyticScan scan;
  scan.sensor_height_m = kCar;
  for (int i = 0; i < 9; ++i) scan.add({5 + 0.1 * i, 0.5 + 0.1 * (i % 3), -kCar}, true);
  EXPECT_EQ(Patchwork{{}}.segment(scan.view()).count(GroundClass::kNotJudged), 9u);
  scan.add({5.5, 0.7, -kCar}, true);
  EXPECT_EQ(Patchwork{{}}.segment(scan.view()).count(GroundClass::kGround), 10u);
}

TEST(Patchwork, BinsOfTooFewLinesAreNotJudgedWhereLinesAreKnown) {
  const AnalyticScan scan = lookAt({level(-kRobot)}, vlp16(), kRobot, kNoise);
  Patchwork::Config config = Patchwork::Config::forSensor("vlp16");
  const auto far = pointsWhere(scan, [](const Eigen::Vector3f& p) { return rangeOf(p) > 8.5; });
  EXPECT_EQ(shareOf(Patchwork(config).segment(scan.view()), far), 1);
  config.min_lines = 2;
  EXPECT_EQ(shareOf(Patchwork(config).segment(scan.view()), far, GroundClass::kNotJudged), 1);
  GroundScan without = scan.view();
  without.lines = {};
  EXPECT_EQ(shareOf(Patchwork(config).segment(without), far), 1);
}

/// A street with kerbs of 0.12 m, a facade, parked cars and benches, as a robot on it sees it.
std::vector<Sheet> street(double along) {
  const double top = -kRobot + 0.12;
  std::vector<Sheet> sheets;
  const auto strip = [&](double y_low, double y_high, double z) {
    sheets.push_back(
        {Eigen::Vector3d::UnitZ(), z, {{-kFar, y_low, -kFar}, {kFar, y_high, kFar}}, true});
  };
  const auto across = [&](double y, double z_low, double z_high) {
    sheets.push_back(
        {Eigen::Vector3d::UnitY(), y, {{-kFar, -kFar, z_low}, {kFar, kFar, z_high}}, false});
  };
  strip(-4, 4, -kRobot);
  strip(4, 9, top);
  strip(-20, -4, top);
  across(-4, -kRobot, top);
  across(4, -kRobot, top);
  across(9, -kRobot, 10);
  for (int i = -4; i < 5; ++i) {
    const double x = 9 * i - along;
    for (const Sheet& side : standing({{x, 2, -1}, {x + 4, 3.8, 0.9}})) sheets.push_back(side);
    for (const Sheet& side : standing({{x + 5, -6, -1}, {x + 6.5, -5.5, 0.07}})) {
      sheets.push_back(side);
    }
  }
  return sheets;
}

TEST(Patchwork, SixteenLinesAtTheHeightOfARobotWantTheirOwnSettings) {
  GroundScore own, published;
  Patchwork with_own(Patchwork::Config::forSensor("vlp16"));
  Patchwork with_published{{}};
  for (int i = 0; i < 5; ++i) {
    const AnalyticScan scan =
        lookAt(street(0.9 * i), vlp16(), kRobot, kNoise, static_cast<std::uint64_t>(i + 1));
    own += scoreOf(scan, with_own.segment(scan.view()), 1, 40);
    published += scoreOf(scan, with_published.segment(scan.view()), 1, 40);
  }
  EXPECT_GT(own.f1(), 0.93) << own.precision() << " " << own.recall();
  EXPECT_GT(own.recall(), 0.97);
  EXPECT_LT(published.f1(), 0.8);
}

TEST(Patchwork, SameBytesForAnyNumberOfThreads) {
  std::vector<std::vector<GroundClass>> results;
  for (const int threads : {1, 2, 7}) {
    setNumThreads(threads);
    Patchwork patchwork(Patchwork::Config::forSensor("vlp16"));
    patchwork.segment(lookAt(street(0), vlp16(), kRobot, kNoise, 1).view());
    results.push_back(
        patchwork.segment(lookAt(street(1), vlp16(), kRobot, kNoise, 2).view()).classes);
  }
  setNumThreads(0);
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

TEST(Patchwork, NothingIsLearnedFromAScanThatIsRefused) {
  Patchwork patchwork{{}};
  const AnalyticScan scan = lookAt({level(-kCar)}, hdl64(), kCar, kNoise);
  GroundScan broken = scan.view();
  broken.lines = broken.lines.first(10);
  EXPECT_THROW(patchwork.segment(broken), InputError);
  EXPECT_FALSE(patchwork.thresholds().sensorHeight());
  EXPECT_EQ(patchwork.thresholds().elevation(0), 0);
}

}  // namespace
}  // namespace hydrabench
