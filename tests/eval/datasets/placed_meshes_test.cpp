// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/mesh_io.h"
#include "core/types/error.h"
#include "eval/datasets/open_dataset.h"
#include "eval/simulation/office_labels.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

/// A hall of 8 m x 6 m with a chair, and a partition that hangs above it.
class PlacedMeshes : public ::testing::Test {
 protected:
  PlacedMeshes() {
    // Seen from inside, a room is a box with its faces turned in; the renderer does not mind the
    // side.
    writeMesh(folder_ / "scene/hall.ply",
              boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(8, 6, 3))));
    writeMesh(folder_ / "scene/chair.ply",
              boxMesh(Aabb(Eigen::Vector3d(-0.25, -0.25, 0), Eigen::Vector3d(0.25, 0.25, 1))));
    writeText(folder_ / "scene/hall.json", json_);
    writeText(folder_ / "world.yaml", yaml_);
  }
  OpenedDataset open() {
    return openDataset(folder_ / "world.yaml", {"root=" + folder_.path().string()});
  }
  std::string fault() {
    return messageOf<InputError>([&] { open(); });
  }
  void replaceIn(const std::string& file, const std::string& original,
                 const std::string& replacement) {
    std::string text = readText(folder_ / file);
    const std::size_t at = text.find(original);
    ASSERT_NE(at, std::string::npos) << original;
    writeText(folder_ / file, text.replace(at, original.size(), replacement));
  }

  TemporaryFolder folder_;
  const std::string json_ = R"({"instances": [
    {"name": "hall", "class": "structure", "is_structure": true, "model": null, "mesh": "hall.ply",
     "T_world_object": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], "mean_rgb": [0.6, 0.6, 0.6]},
    {"name": "seat", "class": "chair", "is_structure": false, "model": "box", "mesh": "chair.ply",
     "T_world_object": [[0, -1, 0, 4], [1, 0, 0, 3], [0, 0, 1, 0], [0, 0, 0, 1]], "mean_rgb": [1, 0, 0]},
    {"name": "screen", "class": "partition", "is_structure": false, "model": null, "mesh": "chair.ply",
     "T_world_object": [[1, 0, 0, 4], [0, 1, 0, 3], [0, 0, 1, 1.1], [0, 0, 0, 1]], "mean_rgb": [0, 1, 0]}]})";
  const std::string yaml_ =
      "type: placed_meshes\nscene: scene/hall.json\npreset: clean\n"
      "classes:\n"
      "  - {class: chair, label: chair}\n"
      "  - {class: partition, label: cubicle, structure: true}\n"
      "  - {class: structure, label: wall}\n"
      "rooms:\n"
      "  - {name: hall, min_m: [0, 0, 0], max_m: [8, 6, 3]}\n"
      "trajectory: {duration_s: 20}\n"
      "camera: {width_px: 60, height_px: 40, fx_px: 35, fy_px: 35, cx_px: 30, cy_px: 20}\n";
};

TEST_F(PlacedMeshes, ObjectsStandWhereTheFilePutsThem) {
  const OpenedDataset opened = open();
  const GroundTruth& truth = opened.dataset->groundTruth();
  ASSERT_EQ(truth.objects.size(), 1u) << "a partition is structure";
  EXPECT_EQ(truth.objects[0].name, "seat");
  EXPECT_EQ(truth.objects[0].subtype, "box");
  EXPECT_EQ(truth.objects[0].room, "hall");
  EXPECT_EQ(truth.objects[0].label, office_label::kChair);
  EXPECT_TRUE(truth.objects[0].scored);
  EXPECT_EQ(truth.objects[0].T_world_object.translation(), Eigen::Vector3d(4, 3, 0));
  EXPECT_GT(truth.objects[0].visible_fraction, 0.3);
}

TEST_F(PlacedMeshes, FramesShowTheChairAsAnInstanceAndThePartitionAsNone) {
  const OpenedDataset opened = open();
  bool chair_seen = false;
  bool partition_seen = false;
  for (std::size_t i = 0; i < opened.dataset->numFrames(); i += 5) {
    const Frame frame = opened.dataset->frame(i);
    for (std::size_t k = 0; k < frame.labels.size(); ++k) {
      const bool has_instance = frame.instances.data()[k] != kNoInstance;
      if (frame.labels.data()[k] == office_label::kChair) {
        chair_seen = true;
        EXPECT_TRUE(has_instance);
      }
      if (frame.labels.data()[k] == office_label::kCubicle) {
        partition_seen = true;
        EXPECT_FALSE(has_instance);
      }
    }
  }
  EXPECT_TRUE(chair_seen);
  EXPECT_TRUE(partition_seen);
}

TEST_F(PlacedMeshes, FaultsNameTheInstanceOrTheRule) {
  replaceIn("scene/hall.json", "\"class\": \"partition\"", "\"class\": \"lamp\"");
  EXPECT_THAT(fault(), HasSubstr("hall.json: instances[2].class: expected a class of the key "
                                 "classes in the config, found \"lamp\""));
  replaceIn("scene/hall.json", "[0, -1, 0, 4]", "[0, -2, 0, 4]");
  EXPECT_THAT(fault(), HasSubstr("hall.json: instances[1].T_world_object: no rigid motion: "));
  replaceIn("scene/hall.json", "\"mesh\": \"hall.ply\"", "\"mesh\": \"gone.ply\"");
  EXPECT_THAT(fault(), HasSubstr("scene/gone.ply: "));
  replaceIn("world.yaml", "label: cubicle", "label: cubical");
  EXPECT_THAT(fault(), HasSubstr("classes.1.label: 'cubical' is unknown, expected one of: "));
  EXPECT_THAT(fault(), HasSubstr("did you mean cubicle?"));
}

}  // namespace
}  // namespace hydrabench
