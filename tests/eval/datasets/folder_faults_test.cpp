// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/image_io.h"
#include "core/types/error.h"
#include "eval/datasets/depth_image.h"
#include "eval/datasets/folder_export.h"
#include "eval/datasets/open_dataset.h"
#include "tests/eval/datasets/toy_dataset.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// A good folder in which each test breaks one thing.
class FolderFaults : public ::testing::Test {
 protected:
  FolderFaults() { exportDataset(ToyDataset(), folder_ / "d"); }

  fs::path file(const std::string& name) const { return folder_ / ("d/" + name); }
  void replaceIn(const std::string& name, const std::string& original,
                 const std::string& replacement) {
    std::string text = readText(file(name));
    const std::size_t at = text.find(original);
    ASSERT_NE(at, std::string::npos) << original;
    writeText(file(name), text.replace(at, original.size(), replacement));
  }
  /// The line, without the folder, that opening or reading every frame gives.
  std::string fault() {
    std::string message = messageOf<InputError>([&] {
      const OpenedDataset opened = openDataset(folder_ / "d");
      for (std::size_t i = 0; i < opened.dataset->numFrames(); ++i) opened.dataset->frame(i);
    });
    EXPECT_THAT(message, Not(HasSubstr("\n")));
    const std::string prefix = (folder_ / "d/").string();
    for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) {
      message.erase(at, prefix.size());
    }
    return message;
  }

  TemporaryFolder folder_;
};

TEST_F(FolderFaults, MissingFile) {
  fs::remove(file("color/000002.png"));
  EXPECT_EQ(fault(), "color/000002.png: cannot read: No such file or directory");
  fs::remove(file("poses.txt"));
  EXPECT_EQ(fault(), "poses.txt: cannot read: No such file or directory");
  fs::remove(file("dataset.yaml"));
  EXPECT_EQ(fault(), "dataset.yaml: cannot read: No such file or directory");
}

