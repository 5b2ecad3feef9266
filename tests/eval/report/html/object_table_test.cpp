// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/object_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

constexpr const char* kHeader =
    "dataset,seed,method,threshold_kind,threshold,matching,outcome,class,center_distance_m,"
    "estimate_id,estimate_center_x_m,"
    "estimate_center_y_m,estimate_center_z_m,estimate_half_diagonal_m,estimate_faces,estimate_"
    "watertight,truth_id,truth_center_x_m,"
    "truth_center_y_m,truth_center_z_m,truth_half_diagonal_m,truth_faces,truth_watertight,truth_"
    "name,truth_subtype,truth_room,"
    "truth_visible_fraction,b_iou\n";
constexpr const char* kEstimate = "5692549928996306944,1,2,3,0.5,10,no";
constexpr const char* kTruth = "7,1,2,3,0.5,10,yes,chair_001,stool,hall,0.5";

std::string line(const std::string& method, double threshold, const std::string& outcome,
                 const std::string& estimate, const std::string& truth, const std::string& score) {
  return "office,1," + method + ",tau_m," + std::to_string(threshold) + ",exists," + outcome +
         ",chair," + (estimate.empty() ? "" : "0.1") + "," +
         (estimate.empty() ? ",,,,,," : estimate) + "," + truth + "," + score + "\n";
}

TEST(ObjectTable, PutsWorldsMethodsAndSettingsTogether) {
  const TemporaryFolder folder;
  writeText(folder / "objects.csv", kHeader + line("a", 0.2, "matched", kEstimate, kTruth, "") +
                                        line("a", 0.5, "matched", kEstimate, kTruth, "0.25") +
                                        line("b", 0.2, "missed", "", kTruth, ""));
  const ObjectTable table = readObjectTable(folder / "objects.csv");
  ASSERT_EQ(table.worlds.size(), 1u);
  EXPECT_EQ(table.settings.size(), 2u);
  const ObjectWorld& world = table.worlds[0];
  ASSERT_EQ(world.truths.size(), 1u);
  EXPECT_EQ(world.truths[0].name, "chair_001");
  ASSERT_EQ(world.methods.size(), 2u);
  EXPECT_EQ(world.methods[0].estimates[0].id, "5692549928996306944");
  // One pair, with the score that only one of the settings has.
  ASSERT_EQ(world.methods[0].pairs.size(), 1u);
  EXPECT_EQ(world.methods[0].pairs[0].scores[0], 0.25);
  EXPECT_EQ(world.methods[1].outcomes[0][0].kind, "missed");
  EXPECT_TRUE(world.methods[1].outcomes[1].empty());
}

TEST(ObjectTable, NamesFileAndLineOfAShortRecord) {
  const TemporaryFolder folder;
  writeText(folder / "objects.csv", kHeader + std::string("office,1,a\n"));
  try {
    readObjectTable(folder / "objects.csv");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("objects.csv:2: 3 cells, expected 28"));
  }
}

TEST(ObjectTable, IdsAreNeverNumbersOfJavaScript) {
  ObjectTable table;
  ObjectWorld& world = table.worlds.emplace_back();
  world.methods.emplace_back().estimates.emplace_back().id = "5692549928996306944";
  EXPECT_THAT(objectsJson(table), HasSubstr(R"("id":"5692549928996306944")"));
  EXPECT_EQ(shortId("5692549928996306956"), "O12");
  EXPECT_EQ(shortId("42"), "42");
  EXPECT_EQ(shortId("text"), "text");
}

}  // namespace
}  // namespace hydrabench
