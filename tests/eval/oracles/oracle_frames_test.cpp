// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/oracles/oracle_frames.h"

#include <gtest/gtest.h>

#include "tests/eval/oracles/two_boxes.h"

namespace hydrabench {
namespace {

/// Keeps the last frame.
class Listener : public MappingSystem {
 public:
  void process(const Frame& frame) override { last = frame; }
  SceneGraph finish() override { return {}; }
  const StageTimes& stageTimes() const override { return times_; }
  Frame last;

 private:
  StageTimes times_;
};

OracleFrames oracleFrames(const OracleFrames::Mends& mends) {
  return OracleFrames(std::make_unique<Listener>(),
                      std::make_shared<const TrueInstances>(twoBoxes()), mends);
}

void paint(Frame& frame, int u_begin, int u_end, InstanceId id, Label label) {
  for (int v = 20; v < 30; ++v) {
    for (int u = u_begin; u < u_end; ++u) {
      frame.instances(u, v) = id;
      frame.labels(u, v) = label;
    }
  }
  frame.instance_labels[id] = label;
}

TEST(OracleFrames, GivesEachObjectOneIdThatPersists) {
  OracleFrames oracle = oracleFrames({.masks = false, .association = true});
  for (const InstanceId given : {9, 4}) {
    Frame frame = smallFrame();
    paint(frame, 2, 18, given, kChairLabel);
    paint(frame, 42, 58, given + 1, kBinLabel);
    const Frame mended = oracle.mended(frame);
    EXPECT_EQ(mended.instances(10, 25), 1);
    EXPECT_EQ(mended.instances(50, 25), 2);
    EXPECT_EQ(mended.instance_labels,
              (std::map<InstanceId, Label>{{1, kChairLabel}, {2, kBinLabel}}));
  }
}

TEST(OracleFrames, JoinsThePiecesOfOneObjectUnderTheClassOfTheLargest) {
  OracleFrames oracle = oracleFrames({.masks = false, .association = true});
  Frame frame = smallFrame();
  paint(frame, 2, 5, 2, kBinLabel);
  paint(frame, 6, 18, 1, kChairLabel);
  const Frame mended = oracle.mended(frame);
  EXPECT_EQ(mended.instances(3, 25), mended.instances(10, 25));
  EXPECT_EQ(mended.instance_labels, (std::map<InstanceId, Label>{{1, kChairLabel}}));
}

TEST(OracleFrames, NeverReturnsTheIdOfAMaskThatShowsNoObject) {
  OracleFrames oracle = oracleFrames({.masks = false, .association = true});
  Frame frame = smallFrame();
  paint(frame, 26, 34, 1, kChairLabel);
  const InstanceId first = oracle.mended(frame).instances(30, 25);
  const InstanceId second = oracle.mended(frame).instances(30, 25);
  EXPECT_GT(first, 2);
  EXPECT_NE(first, second);
}

TEST(OracleFrames, GivesTrueMasksAndClasses) {
  OracleFrames oracle = oracleFrames({.masks = true, .association = false});
  Frame frame = smallFrame();
  paint(frame, 15, 60, 1, kBinLabel);  // one mask over both objects and what is between
  frame.labels(30, 10) = 19;           // a wall
  const Frame mended = oracle.mended(frame);
  const InstanceId chair = mended.instances(2, 45);
  const InstanceId bin = mended.instances(50, 25);
  EXPECT_NE(chair, kNoInstance);
  EXPECT_NE(chair, bin);
  EXPECT_EQ(mended.instance_labels,
            (std::map<InstanceId, Label>{{chair, kChairLabel}, {bin, kBinLabel}}));
  EXPECT_EQ(mended.instances(30, 25), kNoInstance);
  EXPECT_EQ(mended.labels(17, 25), kChairLabel);
  EXPECT_EQ(mended.labels(30, 25), kUnknownLabel);
  EXPECT_EQ(mended.labels(30, 10), 19);
}

TEST(OracleFrames, HandsTheMendedFrameOn) {
  OracleFrames oracle = oracleFrames({.masks = false, .association = true});
  Frame frame = smallFrame();
  paint(frame, 2, 18, 77, kChairLabel);
  oracle.process(frame);
  EXPECT_EQ(dynamic_cast<Listener&>(oracle.system()).last.instances(10, 25), 1);
}

}  // namespace
}  // namespace hydrabench
