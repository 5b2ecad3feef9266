// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/mesh_gallery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/mesh_io.h"
#include "core/types/error.h"
#include "eval/datasets/open_dataset.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

/// A chair of 1 m that does not stand on its floor, and a hydrant, a class that offices lack.
class MeshGallery : public ::testing::Test {
 protected:
  MeshGallery() {
    writeMesh(folder_ / "meshes/seat.ply",
              boxMesh(Aabb(Eigen::Vector3d(2, 2, 5), Eigen::Vector3d(3, 3, 6))));
    writeMesh(folder_ / "meshes/hydrant.ply",
              boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.4, 0.4, 0.9))));
    writeText(
        folder_ / "gallery.yaml",
        "type: mesh_gallery\nfolder: meshes\npreset: clean\n"
        "meshes:\n  - {file: seat.ply, label: chair}\n  - {file: hydrant.ply, label: hydrant}\n"
        "views: {per_mesh: 4}\n"
        "camera: {width_px: 60, height_px: 40, fx_px: 35, fy_px: 35, cx_px: 30, cy_px: 20}\n");
  }
  OpenedDataset open(const std::string& file = "gallery.yaml") {
    return openDataset(folder_ / file, {"root=" + folder_.path().string()});
  }
  TemporaryFolder folder_;
};

TEST_F(MeshGallery, EveryMeshStandsOnTheFloorAndIsScored) {
  const OpenedDataset opened = open();
  const GroundTruth& truth = opened.dataset->groundTruth();
  ASSERT_EQ(truth.objects.size(), 2u);
  for (const GroundTruthObject& object : truth.objects) {
    const Aabb box = bounds(transformed(object.T_world_object, *object.mesh));
    EXPECT_NEAR(box.min().z(), 0, 1e-6);
    EXPECT_TRUE(object.scored);
  }
  EXPECT_EQ(truth.objects[0].subtype, "seat");
  EXPECT_EQ(opened.dataset->labelSpace().nameOf(truth.objects[1].label), "hydrant");
}

TEST_F(MeshGallery, EveryFrameShowsItsMeshInTheMiddleAndNoOther) {
  const OpenedDataset opened = open();
  ASSERT_EQ(opened.dataset->numFrames(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Frame frame = opened.dataset->frame(i);
    ASSERT_EQ(frame.instance_labels.size(), 1u) << i;
    EXPECT_EQ(frame.instance_labels.begin()->second,
              opened.dataset->groundTruth().objects[i / 4].label);
    EXPECT_NE(frame.instances(30, 20), kNoInstance) << i;
    EXPECT_GT(frame.depth(30, 20), 0);
    EXPECT_EQ(frame.instances(0, 0), kNoInstance);
  }
}

TEST_F(MeshGallery, OpensFromItsResolvedConfig) {
  const OpenedDataset opened = open();
  const OpenedDataset again =
      openDataset(ConfigDocument::fromString(opened.resolved_config, "resolved"));
  EXPECT_EQ(again.dataset->frame(3).depth, opened.dataset->frame(3).depth);
  EXPECT_EQ(again.resolved_config, opened.resolved_config);
}

TEST_F(MeshGallery, NamesAMeshThatIsNotThere) {
  writeText(folder_ / "other.yaml",
            "type: mesh_gallery\nfolder: meshes\nmeshes:\n  - {file: no.ply, label: chair}\n");
  EXPECT_THAT(messageOf<InputError>([&] { open("other.yaml"); }), HasSubstr("no.ply"));
}

}  // namespace
}  // namespace hydrabench
