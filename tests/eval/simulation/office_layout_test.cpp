// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/simulation/office_labels.h"
#include "eval/simulation/office_structure.h"
#include "eval/simulation/office_world.h"

namespace hydrabench {
namespace {

using Placed = Furnisher::Placed;

const OfficeLayout& office() {
  static const OfficeLayout layout = layOutOffice(OfficeConfig{}, 1);
  return layout;
}

std::map<Label, int> countByLabel(const OfficeLayout& layout) {
  std::map<Label, int> counts;
  for (const Placed& piece : layout.pieces) ++counts[piece.piece.label];
  return counts;
}

Rect footprint(const Placed& piece) {
  return {piece.box.min().head<2>(), piece.box.max().head<2>()};
}

bool standsOnFloor(const Placed& piece) { return piece.T_world_object.translation().z() == 0; }

TEST(OfficeLayout, HasTheObjectsThatWereAskedFor) {
  const std::map<Label, int> counts = countByLabel(layOutOffice(OfficeConfig{}, 2));
  EXPECT_EQ(counts.at(office_label::kChair), 52);
  EXPECT_EQ(counts.at(office_label::kCouch), 10);
  EXPECT_EQ(counts.at(office_label::kPlant), 12);
  EXPECT_EQ(counts.at(office_label::kBin), 14);
  EXPECT_EQ(counts.at(office_label::kComputer), 18);
}

TEST(OfficeLayout, QuickWorldIsSmall) {
  const OfficeLayout layout = layOutOffice(OfficeConfig::quick(), 1);
  EXPECT_EQ(layout.plan.rooms.size(), 3u);
  const std::map<Label, int> counts = countByLabel(layout);
  EXPECT_EQ(counts.at(office_label::kChair) + counts.at(office_label::kCouch) +
                counts.at(office_label::kPlant) + counts.at(office_label::kBin),
            15);
}

TEST(OfficeConfig, AUserAlwaysGetsTheEvaluationSplit) {
  ConfigReader reader(ConfigDocument::fromString("chairs: 3\n", "w.yaml"));
  OfficeConfig config;
  read(reader, config);
  reader.finish();
  EXPECT_EQ(config.chairs, 3);
  EXPECT_EQ(config.split, InstanceSplit::kEvaluation);
  EXPECT_EQ(OfficeConfig::quick().split, InstanceSplit::kEvaluation);
  // There is no key for it.
  ConfigReader wishful(ConfigDocument::fromString("split: training\n", "w.yaml"));
  read(wishful, config);
  EXPECT_THROW(wishful.finish(), InputError);
}

TEST(OfficeLayout, NoTwoPiecesOverlap) {
  const std::vector<Placed>& pieces = office().pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = i + 1; k < pieces.size(); ++k) {
      const Placed& a = pieces[i];
      const Placed& b = pieces[k];
      // 3 mm: what stands on a desk touches it.
      EXPECT_FALSE(interpenetrate({a.piece.shape->sdf.get(), a.T_world_object, a.box},
                                  {b.piece.shape->sdf.get(), b.T_world_object, b.box}, 0.003))
          << a.piece.shape->family << " " << i << " and " << b.piece.shape->family << " " << k;
    }
  }
}

// One test, because the layout is drawn anew for each.
TEST(OfficeLayout, EveryPieceStandsInItsRoomOnSomethingAndClearOfDoors) {
  for (const Placed& piece : office().pieces) {
    const std::string what = piece.piece.shape->family;
    const FloorPlan::Room& room = office().plan.rooms[static_cast<std::size_t>(piece.room)];
    EXPECT_TRUE(room.inside.contains(footprint(piece))) << what << " in " << room.name;
    EXPECT_LT(piece.box.max().z(), office().plan.height_m) << what;
    if (standsOnFloor(piece)) {
      for (const Rect& area : keepOutAreas(office().plan)) {
        EXPECT_FALSE(area.intersects(footprint(piece))) << what << " before a door";
      }
    } else if (piece.piece.label != office_label::kSign) {  // boards hang on the wall
      const Eigen::Vector3d foot = piece.T_world_object.translation();
      const bool supported =
          std::any_of(office().pieces.begin(), office().pieces.end(), [&](const Placed& other) {
            const Eigen::Vector3d below =
                other.T_world_object.inverse() * (foot - Eigen::Vector3d(0, 0, 0.005));
            return &other != &piece && other.piece.shape->sdf->value(below) < 0;
          });
      EXPECT_TRUE(supported) << what << " floats at " << foot.transpose();
    }
  }
}

TEST(OfficeLayout, IsAFunctionOfItsSeed) {
  const auto draw = [](std::uint64_t seed) { return layOutOffice(OfficeConfig::quick(), seed); };
  const OfficeLayout first = draw(1);
  const OfficeLayout again = draw(1);
  ASSERT_EQ(again.pieces.size(), first.pieces.size());
  for (std::size_t i = 0; i < first.pieces.size(); ++i) {
    EXPECT_EQ(again.pieces[i].T_world_object.matrix(), first.pieces[i].T_world_object.matrix());
    EXPECT_EQ(again.pieces[i].box.min(), first.pieces[i].box.min());
  }
  const OfficeLayout other = draw(2);
  EXPECT_NE(other.pieces.front().T_world_object.matrix(),
            first.pieces.front().T_world_object.matrix());
  EXPECT_NE(other.plan.rooms[1].inside.max(), first.plan.rooms[1].inside.max());
}

TEST(OfficeLayout, EveryInstanceHasItsOwnProportions) {
  std::map<std::string, std::vector<double>> volumes;
  for (const Placed& piece : layOutOffice(OfficeConfig::quick(), 1).pieces) {
    if (piece.piece.label == office_label::kChair) {
      volumes[piece.piece.shape->family].push_back(piece.piece.box.volume());
    }
  }
  for (auto& [family, values] : volumes) {
    std::sort(values.begin(), values.end());
    EXPECT_EQ(std::adjacent_find(values.begin(), values.end()), values.end()) << family;
  }
}

TEST(FloorPlan, RoomsTileTheBuilding) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const FloorPlan plan = drawOfficePlan(Random(seed));
    Rect building;
    double area = 0;
    for (const FloorPlan::Room& room : plan.rooms) {
      building.extend(room.cell);
      area += room.cell.volume();
      EXPECT_TRUE(room.cell.contains(room.inside));
    }
    EXPECT_NEAR(area, building.volume(), 1e-9);
    EXPECT_EQ(plan.rooms.size(), 9u);
  }
}

TEST(FloorPlan, EveryRoomHasADoorToTheCorridorWideEnoughForARobot) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const FloorPlan plan = drawOfficePlan(Random(seed));
    std::vector<int> doors(plan.rooms.size(), 0);
    for (const FloorPlan::Wall& wall : plan.walls) {
      for (const FloorPlan::Opening& opening : wall.openings) {
        if (opening.window) continue;
        EXPECT_GE(opening.high - opening.low, 0.9);
        const double middle = 0.5 * (opening.low + opening.high);
        const int above = plan.roomAt({middle, wall.at + 0.3});
        const int below = plan.roomAt({middle, wall.at - 0.3});
        EXPECT_TRUE(above == 0 || below == 0);
        ++doors[static_cast<std::size_t>(above == 0 ? below : above)];
      }
    }
    for (std::size_t room = 1; room < doors.size(); ++room)
      EXPECT_EQ(doors[room], 1) << plan.rooms[room].name;
  }
}

}  // namespace
}  // namespace hydrabench
