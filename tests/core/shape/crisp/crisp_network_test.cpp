// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/crisp_network.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/shape/crisp/torch_weights.h"
#include "core/types/error.h"
#include "tests/support/python_oracle.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

std::int64_t parameterCount(const torch::nn::Module& module) {
  std::int64_t count = 0;
  for (const torch::Tensor& tensor : module.parameters()) count += tensor.numel();
  return count;
}

/// Sizes of "tiny" in reference_crisp.py. The maps of the head differ in size, so that skips are
/// resized.
CrispNetworkImpl::Options tinyOptions() {
  CrispNetworkImpl::Options options;
  options.vit = {.dim = 24, .depth = 4, .heads = 2, .grid = 7};
  options.taps = {0, 1, 2, 3};
  options.head = {.dim = 24,
                  .tap_channels = {4, 8, 12, 16},
                  .channels = 8,
                  .head_channels = 12,
                  .last_channels = 6};
  options.code_width = 20;
  options.decoder.layers = 3;
  options.decoder.width = 16;
  options.input_side = 70;
  return options;
}

/// Largest difference to a tensor of the golden file.
double differenceTo(const SafetensorsFile& golden, const std::string& name,
                    const torch::Tensor& value) {
  const torch::Tensor expected = toTorch(golden.tensors().at(name));
  EXPECT_EQ(value.sizes(), expected.sizes()) << name;
  return (value - expected).abs().max().item<double>();
}

void expectGolden(CrispNetwork& network, const SafetensorsFile& golden) {
  const torch::NoGradGuard no_grad;
  const torch::Tensor image = toTorch(golden.tensors().at("input"));
  const std::vector<VitImpl::Tap> taps = network->features(image);
  for (std::size_t i = 0; i < taps.size(); ++i) {
    EXPECT_LT(differenceTo(golden, fmt::format("tap{}", i), taps[i].patches), 1e-4) << i;
    EXPECT_LT(differenceTo(golden, fmt::format("cls{}", i), taps[i].cls), 1e-4) << i;
  }
  const CrispNetworkImpl::Output output = network->forward(image);
  EXPECT_LT(differenceTo(golden, "nocs", output.nocs), 1e-3);
  EXPECT_LT(differenceTo(golden, "z", output.modulation), 1e-3);
  const torch::Tensor points = toTorch(golden.tensors().at("points"));
  EXPECT_LT(differenceTo(golden, "sdf", network->decoder()->forward(points, output.modulation)),
            1e-3);
}

/// Random weights of reference_crisp.py, put through scripts/export_crisp.py with golden tensors.
OracleAnswer exportRandomWeights(const std::string& sizes, const std::string& options,
                                 const std::filesystem::path& folder) {
  const std::string script = R"(
import runpy, sys
sys.dont_write_bytecode = True
reference, exporter, folder, sizes, options = sys.stdin.read().splitlines()
sys.argv = [reference, folder + "/checkpoint.pth", sizes]
runpy.run_path(reference, run_name="__main__")
sys.argv = [exporter, folder + "/checkpoint.pth", folder, "--reference", reference] + options.split()
runpy.run_path(exporter, run_name="__main__")
)";
  const std::string source = HYDRABENCH_SOURCE_DIR;
  return askPython({"torch", "numpy"}, script,
                   fmt::format("{}/tests/core/shape/crisp/reference_crisp.py\n"
                               "{}/scripts/export_crisp.py\n{}\n{}\n{}\n",
                               source, source, folder.string(), sizes, options));
}

