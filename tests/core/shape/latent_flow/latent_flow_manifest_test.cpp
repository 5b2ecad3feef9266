// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/latent_flow_manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class LatentFlowManifestFile : public ::testing::Test {
 protected:
  std::string faultOf(const std::string& yaml) {
    writeText(folder_ / "manifest.yaml", yaml);
    return messageOf<InputError>([&] { readLatentFlowManifest(folder_ / "manifest.yaml"); });
  }
  TemporaryFolder folder_;
};

TEST_F(LatentFlowManifestFile, ReadsWhatItWrites) {
  LatentFlowManifest manifest;
  manifest.network.flow_dim = 64;
  manifest.network.flow_heads = 4;
  manifest.network.latent = 7;
  manifest.source = "somewhere";
  writeText(folder_ / "manifest.yaml", toYaml(manifest));
  const LatentFlowManifest read = readLatentFlowManifest(folder_ / "manifest.yaml");
  EXPECT_EQ(read.network.flow_dim, 64);
  EXPECT_EQ(read.network.flow_heads, 4);
  EXPECT_EQ(read.network.latent, 7);
  EXPECT_EQ(read.source, "somewhere");
  EXPECT_EQ(read.weights, folder_ / "weights.safetensors");
}

TEST_F(LatentFlowManifestFile, NamesFileKeyAndValueOfAFault) {
  EXPECT_THAT(faultOf("network: {flow_dim: 2}\nweights: a\n"),
              AllOf(HasSubstr("manifest.yaml"), HasSubstr("flow_dim"), HasSubstr("2")));
  EXPECT_THAT(faultOf("network: {flow_dim: 64, flow_heads: 5}\nweights: a\n"),
              AllOf(HasSubstr("flow_heads"), HasSubstr("5 heads do not divide a width of 64")));
  EXPECT_THAT(faultOf("network: {flow_dims: 64}\nweights: a\n"), HasSubstr("flow_dim"));
  EXPECT_THAT(faultOf("weights: a\n"), HasSubstr("network"));
}

}  // namespace
}  // namespace hydrabench