TEST_F(FolderFaults, TruncatedImage) {
  const std::string bytes = readText(file("depth/000001.png"));
  writeText(file("depth/000001.png"), bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(fault(), "depth/000001.png: broken or truncated PNG: the file ends early");
}

TEST_F(FolderFaults, ImageThatDiffersFromTheCamera) {
  writeGrayPng(file("labels/000003.png"), Image<std::uint16_t>(12, 9));
  EXPECT_EQ(fault(), "labels/000003.png: image is 12 x 9, the camera 12 x 8 pixels");
}

TEST_F(FolderFaults, DepthThatIsNone) {
  const auto put = [&](float value) {
    Image<float> depth(12, 8, 1.0f);
    depth(7, 5) = value;
    writeDepthPfm(file("depth/000001.pfm"), depth);
  };
  put(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(fault(), "depth/000001.pfm: depth nan at pixel (7, 5), expected metres from 0 on");
  put(-0.5f);
  EXPECT_EQ(fault(), "depth/000001.pfm: depth -0.5 at pixel (7, 5), expected metres from 0 on");
  put(std::numeric_limits<float>::infinity());
  EXPECT_EQ(fault(), "depth/000001.pfm: depth inf at pixel (7, 5), expected metres from 0 on");
}

TEST_F(FolderFaults, DepthThatIsZeroEverywhere) {
  writeGrayPng(file("depth/000001.png"), Image<std::uint16_t>(12, 8));
  EXPECT_EQ(fault(),
            "depth/000001.png: depth is 0 (not measured) in every pixel; set require_depth: false "
            "to accept such frames");
  EXPECT_NO_THROW(openDataset(folder_ / "d", {"require_depth=false"}).dataset->frame(1));
}

TEST_F(FolderFaults, DepthInColor) {
  writeColorPng(file("depth/000000.png"), Image<Rgb>(12, 8));
  EXPECT_EQ(fault(),
            "depth/000000.png: PNG has 3 channel(s) of 8 bit, expected one grey channel of 8 or 16 "
            "bit");
}

TEST_F(FolderFaults, PoseThatIsNoRigidMotion) {
  writeText(file("poses.txt"), "# comment\n0 1 0 0 0 0 1 0 0 0 0 1.5 0\n");
  EXPECT_THAT(fault(), HasSubstr("poses.txt:2: no rigid motion: "));
  writeText(file("poses.txt"), "0 1 0 0 0 0 1 0 0 0 0 -1 0\n");
  EXPECT_THAT(fault(), HasSubstr("poses.txt:1: no rigid motion: "));
  writeText(file("poses.txt"), "0 1 0 0 nan 0 1 0 0 0 0 1 0\n");
  EXPECT_THAT(fault(), HasSubstr("poses.txt:1: no rigid motion: "));
}

TEST_F(FolderFaults, StampsThatGoBackwards) {
  writeText(file("poses.txt"), "5 1 0 0 0 0 1 0 0 0 0 1 0\n4 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(fault(), "poses.txt:2: stamp 4 ns does not come after the one before, 5 ns");
}

TEST_F(FolderFaults, InstanceWithoutALabel) {
  replaceIn("instance_labels.csv", "2,300,10\n", "");
  EXPECT_EQ(fault(), "instances/000002.png: instance 300 has no label in instance_labels.csv");
}

TEST_F(FolderFaults, InstanceLabelsThatAreMalformed) {
  replaceIn("instance_labels.csv", "2,300,10", "2,300,chair");
  EXPECT_EQ(fault(),
            "instance_labels.csv:7: expected frame,instance,label in whole numbers, found "
            "'2,300,chair'");
  replaceIn("instance_labels.csv", "2,300,chair", "9,300,10");
  EXPECT_EQ(fault(), "instance_labels.csv:7: frame 9, but there are 4 poses");
}

TEST_F(FolderFaults, EmptyGroundTruth) {
  writeText(file("ground_truth/objects.yaml"), "rooms: []\nobjects: []\n");
  EXPECT_EQ(fault(),
            "ground_truth/objects.yaml:2: objects: empty ground truth, expected at least one "
            "object (without any, leave the folder out)");
}

TEST_F(FolderFaults, LabelsOfTheSceneThatDoNotFitItsFaces) {
  const auto complaint = [&] { return messageOf<InputError>([&] { openDataset(folder_ / "d"); }); };
  replaceIn("ground_truth/objects.yaml", "first_face: 0, label: 5", "first_face: 1, label: 5");
  EXPECT_THAT(complaint(), HasSubstr("first_face: 1, expected 0 for the first and more for each"));
  replaceIn("ground_truth/objects.yaml", "first_face: 1, label: 5", "first_face: 0, label: 5");
  replaceIn("ground_truth/objects.yaml", ", label: 19", "0000, label: 19");
  EXPECT_THAT(complaint(), HasSubstr("scene_labels: first_face "));
}

TEST_F(FolderFaults, GroundTruthObjectsThatAreMalformed) {
  replaceIn("ground_truth/objects.yaml", "id: 5692549928996306947", "id: 1");
  EXPECT_EQ(fault(),
            "ground_truth/objects.yaml:13: objects.1.id: 1 is the id of an earlier object");
  replaceIn("ground_truth/objects.yaml", "id: 1\n    label: 10", "id: 2\n    lable: 10");
  EXPECT_THAT(messageOf<InputError>([&] { openDataset(folder_ / "d"); }),
              HasSubstr("objects.1.lable: unknown key, did you mean objects.1.label?"));
}

TEST_F(FolderFaults, GroundTruthMeshThatIsMissing) {
  fs::remove(file("ground_truth/meshes/0001.ply"));
  EXPECT_THAT(fault(), HasSubstr("ground_truth/meshes/0001.ply: "));
}

TEST_F(FolderFaults, ConfigFaultsComeTogether) {
  replaceIn("dataset.yaml", "depth_quantum_m: 0.001", "depth_quantum: 0.001");
  replaceIn("dataset.yaml", "width_px: 12", "width_px: wide");
  const std::string message = messageOf<InputError>([&] { openDataset(folder_ / "d"); });
  EXPECT_THAT(message, HasSubstr("dataset.yaml:5: camera.width_px: expected a whole number of 32 "
                                 "bit, found 'wide'\n"));
  EXPECT_THAT(message, HasSubstr("depth_quantum: unknown key, did you mean depth_quantum_m?"));
}

}  // namespace
}  // namespace hydrabench
