// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/audit/audit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::filesystem::path paperTable() {
  return std::filesystem::path(HYDRABENCH_SOURCE_DIR) / "configs/tables/hydra_plus_plus_table1.csv";
}

PublishedRow row(const std::string& method, double precision, double recall, double f1) {
  return {"", method, {precision}, {recall}, {f1}};
}

TEST(Audit, FindsEightyEightObjectsInThePapersTable) {
  const Audit result = audit(readPublishedTable(paperTable()), 250);
  ASSERT_EQ(result.truths.size(), 2u);
  EXPECT_EQ(result.truths[0].total, 88u);
  EXPECT_EQ(result.truths[1].total, 176u);
  EXPECT_EQ(result.truths[0].off, 2u);  // .546 and .671
  EXPECT_EQ(result.impossible(), 0u);
}

TEST(Audit, FindsTheCountsOfThePapersTable) {
  const Audit result = audit(readPublishedTable(paperTable()), 250);
  constexpr AuditedRow::Counts kCounts[] = {
      {34, 7, 5},   {68, 36, 36}, {69, 25, 21}, {112, 75, 53}, {89, 70, 52},
      {34, 27, 14}, {68, 61, 62}, {69, 67, 48}, {112, 94, 60}, {89, 82, 59}};
  ASSERT_EQ(result.rows.size(), std::size(kCounts));
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    ASSERT_FALSE(result.rows[i].possible.empty());
    const AuditedRow::Counts& first = result.rows[i].possible.front();
    EXPECT_EQ(first.estimates, kCounts[i].estimates) << i;
    EXPECT_EQ(first.matched, kCounts[i].matched) << i;
    EXPECT_EQ(first.found, kCounts[i].found) << i;
    EXPECT_TRUE(result.rows[i].f1_follows) << i;
    // Hydra at 0.2 m alone can be one-to-one.
    EXPECT_EQ(result.rows[i].many_to_one, i != 1) << i;
  }
  // Not more than 52 pairs of 89 estimates and 88 objects, where the paper prints .675.
  EXPECT_NEAR(result.rows[4].one_to_one_f1, 2 * 52 / (89.0 + 88), 1e-12);
}

TEST(Audit, FindsNothingWrongWithOneToOneCounts) {
  // 6 of 7 estimates, 6 of 13 objects; 9 of 11, 9 of 13.
  const Audit result = audit({row("A", 0.857, 0.462, 0.6), row("B", 0.818, 0.692, 0.75)}, 20);
  EXPECT_EQ(result.truths.front().total, 13u);
  EXPECT_FALSE(result.rows[0].many_to_one);
  EXPECT_FALSE(result.rows[1].many_to_one);
  EXPECT_NEAR(result.rows[1].one_to_one_f1, 0.75, 1e-12);
  EXPECT_THAT(auditText(result), HasSubstr("every row can come from one-to-one pairs"));
}

TEST(Audit, FlagsARowThatNoCountsMake) {
  // With at most 10 estimates nothing gives 0.987.
  const Audit result = audit({row("A", 0.5, 0.5, 0.5), row("B", 0.987, 0.25, 0.399)}, 10);
  EXPECT_EQ(result.impossible(), 1u);
  EXPECT_THAT(auditText(result), HasSubstr("impossible: no whole numbers give these scores"));
}

TEST(Audit, FlagsAnF1OfOtherNumbers) {
  const Audit result = audit({row("A", 0.75, 0.25, 0.5)}, 10);  // the arithmetic mean
  EXPECT_FALSE(result.rows[0].f1_follows);
  EXPECT_THAT(auditText(result), HasSubstr("F1 is not of this P and R"));
}

TEST(Audit, SaysWhereNoNumberOfObjectsFits) {
  const Audit result = audit({row("A", 0.5, 0.123, 0.197), row("B", 0.5, 0.457, 0.477)}, 20);
  EXPECT_TRUE(result.truths.empty());
  EXPECT_EQ(result.impossible(), 2u);
  EXPECT_THAT(auditText(result), HasSubstr("no number up to 20 fits all recalls"));
}

TEST(Audit, TakesOneNumberOfEstimatesForAllRowsOfAMethod) {
  // Alone 0.5 is 1 of 2; with 0.6 beside it, it is 5 of 10.
  const Audit result = audit({row("A", 0.5, 0.5, 0.5), row("A", 0.6, 0.5, 0.545)}, 15);
  EXPECT_EQ(result.rows[0].possible.front().estimates, 10u);
}

TEST(AuditCsv, HasALineForEveryPossibleCount) {
  const std::string csv = auditCsv(audit(readPublishedTable(paperTable()), 250));
  EXPECT_THAT(csv, HasSubstr("0.2 m,Ours w/o RMCC,0.67,0.602,0.634,88,112,75,53,"));
  EXPECT_THAT(csv, HasSubstr("0.2 m,Ours,0.787,0.591,0.675,88,89,70,52,"));
  EXPECT_THAT(csv, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace hydrabench
