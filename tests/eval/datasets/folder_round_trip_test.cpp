// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <atomic>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/image_io.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/datasets/folder_export.h"
#include "eval/datasets/open_dataset.h"
#include "tests/eval/datasets/toy_dataset.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

void expectSameFrame(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.stamp_ns, b.stamp_ns);
  EXPECT_EQ(a.camera, b.camera);
  EXPECT_EQ(a.T_world_camera.matrix(), b.T_world_camera.matrix());
  EXPECT_TRUE(a.color == b.color);
  EXPECT_TRUE(a.depth == b.depth);
  EXPECT_TRUE(a.labels == b.labels);
  EXPECT_TRUE(a.instances == b.instances);
  EXPECT_EQ(a.instance_labels, b.instance_labels);
}

void expectSameMesh(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  EXPECT_TRUE(a.vertices == b.vertices);
  EXPECT_TRUE(a.faces == b.faces);
  EXPECT_TRUE(a.colors == b.colors);
}

void expectSameGroundTruth(const GroundTruth& a, const GroundTruth& b) {
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    const GroundTruthObject& x = a.objects[i];
    const GroundTruthObject& y = b.objects[i];
    EXPECT_EQ(x.id, y.id);
    EXPECT_EQ(x.label, y.label);
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.subtype, y.subtype);
    EXPECT_EQ(x.room, y.room);
    EXPECT_EQ(x.scored, y.scored);
    EXPECT_EQ(x.visible_fraction, y.visible_fraction);
    EXPECT_EQ(x.T_world_object.matrix(), y.T_world_object.matrix());
    expectSameMesh(*x.mesh, *y.mesh);
  }
  ASSERT_EQ(a.rooms.size(), b.rooms.size());
  for (std::size_t i = 0; i < a.rooms.size(); ++i) {
    EXPECT_EQ(a.rooms[i].name, b.rooms[i].name);
    EXPECT_EQ(a.rooms[i].box.min(), b.rooms[i].box.min());
    EXPECT_EQ(a.rooms[i].box.max(), b.rooms[i].box.max());
  }
  ASSERT_EQ(a.trajectory.size(), b.trajectory.size());
  for (std::size_t i = 0; i < a.trajectory.size(); ++i) {
    EXPECT_EQ(a.trajectory[i].stamp_ns, b.trajectory[i].stamp_ns);
    EXPECT_EQ(a.trajectory[i].T_world_camera.matrix(), b.trajectory[i].T_world_camera.matrix());
  }
}

/// Bytes of every file below a folder.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), folder).string()] = readText(entry.path());
    }
  }
  return files;
}

TEST(FolderDataset, ReadsBackTheFramesAndGroundTruthThatWereExported) {
  TemporaryFolder folder;
  const ToyDataset toy;
  std::size_t advanced = 0;
  exportDataset(toy, folder / "out", {}, [&] { ++advanced; });
  EXPECT_EQ(advanced, 4u);
  const OpenedDataset opened = openDataset(folder / "out/dataset.yaml");
  const Dataset& read = *opened.dataset;
  EXPECT_EQ(read.name(), "toy");
  EXPECT_EQ(read.seed(), toy.seed());
  EXPECT_EQ(read.camera(), toy.camera());
  ASSERT_EQ(read.numFrames(), 4u);
  for (const std::size_t i : {3u, 0u, 2u, 1u}) expectSameFrame(read.frame(i), toy.frame(i));
  EXPECT_TRUE(read.hasGroundTruth());
  expectSameGroundTruth(read.groundTruth(), toy.groundTruth());
  expectSameMesh(read.groundTruth().scene_mesh, toy.groundTruth().scene_mesh);
  EXPECT_EQ(read.groundTruth().scene_labels, toy.groundTruth().scene_labels);
  ASSERT_EQ(read.labelSpace().entries.size(), 3u);
  EXPECT_EQ(read.labelSpace().entries[1].name, "chair: \"tall\"");
  EXPECT_EQ(read.labelSpace().entries[1].color, (Rgb{102, 255, 0}));
  EXPECT_TRUE(read.labelSpace().entries[1].is_scored);
  EXPECT_FALSE(read.labelSpace().entries[2].is_scored);
  EXPECT_THAT(opened.resolved_config, HasSubstr("depth_quantum_m: 0.001\n"));
}

TEST(FolderDataset, ExportOfAnExportIsTheSameToTheByte) {
  TemporaryFolder folder;
  exportDataset(ToyDataset(), folder / "a");
  exportDataset(*openDataset(folder / "a").dataset, folder / "b");
  EXPECT_EQ(contents(folder / "a"), contents(folder / "b"));
}

TEST(FolderDataset, BytesDoNotDependOnTheNumberOfThreads) {
  TemporaryFolder folder;
  const int before = numThreads();
  const ToyDataset toy(24);
  setNumThreads(1);
  exportDataset(toy, folder / "one");
  setNumThreads(4);
  exportDataset(toy, folder / "four");
  setNumThreads(before);
  EXPECT_EQ(contents(folder / "one"), contents(folder / "four"));
}

TEST(FolderDataset, KeepsTenthsOfMillimetres) {
  TemporaryFolder folder;
  ToyDataset toy;
  toy.depth_quantum_m = 0.0001;
  exportDataset(toy, folder / "out");
  EXPECT_THAT(readText(folder / "out/dataset.yaml"), HasSubstr("depth_quantum_m: 0.0001\n"));
  expectSameFrame(openDataset(folder / "out").dataset->frame(2), toy.frame(2));
}

