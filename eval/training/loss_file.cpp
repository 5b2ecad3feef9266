// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/loss_file.h"

#include "core/io/atomic_file.h"
#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

void writeWithoutLinesAfter(const std::filesystem::path& path, const std::string& phase, int step) {
  std::string text = csvLine(lossColumns());
  if (std::filesystem::exists(path)) {
    const CsvTable table = readCsv(path, lossColumns());
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      if (table.rows[row][0] == phase && table.number(row, 1) > step) break;
      text += csvLine(table.rows[row]);
    }
  }
  writeFileAtomic(path, text);
}

}  // namespace

const std::vector<std::string>& lossColumns() {
  static const std::vector<std::string> columns = {
      "phase", "step",           "samples",    "learning_rate", "nocs_error", "sdf_l1",  "direct",
      "code",  "val_nocs_error", "val_sdf_l1", "val_direct",    "flow",       "val_flow"};
  return columns;
}

LossFile::LossFile(const std::filesystem::path& path, std::string phase, int step)
    : phase_(std::move(phase)) {
  writeWithoutLinesAfter(path, phase_, step);
  file_.open(path, std::ios::app);
}

void LossFile::line(int step, const std::map<std::string, double>& numbers) {
  std::vector<std::string> cells = {phase_, std::to_string(step)};
  for (std::size_t i = cells.size(); i < lossColumns().size(); ++i) {
    const auto found = numbers.find(lossColumns()[i]);
    cells.push_back(found == numbers.end() ? "" : csvNumber(found->second));
  }
  file_ << csvLine(cells) << std::flush;
}

}  // namespace hydrabench