TEST(CrispNetwork, HasThePublishedNumberOfParameters) {
  const torch::NoGradGuard no_grad;
  CrispNetwork network(CrispNetworkImpl::Options{});
  EXPECT_EQ(parameterCount(*network->backbone()), 22'056'576);
  EXPECT_EQ(parameterCount(*network->head()), 13'968'147);
  EXPECT_EQ(parameterCount(*network->codeLayers()), 2'825'216);
  EXPECT_EQ(parameterCount(*network->decoder()), 264'449);
  EXPECT_EQ(parameterCount(*network), 39'114'388);
  EXPECT_EQ(network->decoder()->modulationSize(), 2560);
}

TEST(CrispNetwork, ParametersHaveTheNamesOfTheCheckpoints) {
  CrispNetwork network(tinyOptions());
  std::set<std::string> names;
  for (const auto& item : network->named_parameters()) names.insert(item.key());
  for (const char* name : {"backbone.cls_token",
                           "backbone.mask_token",
                           "backbone.patch_embed.proj.bias",
                           "backbone.blocks.3.attn.qkv.weight",
                           "backbone.blocks.0.ls1.gamma",
                           "backbone.blocks.0.mlp.fc2.bias",
                           "backbone.norm.weight",
                           "nocs_net.reassemble_blocks.projects.3.weight",
                           "nocs_net.reassemble_blocks.resize_layers.0.weight",
                           "nocs_net.reassemble_blocks.resize_layers.3.bias",
                           "nocs_net.reassemble_blocks.readout_projects.2.0.weight",
                           "nocs_net.convs.1.weight",
                           "nocs_net.fusion_blocks.0.project.bias",
                           "nocs_net.fusion_blocks.0.res_conv_unit2.bn1.weight",
                           "nocs_net.fusion_blocks.3.res_conv_unit1.conv2.weight",
                           "nocs_net.project.weight",
                           "nocs_net.conv_nocs.head.0.weight",
                           "nocs_net.conv_nocs.head.2.bias",
                           "nocs_net.conv_nocs.head.3.weight",
                           "nocs_net.conv_nocs.head.5.bias",
                           "recons_backbone_adaptor.net.0.weight",
                           "recons_backbone_adaptor.net.7.bias",
                           "recons_backbone_adaptor.net.9.weight",
                           "recons_net.filmed_sdf.2.0.layer.bias",
                           "recons_net.final_layer.weight"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  for (const char* name : {"nocs_net.fusion_blocks.0.res_conv_unit1.conv1.weight",
                           "nocs_net.convs.0.bias", "nocs_net.reassemble_blocks.projects.0.bias",
                           "nocs_net.fusion_blocks.1.res_conv_unit1.conv1.bias"}) {
    EXPECT_FALSE(names.contains(name)) << name;
  }
}

TEST(CrispNetwork, GradientReachesTheBackboneOnlyOnRequest) {
  for (const bool train : {false, true}) {
    CrispNetworkImpl::Options options = tinyOptions();
    options.train_backbone = train;
    CrispNetwork network(options);
    const CrispNetworkImpl::Output output = network->forward(torch::randn({1, 3, 70, 70}));
    (output.nocs.sum() + output.modulation.sum()).backward();
    const auto parameters = network->named_parameters();
    EXPECT_EQ(parameters["backbone.blocks.0.attn.qkv.weight"].grad().defined(), train);
    EXPECT_TRUE(parameters["nocs_net.project.weight"].grad().defined());
  }
}

TEST(CrispNetwork, ResizesWhateverItIsGiven) {
  const torch::NoGradGuard no_grad;
  CrispNetwork network(tinyOptions());
  const torch::Tensor image = torch::randn({1, 3, 50, 90});
  const torch::Tensor resized = torch::upsample_bilinear2d(image, {70, 70}, false);
  const CrispNetworkImpl::Output output = network->forward(image);
  EXPECT_EQ(output.nocs.sizes(), (std::vector<std::int64_t>{1, 3, 70, 70}));
  EXPECT_TRUE(torch::equal(output.nocs, network->forward(resized).nocs));
}

TEST(CrispNetwork, AgreesWithTheSameMathsInPython) {
  const TemporaryFolder folder;
  const OracleAnswer answer =
      exportRandomWeights("tiny", "--side 70 --heads 2 --taps 0 1 2 3", folder.path());
  if (!answer.output) GTEST_SKIP() << answer.reason;
  at::set_num_threads(1);
  CrispNetwork network(tinyOptions());
  loadWeights(*network, folder / "weights.safetensors");
  expectGolden(network, SafetensorsFile::read(folder / "golden.safetensors"));
  const CrispManifest manifest = readCrispManifest(folder / "manifest.yaml");
  EXPECT_EQ(manifest.sdf_layers, 3);
  EXPECT_EQ(manifest.sdf_width, 16);
  EXPECT_EQ(manifest.weights, folder / "weights.safetensors");
  // The published network does not take them.
  EXPECT_THAT(messageOf<InputError>([&] { loadCrispNetwork(manifest); }),
              HasSubstr("the network expects"));
}

TEST(Vit, BlockOfRealSizeAgreesWithTheSameMathsInPython) {
  const TemporaryFolder folder;
  const OracleAnswer answer = exportRandomWeights("backbone", "--taps 0", folder.path());
  if (!answer.output) GTEST_SKIP() << answer.reason;
  const torch::NoGradGuard no_grad;
  at::set_num_threads(1);
  Vit vit(VitImpl::Options{.depth = 1});  // a file in the layout of DINOv2's own
  loadWeights(*vit, folder / "weights.safetensors");
  const SafetensorsFile golden = SafetensorsFile::read(folder / "golden.safetensors");
  const std::vector<VitImpl::Tap> taps = vit->forward(toTorch(golden.tensors().at("input")), {0});
  EXPECT_EQ(taps[0].patches.sizes(), (std::vector<std::int64_t>{1, 384, 30, 30}));
  EXPECT_LT(differenceTo(golden, "tap0", taps[0].patches), 5e-5);
  EXPECT_LT(differenceTo(golden, "cls0", taps[0].cls), 5e-5);
}

/// HYDRABENCH_CRISP names a folder that scripts/export_crisp.py wrote with --reference: real
/// weights are too large to ship.
TEST(CrispNetwork, ReproducesTheGoldenTensorsOfGivenWeights) {
  const char* folder = std::getenv("HYDRABENCH_CRISP");
  if (!folder) GTEST_SKIP() << "HYDRABENCH_CRISP names no folder of exported weights";
  at::set_num_threads(1);
  const std::filesystem::path path = folder;
  CrispNetwork network = loadCrispNetwork(readCrispManifest(path / "manifest.yaml"));
  expectGolden(network, SafetensorsFile::read(path / "golden.safetensors"));
}

}  // namespace
}  // namespace hydrabench