TEST(FolderDataset, KeepsDepthThatIsNoMultipleOfAnything) {
  TemporaryFolder folder;
  ToyDataset toy;
  toy.exact_depth = true;
  exportDataset(toy, folder / "out");
  EXPECT_TRUE(fs::exists(folder / "out/depth/000000.pfm"));
  EXPECT_FALSE(fs::exists(folder / "out/depth/000000.png"));
  expectSameFrame(openDataset(folder / "out").dataset->frame(1), toy.frame(1));
}

TEST(FolderDataset, ExportsTheFirstFramesOnRequest) {
  TemporaryFolder folder;
  exportDataset(ToyDataset(), folder / "out", {.num_frames = 2});
  const OpenedDataset opened = openDataset(folder / "out");
  EXPECT_EQ(opened.dataset->numFrames(), 2u);
  EXPECT_EQ(opened.dataset->groundTruth().trajectory.size(), 2u);
  EXPECT_FALSE(fs::exists(folder / "out/color/000002.png"));
}

TEST(FolderDataset, ExportRefusesAFilledFolderUnlessToldToReplaceIt) {
  TemporaryFolder folder;
  writeText(folder / "out/precious.txt", "p");
  EXPECT_THAT(messageOf<InputError>([&] { exportDataset(ToyDataset(), folder / "out"); }),
              HasSubstr("out: exists already and is not empty"));
  EXPECT_THAT(messageOf<InputError>(
                  [&] { exportDataset(ToyDataset(), folder / "out", {.replace = true}); }),
              HasSubstr("not replaced"));
  EXPECT_TRUE(fs::exists(folder / "out/precious.txt"));

  exportDataset(ToyDataset(), folder / "world");
  writeText(folder / "world/leftover.txt", "l");
  exportDataset(ToyDataset(), folder / "world", {.replace = true});
  EXPECT_FALSE(fs::exists(folder / "world/leftover.txt"));
  EXPECT_TRUE(fs::exists(folder / "world/dataset.yaml"));
}

/// Breaks off in the middle.
class FailingDataset : public ToyDataset {
 public:
  Frame frame(std::size_t index) const override {
    if (index == 2) throw InputError("frame 2 is broken");
    return ToyDataset::frame(index);
  }
};

TEST(FolderDataset, AnExportThatFailsLeavesNothing) {
  TemporaryFolder folder;
  EXPECT_EQ(messageOf<InputError>([&] { exportDataset(FailingDataset(), folder / "out"); }),
            "frame 2 is broken");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(FolderDataset, JpegColorIsAccepted) {
  TemporaryFolder folder;
  exportDataset(ToyDataset(), folder / "out", {.num_frames = 1});
  fs::remove(folder / "out/color/000000.png");
  fs::copy_file(fs::path(HYDRABENCH_TEST_DATA_DIR) / "images/orange_16x8.jpg",
                folder / "out/color/000000.jpg");
  const OpenedDataset opened =
      openDataset(folder / "out", {"camera.width_px=16", "require_depth=false"});
  EXPECT_THAT(messageOf<InputError>([&] { opened.dataset->frame(0); }),
              HasSubstr("depth/000000.png: image is 12 x 8"))
      << "the colour image passed";
}

TEST(FolderDataset, ImagesThatADatasetDoesNotHaveStayEmpty) {
  TemporaryFolder folder;
  exportDataset(ToyDataset(), folder / "out");
  for (const char* kind : {"color", "labels", "instances", "ground_truth"}) {
    fs::remove_all(folder / "out" / kind);
  }
  const OpenedDataset opened = openDataset(folder / "out");
  const Frame frame = opened.dataset->frame(0);
  EXPECT_TRUE(frame.color.empty());
  EXPECT_TRUE(frame.instances.empty());
  EXPECT_TRUE(frame.instance_labels.empty());
  EXPECT_FALSE(frame.depth.empty());
  EXPECT_FALSE(opened.dataset->hasGroundTruth());
}

TEST(FolderDataset, TheGeneratedWorldSurvivesExport) {
  TemporaryFolder folder;
  writeText(folder / "world.yaml",
            "type: simulated\nworld: quick\n"
            "camera: {width_px: 90, height_px: 60, fx_px: 52, fy_px: 52, cx_px: 45, cy_px: 30}\n");
  const OpenedDataset world = openDataset(folder / "world.yaml");
  exportDataset(*world.dataset, folder / "out", {.num_frames = 3});
  EXPECT_TRUE(fs::exists(folder / "out/depth/000000.png")) << "the sensor's quantum was not found";
  const OpenedDataset opened = openDataset(folder / "out");
  for (std::size_t i = 0; i < 3; ++i) {
    expectSameFrame(opened.dataset->frame(i), world.dataset->frame(i));
  }
  GroundTruth expected = world.dataset->groundTruth();
  expected.trajectory.resize(3);
  expectSameGroundTruth(opened.dataset->groundTruth(), expected);
  expectSameMesh(opened.dataset->groundTruth().scene_mesh, expected.scene_mesh);
  EXPECT_EQ(opened.dataset->groundTruth().scene_labels, expected.scene_labels);
  EXPECT_EQ(expected.scene_labels.size(), expected.scene_mesh.faces.size());
}

}  // namespace
}  // namespace hydrabench
