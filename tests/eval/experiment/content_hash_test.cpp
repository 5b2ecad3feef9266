// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/content_hash.h"

#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

TEST(ContentHash, IsSha256OverLengthsAndFields) {
  // printf '3:abc' | sha256sum
  EXPECT_EQ(ContentHash().add("abc").hex(),
            "aab5f9ae99b2e38fb462025c8f72f570c9c811705d2a4277dc855d7fa293fe97");
}

TEST(ContentHash, TellsWhereAFieldEnds) {
  EXPECT_NE(ContentHash().add("ab").add("c").hex(), ContentHash().add("a").add("bc").hex());
}

TEST(ContentHash, OfAFolderDependsOnNamesAndContentNotOnItsPlace) {
  const TemporaryFolder folder;
  writeText(folder / "a/x.txt", "1");
  writeText(folder / "a/sub/y.txt", "2");
  writeText(folder / "b/sub/y.txt", "2");
  writeText(folder / "b/x.txt", "1");
  const auto hash = [&](const char* name) { return ContentHash().addContent(folder / name).hex(); };
  EXPECT_EQ(hash("a"), hash("b"));
  writeText(folder / "b/x.txt", "3");
  EXPECT_NE(hash("a"), hash("b"));
}

TEST(ContentHash, NamesWhatIsNotThere) {
  EXPECT_THROW(ContentHash().addContent("/no/such/file"), InputError);
}

TEST(ProgramHash, StaysTheSameWhileTheProgramRuns) {
  EXPECT_EQ(programHash().size(), 64u);
  EXPECT_EQ(programHash(), programHash());
}

}  // namespace
}  // namespace hydrabench
