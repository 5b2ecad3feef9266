// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spark_dsg_json.h"
#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

Prediction onePrediction() {
  Prediction prediction;
  prediction.method = "hydra_plus_plus";
  prediction.graph.objects.resize(1);
  prediction.graph.objects[0].id = objectNodeId(0);
  prediction.graph.objects[0].mesh = sphereMesh({1, 2, 3}, 0.5, 1);
  return prediction;
}

TEST(PredictionFolder, ReadsBackWithTheNameOfItsMethod) {
  TemporaryFolder folder;
  writePrediction(folder / "out", onePrediction());
  for (const char* path : {"out", "out/scene_graph.json"}) {
    const Prediction read = readPrediction(folder / path);
    EXPECT_EQ(read.method, "hydra_plus_plus");
    EXPECT_EQ(read.graph.objects.size(), 1u);
  }
}

TEST(PredictionFolder, ReadsBackWhichVoxelsAreSolid) {
  TemporaryFolder folder;
  Prediction prediction = onePrediction();
  prediction.graph.occupied = {{0.1f, 0.3f, -0.5f}, {7, 8, 9}};
  prediction.graph.occupied_voxel_m = 0.25;
  writePrediction(folder / "out", prediction);
  EXPECT_EQ(fs::file_size(folder / "out/occupied.bin"), 4u + 2 * 12);
  const SceneGraph read = readPrediction(folder / "out").graph;
  EXPECT_EQ(read.occupied, prediction.graph.occupied);
  EXPECT_EQ(read.occupied_voxel_m, 0.25);
  writeText(folder / "out/occupied.bin", "12345");
  EXPECT_THAT(
      messageOf<InputError>([&] { readPrediction(folder / "out"); }),
      HasSubstr("occupied.bin: 5 bytes; expected 4 for the side of a voxel and 12 for each"));
}

TEST(PredictionFolder, AForeignGraphIsNamedAfterItsFolderOrFile) {
  TemporaryFolder folder;
  const fs::path sample = fs::path(HYDRABENCH_TEST_DATA_DIR) / "graphs/hydra.json";
  fs::create_directories(folder / "my_run");
  fs::copy_file(sample, folder / "my_run/scene_graph.json");
  fs::copy_file(sample, folder / "dsg_with_mesh.json");
  EXPECT_EQ(readPrediction(folder / "my_run").method, "my_run");
  EXPECT_EQ(readPrediction(folder / "my_run/scene_graph.json").method, "my_run");
  EXPECT_EQ(readPrediction(folder / "dsg_with_mesh.json").method, "dsg_with_mesh");
}

TEST(PredictionFolder, SaysWhatIsMissing) {
  TemporaryFolder folder;
  EXPECT_THAT(messageOf<InputError>([&] { readPrediction(folder.path()); }),
              HasSubstr(": no scene_graph.json in this folder"));
  EXPECT_THAT(messageOf<InputError>([&] { readPrediction(folder / "absent"); }),
              HasSubstr("absent: cannot read: No such file or directory"));
  EXPECT_THAT(messageOf<InputError>([&] { readPrediction(folder / "g.sparkdsg"); }),
              HasSubstr("g.sparkdsg: the binary format of spark_dsg, expected its JSON"));
  writePrediction(folder / "out", onePrediction());
  writeText(folder / "out/prediction.json", "{\"name\": 1}");
  EXPECT_THAT(messageOf<InputError>([&] { readPrediction(folder / "out"); }),
              HasSubstr("prediction.json: method: missing"));
}

TEST(PredictionFolder, IsNotWrittenOverAnother) {
  TemporaryFolder folder;
  writePrediction(folder / "out", onePrediction());
  EXPECT_THAT(messageOf<InputError>([&] { writePrediction(folder / "out", onePrediction()); }),
              HasSubstr("out: exists already and is not empty"));
}

}  // namespace
}  // namespace hydrabench
