// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"
#include "eval/datasets/dataset_config.h"

namespace hydrabench {

/// Real views of a shelf bin from a robot arm, with masks: MIT-Princeton toolbox for the Amazon
/// Picking Challenge 2016 (Zeng et al., ICRA 2017). Masks are the annotated ones or those of its
/// FCN: a pixel belongs to the object of the highest probability among those above the threshold of
/// their own. Poses of the objects are not part of it: there is no ground truth.
class ApcDataset : public Dataset {
 public:
  enum class Masks { kGroundTruth, kPredicted };
  struct Config {
    std::filesystem::path folder;
    std::string name = "apc2016";
    Masks masks = Masks::kGroundTruth;
  };
  explicit ApcDataset(Config config);

  std::string name() const override { return config_.name; }
  const LabelSpace& labelSpace() const override { return label_space_; }
  const Camera& camera() const override { return camera_; }
  std::size_t numFrames() const override { return trajectory().size(); }
  Frame frame(std::size_t index) const override;
  const GroundTruth& groundTruth() const override { return ground_truth_; }
  bool hasGroundTruth() const override { return false; }

 private:
  struct Item {
    std::string name;
    InstanceId id =
        kNoInstance;       ///< in the annotated images; one item of each kind, so its label too
    double threshold = 1;  ///< of the probability
  };
  const std::vector<StampedPose>& trajectory() const { return ground_truth_.trajectory; }
  void readInfo();
  Image<InstanceId> predictedMasks(std::size_t index) const;

  Config config_;
  Camera camera_;
  LabelSpace label_space_;
  std::vector<Item> items_;
  GroundTruth ground_truth_;
};

DatasetConfig readApc(ConfigReader& reader, const std::filesystem::path& config);

}  // namespace hydrabench
