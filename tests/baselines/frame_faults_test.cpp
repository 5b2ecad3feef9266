// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "baselines/hydra/hydra.h"
#include "baselines/khronos/khronos.h"
#include "baselines/template_cad/template_cad.h"
#include "core/types/error.h"
#include "tests/support/miniature_world.h"

namespace hydrabench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::unique_ptr<MappingSystem> khronos(const std::string& source) {
  Khronos::Config config;
  config.candidates.source = source;
  return std::make_unique<Khronos>(config, miniatureLabelSpace());
}
std::unique_ptr<MappingSystem> templateCad(const std::string& source) {
  TemplateCad::Config config;
  config.candidates.source = source;
  return std::make_unique<TemplateCad>(config, miniatureLabelSpace());
}
std::unique_ptr<MappingSystem> hydra() {
  return std::make_unique<Hydra>(Hydra::Config(), miniatureLabelSpace());
}

std::vector<std::unique_ptr<MappingSystem>> methods() {
  std::vector<std::unique_ptr<MappingSystem>> all;
  all.push_back(hydra());
  all.push_back(khronos("connected_semantics"));
  all.push_back(khronos("instances"));
  all.push_back(templateCad("connected_semantics"));
  all.push_back(templateCad("instances"));
  return all;
}

Frame goodFrame() {
  MiniatureWorld world;
  world.addRoom(4, 4, 2.5);
  world.add(tinyChair(), miniature_label::kChair, 1);
  return world.frame(lookAt({1.5, 0, 1.2}, {0, 0, 0.4}), kMiniatureStartNs);
}

/// What a method says of a frame; empty: nothing.
std::string faultOf(MappingSystem& method, const Frame& frame) {
  try {
    method.process(frame);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expectRefused(const std::function<void(Frame&)>& spoil, const std::string& words) {
  Frame frame = goodFrame();
  spoil(frame);
  for (const auto& method : methods()) {
    EXPECT_THAT(faultOf(*method, frame),
                AllOf(HasSubstr(std::to_string(frame.stamp_ns)), HasSubstr(words)));
  }
}

TEST(FrameFaults, AGoodFrameIsTaken) {
  for (const auto& method : methods()) EXPECT_EQ(faultOf(*method, goodFrame()), "");
}

TEST(FrameFaults, EveryMethodNeedsDepth) {
  expectRefused([](Frame& frame) { frame.depth = {}; }, "no depth image");
}

TEST(FrameFaults, EveryImageHasTheSizeOfTheCamera) {
  expectRefused([](Frame& frame) { frame.depth = Image<float>(9, 9, 1.0f); }, "depth image");
  expectRefused([](Frame& frame) { frame.color = Image<Rgb>(9, 9); }, "color image");
  expectRefused([](Frame& frame) { frame.labels = Image<Label>(9, 9, 5); }, "label image");
  expectRefused([](Frame& frame) { frame.instances = Image<InstanceId>(9, 9, 1); },
                "instance image");
}

TEST(FrameFaults, PosesAreFiniteAndNotTooFarOut) {
  expectRefused([](Frame& frame) { frame.T_world_camera.translation().x() = std::nan(""); },
                "not finite");
  expectRefused([](Frame& frame) { frame.T_world_camera.translation().x() = 2e8; },
                "from the origin");
}

TEST(FrameFaults, AMissingImageThatAMethodNeedsDoesNotMeanThatThereIsNoObject) {
  Frame unlabelled = goodFrame();
  unlabelled.labels = {};
  EXPECT_THAT(faultOf(*hydra(), unlabelled), HasSubstr("has no label image; expected one"));
  EXPECT_THAT(faultOf(*khronos("connected_semantics"), unlabelled), HasSubstr("no label image"));
  EXPECT_THAT(faultOf(*templateCad("connected_semantics"), unlabelled),
              HasSubstr("no label image"));
  EXPECT_EQ(faultOf(*khronos("instances"), unlabelled), "");
  Frame without_instances = goodFrame();
  without_instances.instances = {};
  EXPECT_THAT(faultOf(*khronos("instances"), without_instances), HasSubstr("no instance image"));
  EXPECT_THAT(faultOf(*templateCad("instances"), without_instances),
              HasSubstr("no instance image"));
  EXPECT_EQ(faultOf(*hydra(), without_instances), "");
}

}  // namespace
}  // namespace hydrabench
