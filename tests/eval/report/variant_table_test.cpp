// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/variant_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

ScoredObject truth(const std::string& subtype) {
  ScoredObject object;
  object.class_name = "chair";
  object.subtype = subtype;
  return object;
}

ObjectRow row(std::size_t truth, std::optional<double> chamfer,
              Matching matching = Matching::kOneToOne) {
  ObjectRow row;
  row.threshold = Threshold::tau(0.5);
  row.matching = matching;
  row.truth = truth;
  row.outcome = chamfer ? ObjectRow::Outcome::kMatched : ObjectRow::Outcome::kMissed;
  if (chamfer) {
    row.scores.emplace();
    row.scores->chamfer_l1 = chamfer;
    row.scores->b_iou = 0.5;
  }
  return row;
}

/// Two stools, one found with 4 cm; an armchair found with 2 cm; an object of unknown variant.
std::vector<MethodEvaluation> evaluations() {
  MethodEvaluation evaluation;
  evaluation.dataset = "office";
  evaluation.seed = "1";
  evaluation.method = "template_cad";
  evaluation.truths = {truth("stool"), truth("armchair"), truth("stool"), truth("")};
  evaluation.objects = {row(0, 0.04), row(1, 0.02), row(2, std::nullopt), row(3, 0.1),
                        row(0, 0.9, Matching::kExists)};
  // An estimate that is nobody's names the nearest truth, which it did not find.
  ObjectRow stray = row(2, std::nullopt);
  stray.outcome = ObjectRow::Outcome::kUnmatched;
  evaluation.objects.push_back(stray);
  return {evaluation};
}

EvaluationConfig withoutIntervals() {
  EvaluationConfig config;
  config.bootstrap_resamples = 0;
  return config;
}

TEST(VariantTable, HasARowForEveryVariantOfAClass) {
  const std::vector<VariantRow> rows = variantRows(evaluations(), withoutIntervals());
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].variant, "stool");
  EXPECT_EQ(rows[0].truths, 2u);
  EXPECT_EQ(rows[0].found, 1u);
  EXPECT_DOUBLE_EQ(rows[0].foundShare(), 0.5);
  EXPECT_EQ(rows[0].chamfer_l1.mean, 0.04);
  EXPECT_EQ(rows[0].v_iou.mean, std::nullopt);
  EXPECT_EQ(rows[1].variant, "armchair");
  EXPECT_EQ(rows[1].chamfer_l1.mean, 0.02);
}

TEST(VariantTable, ReadsBackWhatItWrote) {
  std::vector<MethodEvaluation> worlds = evaluations();
  worlds[0].objects[2] = row(2, 0.06);
  const std::string text = renderVariantsCsv(variantRows(worlds, EvaluationConfig{}));
  const TemporaryFolder folder;
  writeText(folder / "variants.csv", text);
  EXPECT_EQ(renderVariantsCsv(readVariantsCsv(folder / "variants.csv")), text);
}

TEST(VariantTable, PrintsMethodsOfAVariantBelowEachOther) {
  std::vector<MethodEvaluation> worlds = evaluations();
  worlds.push_back(worlds.front());
  worlds.back().method = "hydra_plus_plus";
  const std::string text = renderVariantsMarkdown(variantRows(worlds, withoutIntervals()));
  EXPECT_THAT(text, HasSubstr("| chair | stool    | Template CAD |  0.50 |   2 |"));
  EXPECT_THAT(text, HasSubstr("|       |          | Hydra++      |  0.50 |   2 |"));
}

}  // namespace
}  // namespace hydrabench
