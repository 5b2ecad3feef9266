// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/claims/claim.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class ReadClaims : public ::testing::Test {
 protected:
  std::vector<Claim> read(const std::string& yaml) {
    writeText(folder_ / "claims.yaml", yaml);
    return readClaims(folder_ / "claims.yaml");
  }
  std::string fault(const std::string& yaml) {
    try {
      read(yaml);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no fault";
  }
  TemporaryFolder folder_;
};

TEST_F(ReadClaims, EveryKeyComesThrough) {
  const auto claims = read(
      "claims:\n"
      "  - name: one\n"
      "    says: ours is better\n"
      "    source: Table I\n"
      "    dataset: office\n"
      "    needs:\n"
      "      - {metric: recall, method: ours, no_worse_than: [a, b], margin: 0.02, tau_m: 0.5, "
      "matching: one_to_one}\n"
      "      - {type: real_time, method: ours, at_hz: 30, keeps: false}\n");
  ASSERT_THAT(claims, SizeIs(1));
  EXPECT_EQ(claims[0].dataset, "office");
  ASSERT_THAT(claims[0].needs, SizeIs(2));
  const Predicate& score = claims[0].needs[0];
  EXPECT_EQ(score.type, Predicate::Type::kScore);
  EXPECT_THAT(score.than, ElementsAre("a", "b"));
  EXPECT_FALSE(score.strictly);
  EXPECT_EQ(score.margin, 0.02);
  EXPECT_EQ(score.tau_m, 0.5);
  EXPECT_EQ(score.matching, Matching::kOneToOne);
  EXPECT_EQ(claims[0].needs[1].type, Predicate::Type::kRealTime);
  EXPECT_EQ(claims[0].needs[1].at_hz, 30);
  EXPECT_FALSE(claims[0].needs[1].keeps);
}

TEST_F(ReadClaims, PairScoresAreThoseOfOneToOneMatching) {
  const auto claims = read(
      "claims:\n  - {name: one, says: x, needs: [{metric: b_iou, method: m, better_than: [n]}]}\n");
  EXPECT_EQ(claims[0].needs[0].matching, Matching::kOneToOne);
}

TEST_F(ReadClaims, FaultsNameFileLineAndKey) {
  EXPECT_THAT(fault("claims:\n  - name: one\n    says: x\n    needs:\n"
                    "      - {metric: f2, method: m, better_than: [n]}\n"),
              HasSubstr("claims.yaml:5: claims.0.needs.0.metric: 'f2' is unknown"));
  EXPECT_THAT(fault("claims:\n  - {name: one, says: x, needs: [{metric: f1, method: m}]}\n"),
              HasSubstr("expected either better_than or no_worse_than"));
  EXPECT_THAT(
      fault("claims:\n  - {name: one, says: x, needs: [{metric: f1, method: m, beter_than: [n]}]}"),
      HasSubstr("beter_than: unknown key, did you mean claims.0.needs.0.better_than?"));
  EXPECT_THAT(fault("claims:\n  - {name: one, says: x, needs: [{type: guess, method: m}]}\n"),
              HasSubstr("'guess' is unknown, expected one of: score, kappa, trend, real_time"));
  EXPECT_THAT(fault("claims:\n  - {name: one, says: x, needs: []}\n"), HasSubstr("at least one"));
}

TEST_F(ReadClaims, ANameOccursOnce) {
  const std::string claim = "  - {name: one, says: x, needs: [{type: real_time, method: m}]}\n";
  EXPECT_THAT(fault("claims:\n" + claim + claim), HasSubstr("'one' occurs twice"));
}

}  // namespace
}  // namespace hydrabench
