// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace hydrabench {

/// A fixed piece of work of a mapper's kind (distances along rays fused into voxels, by all
/// threads, half a millisecond or so), timed beside the methods: what other programs take from the
/// machine they take from it, too. So two runs are compared by their times in units of their
/// yardsticks.
class Yardstick {
 public:
  Yardstick();
  /// Does the work once.
  /// @return  wall clock [ms]
  double measure();

 private:
  struct Voxel {
    float distance = 0;
    float weight = 0;
  };
  std::vector<Voxel> voxels_;
};

}  // namespace hydrabench
