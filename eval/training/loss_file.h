// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace hydrabench {

/// Steps between two lines of loss.csv.
constexpr int kLossEvery = 50;

/// Columns of loss.csv: phase, step, then numbers that a phase may leave empty. One that starts
/// with val_ is of held-out worlds and of the averaged weights.
const std::vector<std::string>& lossColumns();

/// Appends one phase's lines to a loss.csv.
class LossFile {
 public:
  /// Goes on after `step`: takes away what stands there from a run that got farther than its last
  /// checkpoint.
  LossFile(const std::filesystem::path& path, std::string phase, int step);

  /// Numbers of one step, by column.
  void line(int step, const std::map<std::string, double>& numbers);

 private:
  std::ofstream file_;
  std::string phase_;
};

}  // namespace hydrabench
