// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eval/evaluation/evaluator.h"
#include "metrics/bootstrap.h"

namespace hydrabench {

/// What a method made of all objects of one variant (shape family, model) of a class: how much the
/// shape of a thing matters, the paper's section on intra-class variation. One-to-one matching, so
/// that every object counts once; shape scores are means over the objects found.
struct VariantRow {
  struct Value {
    std::optional<double> mean;
    std::optional<Interval> ci95;
  };
  std::string dataset;
  std::string seed;
  std::string method;
  std::string class_name;
  std::string variant;
  double threshold_m = 0;
  std::size_t truths = 0;
  std::size_t found = 0;
  Value chamfer_l1;  ///< [m]
  Value b_iou;
  Value v_iou;  ///< v_iou_solid

  double foundShare() const { return static_cast<double>(found) / static_cast<double>(truths); }
};

/// By class, variant, threshold and method, in order of first appearance of class and variant; of
/// the pooled worlds where a dataset has several. Objects of unknown variant are left out.
std::vector<VariantRow> variantRows(const std::vector<MethodEvaluation>& evaluations,
                                    const EvaluationConfig& config);

std::string renderVariantsCsv(const std::vector<VariantRow>& rows);  ///< variants.csv
std::vector<VariantRow> readVariantsCsv(const std::filesystem::path& path);
/// One table per dataset and threshold, columns aligned.
std::string renderVariantsMarkdown(const std::vector<VariantRow>& rows);

}  // namespace hydrabench
