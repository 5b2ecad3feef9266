// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/concentric_zones.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

int ringOf(const ConcentricZones& zones, double range) {
  const int bin = zones.binOf(range * std::cos(0.1), range * std::sin(0.1));
  int ring = -1;
  for (const ConcentricZones::Ring& candidate : zones.rings()) ring += candidate.first_bin <= bin;
  return ring;
}

TEST(ConcentricZones, BeginAtThePublishedRadii) {
  const ConcentricZones zones({});
  EXPECT_EQ(zones.rings().size(), 14u);
  EXPECT_EQ(zones.numBins(), 2 * 16 + 4 * 32 + 4 * 54 + 4 * 32);
  EXPECT_EQ(zones.binsOfFirstZone(), 32);
  // (7 * 2.7 + 80) / 8 = 12.3625, (3 * 2.7 + 80) / 4 = 22.025, (2.7 + 80) / 2 = 41.35
  const double begins[] = {2.7, 12.3625, 22.025, 41.35, 80};
  const int first_rings[] = {0, 2, 6, 10, 14};
  for (int zone = 0; zone < 4; ++zone) {
    EXPECT_EQ(ringOf(zones, begins[zone] + 1e-6), first_rings[zone]);
    EXPECT_EQ(ringOf(zones, begins[zone + 1] - 1e-6), first_rings[zone + 1] - 1);
  }
  // The first zone's two rings meet in its middle.
  EXPECT_EQ(ringOf(zones, 7.53), 0);
  EXPECT_EQ(ringOf(zones, 7.54), 1);
}

TEST(ConcentricZones, NothingIsBinnedOutsideTheRange) {
  const ConcentricZones zones({});
  EXPECT_EQ(zones.binOf(2.7, 0), ConcentricZones::kOutside);
  EXPECT_EQ(zones.binOf(0, 80.001), ConcentricZones::kOutside);
  EXPECT_NE(zones.binOf(-80, 0), ConcentricZones::kOutside);
  EXPECT_EQ(zones.binOf(std::numeric_limits<double>::quiet_NaN(), 5), ConcentricZones::kOutside);
}

TEST(ConcentricZones, SectorsRunCounterClockwiseFromTheXAxis) {
  const ConcentricZones zones({});
  for (int sector = 0; sector < 16; ++sector) {
    const double angle = (sector + 0.5) / 16 * 2 * std::numbers::pi;
    EXPECT_EQ(zones.binOf(5 * std::cos(angle), 5 * std::sin(angle)), sector);
  }
  EXPECT_EQ(zones.binOf(5, 0), 0);
  EXPECT_EQ(zones.binOf(5, -1e-300), 15) << "an angle that rounds to a full turn";
}

}  // namespace
}  // namespace hydrabench
