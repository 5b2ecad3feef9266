// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/flow_pool.h"

#include <cmath>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/eval/training/toy_flow.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

constexpr double kPi = std::numbers::pi;

class FlowPoolOfToys : public ::testing::Test {
 protected:
  FlowPoolOfToys() { cacheToyFlowWorlds(folder_.path(), config_); }
  FlowPool pool() const {
    return {config_, InstanceSplit::kTraining, folder_.path(), [](int, int) { return true; }};
  }
  LatentFlowTrainingConfig config_ = toyFlowTraining();
  TemporaryFolder folder_;
};

TEST_F(FlowPoolOfToys, DrawsTheSameTwiceAndClassesByTheirWeight) {
  config_.class_weights = {{"chair", 3}, {"couch", 1}, {"bin", 0}, {"plant", 0}};
  const FlowPool pool = this->pool();
  EXPECT_EQ(pool.shapes().size(), 4u);  // two worlds, one chair and one couch each
  EXPECT_EQ(pool.grids(), 1);
  int chairs = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const LatentSample sample = pool.drawLatent(true, Random(i));
    chairs += pool.shapes()[sample.latent].shape->class_name == "chair";
    EXPECT_EQ(sample.view.cells, pool.drawLatent(true, Random(i)).view.cells);
  }
  EXPECT_NEAR(chairs / 300.0, 0.75, 0.08);
}

TEST_F(FlowPoolOfToys, PosesAreThoseOfTheObjectUnderAnyOfItsSymmetries) {
  const FlowPool pool = this->pool();
  std::set<std::pair<std::string, int>> turns;
  for (std::uint64_t i = 0; i < 150; ++i) {
    const PoseSample sample = pool.drawPose(false, Random(i));
    const LocalFrame frame = fromPoseTokens(sample.pose, sample.input.frame);
    // Find the view it was drawn from by its centre.
    const TrainingPool::Shape* shape = nullptr;
    const TrainingView* view = nullptr;
    for (const TrainingPool::Shape& candidate : pool.shapes()) {
      for (const TrainingView* seen : candidate.views) {
        if ((seen->center.cast<double>() - frame.center).norm() < 1e-4) {
          shape = &candidate;
          view = seen;
        }
      }
    }
    ASSERT_TRUE(view);
    EXPECT_NEAR(frame.scale, shape->shape->half_extent_m, 1e-5);
    const double turn = std::remainder(frame.bearing - view->yaw, 2 * kPi);
    if (shape->shape->class_name == "plant") {  // faces the camera
      const double facing = std::atan2(view->center.y(), view->center.x()) + kPi;
      EXPECT_NEAR(std::remainder(frame.bearing - facing, 2 * kPi), 0, 1e-5);
    } else {
      turns.insert({shape->shape->class_name, static_cast<int>(std::lround(turn / kPi * 2))});
      EXPECT_NEAR(std::remainder(turn, kPi / 2), 0, 1e-5);
    }
  }
  turns.erase({"bin", -2});
  turns.insert({"bin", 2});  // half a turn, either way round
  EXPECT_EQ(turns, (std::set<std::pair<std::string, int>>{
                       {"bin", 0}, {"bin", 2}, {"chair", 0}, {"couch", 0}}));
}

TEST_F(FlowPoolOfToys, DistancesAreThoseOfTheGridsFrame) {
  const FlowPool pool = this->pool();
  for (std::uint64_t i = 0; i < 20; ++i) {
    const FieldSample sample = pool.drawField(40, Random(i));
    ASSERT_EQ(sample.points.size(), 40u);
    for (std::size_t k = 0; k < 40; ++k) {
      const Eigen::Vector3d p = sample.points[k].cast<double>();
      ASSERT_LE(p.cwiseAbs().maxCoeff(), kGridHalfSide);
      // The node next to it knows about the same distance, if neither is cut off.
      const Eigen::Vector3i node =
          ((p.array() + kGridHalfSide) / kGridCell).floor().cast<int>().min(kGridSide - 1);
      const double near =
          kTruncation / 127 * sample.grid->values[gridIndex(node.x(), node.y(), node.z())];
      const double expected = std::clamp<double>(sample.distances[k], -kTruncation, kTruncation);
      EXPECT_NEAR(near, expected, 0.9 * kGridCell);
    }
  }
}

TEST_F(FlowPoolOfToys, PutsThePointsOfAViewOnTheShapeOfItsGrid) {
  // Points of toys lie on their surface: cells that hold some have nodes near the surface.
  const FlowPool pool = this->pool();
  for (const bool augment : {false, true}) {
    for (std::uint64_t i = 0; i < 20; ++i) {
      const LatentSample sample = pool.drawLatent(augment, Random(i));
      const ShapeGrid& grid = pool.shapes()[sample.latent].shape->grids[0];
      int held = 0;
      for (int block = 0; block < kShapeTokens; ++block) {
        for (int inner = 0; inner < ViewGrid::kCellsOfBlock; ++inner) {
          const auto at = static_cast<std::size_t>((block * ViewGrid::kCellsOfBlock + inner) *
                                                   ViewGrid::kCellFeatures);
          if (sample.view.cells[at] == 0) continue;
          ++held;
          const int x = 2 * (block % 4 * 4 + inner % 4);
          const int y = 2 * (block / 4 % 4 * 4 + inner / 4 % 4);
          const int z = 2 * (block / 16 * 4 + inner / 16);
          EXPECT_LE(std::abs(grid.values[gridIndex(x, y, z)]), 127 * 0.2 / kTruncation);
        }
      }
      EXPECT_GE(held, 20);
    }
  }
}

TEST_F(FlowPoolOfToys, IsNotCompleteWhenEndedAndNeedsSomeView) {
  const FlowPool ended(config_, InstanceSplit::kTraining, folder_.path(),
                       [](int world, int) { return world < 1; });
  EXPECT_FALSE(ended.complete());
  for (auto& [name, weight] : config_.class_weights) weight = name == "tree" ? 1 : 0;
  EXPECT_THAT(messageOf<InputError>([&] { pool(); }), ::testing::HasSubstr("class_weights"));
}

}  // namespace
}  // namespace hydrabench
