// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/mapping_system.h"
#include "eval/oracles/true_instances.h"

namespace hydrabench {

/// Hands frames on to a method after ground truth has mended what the segmentation got wrong.
/// Colour, depth and pose stay as they are. The time this takes is part of what is measured as
/// "frame".
class OracleFrames : public MappingSystem {
 public:
  struct Mends {
    /// True masks and classes, instance ids new in every frame.
    bool masks = false;
    /// Instance ids that persist: the true object that most of a mask shows, plus one. Pieces of
    /// one object become one instance; a mask that shows no object gets an id that never returns.
    /// The class of a mask is left as it is.
    bool association = false;
  };
  OracleFrames(std::unique_ptr<MappingSystem> system, std::shared_ptr<const TrueInstances> truth,
               const Mends& mends);

  void process(const Frame& frame) override { system_->process(mended(frame)); }
  SceneGraph finish() override { return system_->finish(); }
  const StageTimes& stageTimes() const override { return system_->stageTimes(); }
  std::vector<std::string> notes() const override;
  std::vector<ShapeCandidate> takeCandidates() override { return system_->takeCandidates(); }

  Frame mended(const Frame& frame);
  MappingSystem& system() { return *system_; }

 private:
  void giveTrueMasks(Frame& frame) const;
  void givePersistentIds(Frame& frame);

  std::unique_ptr<MappingSystem> system_;
  std::shared_ptr<const TrueInstances> truth_;
  Mends mends_;
  InstanceId next_stray_id_;
};

}  // namespace hydrabench
