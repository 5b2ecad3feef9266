// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/torch_latent_flow_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/shape/crisp/torch_runtime.h"
#include "core/shape/crisp/torch_weights.h"
#include "core/types/error.h"
#include "tests/core/shape/crisp/ball_view.h"
#include "tests/core/shape/latent_flow/toy_network.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

PointInput ballInput() {
  return makePointInput(gatherObjectPoints(viewOfABall(), {}, 1), 2).value();
}
ViewGrid ballGrid() {
  const ObjectPoints points = gatherObjectPoints(viewOfABall(), {}, 1);
  LocalFrame frame = makePointInput(points, 2)->frame;
  frame.scale = 0.4;
  return makeViewGrid(points, frame);
}

std::vector<float> valuesOf(const SdfField& field) {
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 50; ++i)
    points.push_back(0.02f * static_cast<float>(i) * Eigen::Vector3f(1, -1, 0.5f));
  std::vector<float> values(points.size());
  field(points, values);
  return values;
}

TEST(LatentFlowModel, DrawsTheSameTwiceAndAnotherWithAnotherSeed) {
  const auto model = makeLatentFlowModel(toyNetwork(1), "cpu");
  const LocalFrame a = model->drawPose(ballInput(), 4, 5, 7);
  const LocalFrame b = model->drawPose(ballInput(), 4, 5, 7);
  EXPECT_EQ(a.center, b.center);
  EXPECT_EQ(a.bearing, b.bearing);
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_NE(a.center, model->drawPose(ballInput(), 4, 5, 8).center);
  const auto shape = [&](std::uint64_t seed) {
    return valuesOf(model->drawShape(ballGrid(), 2, 5, seed));
  };
  EXPECT_EQ(shape(7), shape(7));
  EXPECT_NE(shape(7), shape(8));
}

TEST(LatentFlowModel, WithGuidanceOneAsksForTheViewAlone) {
  // Guidance is linear in its weight: at one step, 1 lies half-way between 0 and 2 before decoding.
  // After it the field differs, but 1 computed alone equals 1 + 1e-9, which asks for both.
  const auto model = makeLatentFlowModel(toyNetwork(2), "cpu");
  const std::vector<float> alone = valuesOf(model->drawShape(ballGrid(), 1, 3, 5));
  const std::vector<float> both = valuesOf(model->drawShape(ballGrid(), 1 + 1e-9, 3, 5));
  const std::vector<float> without = valuesOf(model->drawShape(ballGrid(), 0, 3, 5));
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_NEAR(alone[i], both[i], 1e-5);
  EXPECT_NE(alone, without);
}

TEST(LatentFlowModel, TakesOneOfSeveralPosesNotTheirMean) {
  const torch::Tensor rows =
      torch::tensor({{0.0f, 1.0f}, {0.1f, 1.0f}, {0.05f, 1.0f}, {9.0f, 9.0f}});
  EXPECT_EQ(medoid(rows), 2);
}

class LatentFlowFiles : public ::testing::Test {
 protected:
  LatentFlowFiles() {
    LatentFlowManifest manifest;
    manifest.network = toySizes();
    writeText(folder_ / "manifest.yaml", toYaml(manifest));
    saveWeights(*toyNetwork(3), folder_ / "weights.safetensors");
  }
  std::string fault() {
    return messageOf<InputError>([&] { loadLatentFlowModel(folder_.path(), "cpu"); });
  }
  TemporaryFolder folder_;
};

TEST_F(LatentFlowFiles, HoldAllThatAModelIs) {
  const auto loaded = loadLatentFlowModel(folder_.path(), "cpu");
  const auto made = makeLatentFlowModel(toyNetwork(3), "cpu");
  EXPECT_EQ(valuesOf(loaded->drawShape(ballGrid(), 2, 3, 5)),
            valuesOf(made->drawShape(ballGrid(), 2, 3, 5)));
  EXPECT_EQ(loaded->drawPose(ballInput(), 2, 3, 5).center,
            made->drawPose(ballInput(), 2, 3, 5).center);
}

TEST_F(LatentFlowFiles, OfOtherSizesAreOneLine) {
  LatentFlowManifest manifest;
  manifest.network = toySizes();
  manifest.network.flow_dim = 32;
  writeText(folder_ / "manifest.yaml", toYaml(manifest));
  EXPECT_THAT(fault(),
              AllOf(HasSubstr("weights.safetensors"), HasSubstr("shape."), HasSubstr("32")));
  EXPECT_EQ(fault().find('\n'), std::string::npos);
}

TEST_F(LatentFlowFiles, ThatAreCutShortOrMissingAreOneLine) {
  const std::string weights = readText(folder_ / "weights.safetensors");
  writeText(folder_ / "weights.safetensors", weights.substr(0, weights.size() / 2));
  EXPECT_THAT(fault(), HasSubstr("weights.safetensors"));
  EXPECT_EQ(fault().find('\n'), std::string::npos);
  std::filesystem::remove(folder_ / "weights.safetensors");
  EXPECT_THAT(fault(), HasSubstr("weights.safetensors"));
  EXPECT_THAT(messageOf<InputError>([&] { loadLatentFlowModel(folder_.path(), "tpu"); }),
              HasSubstr("expected cpu or cuda"));
}

}  // namespace
}  // namespace hydrabench
