// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"
#include "eval/datasets/dataset_config.h"

namespace hydrabench {

/// Real Kinect frames of 7-Scenes (Shotton et al., CVPR 2013): NAME.color.*, NAME.depth.png,
/// NAME.pose.txt, camera-intrinsics.txt. Colour and depth come from two cameras a few centimetres
/// apart and are not registered, so colours may belong to a neighbouring surface. Instance images,
/// where there are any, are in depth pixels and too rough to score against: there is no ground
/// truth.
class SevenScenesDataset : public Dataset {
 public:
  struct Config {
    std::filesystem::path frames;
    std::filesystem::path instances;  ///< NAME.instance.png and info.json; empty: none
    std::string name = "seven_scenes";
    bool align_to_floor = true;  ///< z up, floor at 0, by T_aligned_world of info.json
    double rate_hz = 30;         ///< of the recording; frame numbers count its images
    LabelSpace label_space;      ///< classes of info.json are looked up here by name
  };
  explicit SevenScenesDataset(Config config);

  std::string name() const override { return config_.name; }
  const LabelSpace& labelSpace() const override { return config_.label_space; }
  const Camera& camera() const override { return camera_; }
  std::size_t numFrames() const override { return numbers_.size(); }
  Frame frame(std::size_t index) const override;
  const GroundTruth& groundTruth() const override { return ground_truth_; }
  bool hasGroundTruth() const override { return false; }

 private:
  void readInfo();

  Config config_;
  Camera camera_;
  Transform T_aligned_world_ = Transform::Identity();
  std::vector<int> numbers_;  ///< of the frames, ascending
  std::map<InstanceId, Label> instance_labels_;
  GroundTruth ground_truth_;
};

DatasetConfig readSevenScenes(ConfigReader& reader, const std::filesystem::path& config);

}  // namespace hydrabench
