// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "eval/training/training_pool.h"
#include "tests/eval/training/toy_world.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

TrainingWorldConfig config() {
  TrainingWorldConfig result;
  result.world = "quick";
  return result;
}

void expectNear(const std::vector<Eigen::Vector3f>& a, const std::vector<Eigen::Vector3f>& b,
                float step) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LE((a[i] - b[i]).cwiseAbs().maxCoeff(), 0.51f * step);
  }
}

TEST(TrainingWorldFile, GivesBackWhatWasWrittenToAMillimetre) {
  const TemporaryFolder folder;
  TrainingWorldConfig with_grids = config();
  with_grids.grid_frames = 2;
  TrainingWorld world = toyWorld(4, 2);
  world.shapes[1].grids[1].frame.bearing = -1;
  world.views[1].points.cut = {1, 0, 0, 1};
  world.views[1].on_object[7] = 0;
  writeTrainingWorld(folder / "a/b.world", with_grids, world);
  EXPECT_FALSE(readTrainingWorld(folder / "a/b.world", config()));
  const std::optional<TrainingWorld> read = readTrainingWorld(folder / "a/b.world", with_grids);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->shapes.size(), world.shapes.size());
  ASSERT_EQ(read->views.size(), world.views.size());
  for (std::size_t i = 0; i < world.shapes.size(); ++i) {
    const TrainingShape& a = world.shapes[i];
    const TrainingShape& b = read->shapes[i];
    EXPECT_EQ(a.family, b.family);
    EXPECT_EQ(a.class_name, b.class_name);
    EXPECT_EQ(a.yaw_symmetry, b.yaw_symmetry);
    EXPECT_EQ(a.half_extent_m, b.half_extent_m);
    expectNear(a.points, b.points, 2.0f / 32767);
    for (std::size_t k = 0; k < a.distances.size(); ++k) {
      EXPECT_NEAR(a.distances[k], b.distances[k], 1.01f / 32767);
    }
    ASSERT_EQ(b.grids.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(a.grids[k].frame.center, b.grids[k].frame.center);
      EXPECT_EQ(a.grids[k].frame.bearing, b.grids[k].frame.bearing);
      EXPECT_EQ(a.grids[k].frame.scale, b.grids[k].frame.scale);
      EXPECT_EQ(a.grids[k].values, b.grids[k].values);
    }
  }
  for (std::size_t i = 0; i < world.views.size(); ++i) {
    const TrainingView& a = world.views[i];
    const TrainingView& b = read->views[i];
    EXPECT_EQ(a.shape, b.shape);
    EXPECT_EQ(a.center, b.center);
    EXPECT_EQ(a.yaw, b.yaw);
    EXPECT_EQ(a.clean, b.clean);
    EXPECT_EQ(a.points.cut, b.points.cut);
    EXPECT_EQ(a.on_object, b.on_object);
    expectNear(a.points.object, b.points.object, 0.001f);
    expectNear(a.points.context, b.points.context, 0.001f);
  }
}

TEST(TrainingWorldFile, ThatIsCutShortAnywhereOrLongerIsNone) {
  const TemporaryFolder folder;
  writeTrainingWorld(folder / "whole", config(), toyWorld(4));
  const std::string bytes = readText(folder / "whole");
  for (std::size_t size = 0; size < bytes.size(); size += 1009) {
    writeText(folder / "part", bytes.substr(0, size));
    ASSERT_FALSE(readTrainingWorld(folder / "part", config())) << size;
  }
  writeText(folder / "part", bytes.substr(0, bytes.size() - 1));
  EXPECT_FALSE(readTrainingWorld(folder / "part", config()));
  writeText(folder / "longer", bytes + "x");
  EXPECT_FALSE(readTrainingWorld(folder / "longer", config()));
  EXPECT_FALSE(readTrainingWorld(folder / "absent", config()));
}

TEST(TrainingWorldFile, OfAnyOtherConfigIsNone) {
  const TemporaryFolder folder;
  writeTrainingWorld(folder / "file", config(), toyWorld(4));
  std::vector<TrainingWorldConfig> others(8, config());
  others[0].world = "office";
  others[1].frames += 1;
  others[2].max_views_per_shape += 1;
  others[3].sdf_points += 1;
  others[4].min_pixels += 1;
  others[5].image_width += 1;
  others[6].clean_masks += 0.1;
  others[7].max_depth_m += 0.1;
  for (const TrainingWorldConfig& other : others) {
    EXPECT_FALSE(readTrainingWorld(folder / "file", other));
  }
  EXPECT_TRUE(readTrainingWorld(folder / "file", config()));
}

TEST(CachedTrainingWorld, TakesWhatIsInTheFile) {
  const TemporaryFolder folder;
  writeTrainingWorld(folder / "val_000003.world", config(), toyWorld(4));
  EXPECT_EQ(
      cachedTrainingWorld(config(), InstanceSplit::kValidation, 3, folder.path()).shapes.size(),
      4u);
}

}  // namespace
}  // namespace hydrabench
