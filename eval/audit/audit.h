// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "eval/audit/published_table.h"

namespace hydrabench {

/// What whole numbers can be behind a row.
struct AuditedRow {
  PublishedRow printed;
  /// One way to make the row, with the ground truth of the audit.
  struct Counts {
    std::size_t estimates = 0;
    std::size_t matched = 0;  ///< estimates that count as right
    std::size_t found = 0;    ///< ground-truth objects that count as found
  };
  std::vector<Counts> possible;  ///< few estimates before many; empty: no counts make this row
  bool f1_follows = true;        ///< F1 is the harmonic mean of P and R
  /// Every possible count has matched != found: P and R cannot come from one set of pairs.
  bool many_to_one = false;
  /// The most that a matching in which no object has two partners can reach, over all possible
  /// counts; 0 where there are none.
  double one_to_one_precision = 0;
  double one_to_one_recall = 0;
  double one_to_one_f1 = 0;
};

struct Audit {
  /// Numbers of ground-truth objects that fit all recalls, likeliest first; the rows take the
  /// first.
  std::vector<TotalFit> truths;
  std::vector<AuditedRow> rows;
  std::size_t max_objects = 0;

  /// Rows that no counts make.
  std::size_t impossible() const;
};

/// All rows are taken to have been scored on the same ground truth, and all rows of a method to
/// score the same estimates. Counts up to `max_objects` are tried.
Audit audit(const std::vector<PublishedRow>& rows, std::size_t max_objects);

std::string auditText(const Audit& audit);
std::string auditCsv(const Audit& audit);

}  // namespace hydrabench
