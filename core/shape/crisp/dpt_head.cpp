// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/dpt_head.h"

#include <cassert>
#include <memory>

namespace hydrabench {
namespace {

namespace nn = torch::nn;

constexpr std::size_t kTaps = 4;

nn::Conv2dOptions conv3x3(int in, int out) { return nn::Conv2dOptions(in, out, 3).padding(1); }

torch::Tensor enlarge(const torch::Tensor& x, std::int64_t height, std::int64_t width,
                      bool align_corners) {
  return torch::upsample_bilinear2d(x, {height, width}, align_corners);
}

}  // namespace

DptReassembleImpl::DptReassembleImpl(const DptOptions& options) {
  projects_ = register_module("projects", nn::ModuleList());
  resize_layers_ = register_module("resize_layers", nn::ModuleList());
  readout_projects_ = register_module("readout_projects", nn::ModuleList());
  for (const int channels : options.tap_channels) {
    projects_->push_back(nn::Conv2d(nn::Conv2dOptions(options.dim, channels, 1).bias(false)));
    readout_projects_->push_back(
        nn::Sequential(nn::Linear(2 * options.dim, options.dim), nn::GELU()));
  }
  const auto& c = options.tap_channels;
  resize_layers_->push_back(
      nn::ConvTranspose2d(nn::ConvTranspose2dOptions(c[0], c[0], 4).stride(4)));
  resize_layers_->push_back(
      nn::ConvTranspose2d(nn::ConvTranspose2dOptions(c[1], c[1], 2).stride(2)));
  resize_layers_->push_back(nn::Identity());
  resize_layers_->push_back(nn::Conv2d(conv3x3(c[3], c[3]).stride(2)));
}

std::vector<torch::Tensor> DptReassembleImpl::forward(const std::vector<VitImpl::Tap>& taps) {
  std::vector<torch::Tensor> maps;
  for (std::size_t i = 0; i < kTaps; ++i) {
    const torch::Tensor& patches = taps[i].patches;
    const torch::Tensor tokens = patches.flatten(2).transpose(1, 2);  // [B, N, dim]
    const torch::Tensor cls = taps[i].cls.unsqueeze(1).expand_as(tokens);
    const torch::Tensor read =
        readout_projects_->at<nn::SequentialImpl>(i).forward(torch::cat({tokens, cls}, -1));
    maps.push_back(
        projects_->at<nn::Conv2dImpl>(i).forward(read.transpose(1, 2).reshape(patches.sizes())));
  }
  maps[0] = resize_layers_->at<nn::ConvTranspose2dImpl>(0).forward(maps[0]);
  maps[1] = resize_layers_->at<nn::ConvTranspose2dImpl>(1).forward(maps[1]);
  maps[3] = resize_layers_->at<nn::Conv2dImpl>(3).forward(maps[3]);
  return maps;
}

DptResidualUnitImpl::DptResidualUnitImpl(const DptOptions& options) {
  const auto conv = conv3x3(options.channels, options.channels).bias(false);
  const nn::GroupNormOptions norm(options.norm_groups, options.channels);
  conv1_ = register_module("conv1", nn::Conv2d(conv));
  conv2_ = register_module("conv2", nn::Conv2d(conv));
  norm1_ = register_module("bn1", nn::GroupNorm(norm));
  norm2_ = register_module("bn2", nn::GroupNorm(norm));
}

torch::Tensor DptResidualUnitImpl::forward(const torch::Tensor& input) {
  const torch::Tensor x = norm1_(conv1_(torch::relu(input)));
  return norm2_(conv2_(torch::relu(x))) + input;
}

DptFusionImpl::DptFusionImpl(const DptOptions& options, bool has_skip) {
  project_ = register_module("project",
                             nn::Conv2d(nn::Conv2dOptions(options.channels, options.channels, 1)));
  if (has_skip) unit1_ = register_module("res_conv_unit1", DptResidualUnit(options));
  unit2_ = register_module("res_conv_unit2", DptResidualUnit(options));
}

torch::Tensor DptFusionImpl::forward(torch::Tensor x, const torch::Tensor& skip) {
  assert(skip.defined() == !unit1_.is_empty());
  if (skip.defined()) {
    const bool same = skip.size(2) == x.size(2) && skip.size(3) == x.size(3);
    x = x + unit1_(same ? skip : enlarge(skip, x.size(2), x.size(3), /*align_corners=*/false));
  }
  x = unit2_(x);
  return project_(enlarge(x, 2 * x.size(2), 2 * x.size(3), /*align_corners=*/true));
}

DptHeadImpl::DptHeadImpl(const DptOptions& options) {
  reassemble_ = register_module("reassemble_blocks", DptReassemble(options));
  convs_ = register_module("convs", nn::ModuleList());
  fusion_blocks_ = register_module("fusion_blocks", nn::ModuleList());
  for (std::size_t i = 0; i < kTaps; ++i) {
    convs_->push_back(nn::Conv2d(conv3x3(options.tap_channels[i], options.channels).bias(false)));
    fusion_blocks_->push_back(DptFusion(options, /*has_skip=*/i > 0));
  }
  project_ = register_module("project", nn::Conv2d(conv3x3(options.channels, options.channels)));
  // Places 1 (enlargement) and 4 (ReLU) hold no parameters; the numbers are names.
  const auto head = register_module("conv_nocs", std::make_shared<nn::Module>())
                        ->register_module("head", std::make_shared<nn::Module>());
  const int middle = options.head_channels;
  conv1_ = head->register_module("0", nn::Conv2d(conv3x3(options.channels, middle)));
  norm_ =
      head->register_module("2", nn::GroupNorm(nn::GroupNormOptions(options.norm_groups, middle)));
  conv2_ = head->register_module("3", nn::Conv2d(conv3x3(middle, options.last_channels)));
  conv3_ = head->register_module("5", nn::Conv2d(nn::Conv2dOptions(options.last_channels, 3, 1)));
}

torch::Tensor DptHeadImpl::forward(const std::vector<VitImpl::Tap>& taps, int side) {
  assert(taps.size() == kTaps);
  const std::vector<torch::Tensor> maps = reassemble_(taps);
  torch::Tensor x;
  for (std::size_t i = 0; i < kTaps; ++i) {
    const std::size_t level = kTaps - 1 - i;  // the deepest first
    const torch::Tensor map = convs_->at<nn::Conv2dImpl>(level).forward(maps[level]);
    DptFusionImpl& fusion = fusion_blocks_->at<DptFusionImpl>(i);
    x = i == 0 ? fusion.forward(map, {}) : fusion.forward(x, map);
  }
  x = project_(x);
  x = enlarge(conv1_(x), side, side, /*align_corners=*/true);
  return conv3_(torch::relu(conv2_(norm_(x))));
}

}  // namespace hydrabench
