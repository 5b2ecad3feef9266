// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/config/config_reader.h"
#include "core/types/frame.h"
#include "core/types/image.h"

namespace hydrabench {

/// Errors of an instance segmentation, drawn anew in every frame. Every key at 0 switches its part
/// off.
struct MaskCorruptionConfig {
  double boundary_jitter_px = 1.0;      ///< sigma of the displacement of outlines
  double boundary_correlation_px = 14;  ///< outlines bend over this distance
  double miss_probability = 0.03;       ///< an object is not segmented: no instance, unknown label
  double split_probability = 0.03;      ///< a mask falls into two along a line
  double merge_probability = 0.05;      ///< two touching masks of one class become one
  double confusion_probability = 0.02;  ///< a mask carries another class
  int min_pixels = 30;                  ///< smaller masks are missed

  static MaskCorruptionConfig off();
};
void read(ConfigReader& reader, MaskCorruptionConfig& config);

struct Segmentation {
  Image<Label> labels;
  Image<InstanceId> instances;
  std::map<InstanceId, Label> instance_labels;  ///< exactly the ids that occur in `instances`
};

/// Turns true object indices into what a segmentation gives. Ids are 1 .. n in random order,
/// whatever the config: they say nothing about the object. `labels`, `instances` and
/// `instance_labels` always agree.
/// @param objects        H x W, index into object_labels; -1 for structure, which has no instance
/// @param labels         H x W, true classes
/// @param object_labels  class of each object
/// @param seed           of this frame
Segmentation corruptMasks(const Image<std::int32_t>& objects, const Image<Label>& labels,
                          const std::vector<Label>& object_labels,
                          const MaskCorruptionConfig& config, std::uint64_t seed);

}  // namespace hydrabench
