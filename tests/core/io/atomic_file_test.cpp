// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/atomic_file.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::size_t numEntries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(AtomicFile, ReadsBackTheBytesItWrote) {
  TemporaryFolder folder;
  const std::string content("a\0b\n\xff", 5);
  writeFileAtomic(folder / "deep/er/file.bin", content);
  EXPECT_EQ(readFile(folder / "deep/er/file.bin"), content);
  EXPECT_EQ(numEntries(folder / "deep/er"), 1u);
}

TEST(AtomicFile, ReplacesWhatStoodThere) {
  TemporaryFolder folder;
  writeFileAtomic(folder / "file", "a long first version");
  writeFileAtomic(folder / "file", "second");
  EXPECT_EQ(readFile(folder / "file"), "second");
  writeFileAtomic(folder / "file", "");
  EXPECT_EQ(readFile(folder / "file"), "");
}

TEST(AtomicFile, MissingFileIsOneLineNamingItAndTheReason) {
  const std::string message = messageOf<InputError>([] { readFile("/nowhere/at_all.yaml"); });
  EXPECT_EQ(message, "/nowhere/at_all.yaml: cannot read: No such file or directory");
}

TEST(AtomicFile, AFolderIsNoFile) {
  TemporaryFolder folder;
  EXPECT_THAT(messageOf<InputError>([&] { readFile(folder.path()); }),
              HasSubstr("cannot read: Is a directory"));
}

TEST(AtomicFile, UnwritablePlaceIsAnOutputError) {
  TemporaryFolder folder;
  writeFileAtomic(folder / "file", "x");
  EXPECT_THAT(messageOf<OutputError>([&] { writeFileAtomic(folder / "file/below.txt", "y"); }),
              HasSubstr("cannot write: Not a directory"));
  fs::create_directories(folder / "taken/inside");
  EXPECT_THAT(messageOf<OutputError>([&] { writeFileAtomic(folder / "taken", "y"); }),
              HasSubstr("taken: cannot write: Is a directory"));
  EXPECT_EQ(numEntries(folder.path()), 2u) << "a temporary file was left";
}

TEST(AtomicFolder, AppearsOnlyWhenCommitted) {
  TemporaryFolder folder;
  AtomicFolder result(folder / "out/");  // a trailing slash means the same folder
  writeFileAtomic(result.temporary() / "a.txt", "a");
  EXPECT_FALSE(fs::exists(folder / "out"));
  result.commit();
  EXPECT_EQ(readFile(folder / "out/a.txt"), "a");
  EXPECT_EQ(numEntries(folder.path()), 1u);
}

TEST(AtomicFolder, LeavesNothingWhenAbandoned) {
  TemporaryFolder folder;
  {
    AtomicFolder result(folder / "out");
    writeFileAtomic(result.temporary() / "a.txt", "a");
  }
  EXPECT_EQ(numEntries(folder.path()), 0u);
}

TEST(AtomicFolder, TakesTheNameOfAnEmptyFolder) {
  TemporaryFolder folder;
  fs::create_directory(folder / "out");
  AtomicFolder result(folder / "out");
  writeFileAtomic(result.temporary() / "a.txt", "a");
  result.commit();
  EXPECT_TRUE(fs::exists(folder / "out/a.txt"));
}

TEST(AtomicFolder, RefusesToTouchAFilledFolder) {
  TemporaryFolder folder;
  writeFileAtomic(folder / "out/precious.txt", "p");
  EXPECT_THAT(messageOf<InputError>([&] { AtomicFolder result(folder / "out"); }),
              HasSubstr("out: exists already and is not empty"));
  writeFileAtomic(folder / "file", "f");
  EXPECT_THAT(messageOf<InputError>([&] { AtomicFolder result(folder / "file"); }),
              HasSubstr("file: is a file, expected a folder"));
}

TEST(AtomicFolder, SwapsAFilledFolderOnRequest) {
  TemporaryFolder folder;
  writeFileAtomic(folder / "out/old.txt", "old");
  { AtomicFolder abandoned(folder / "out", "old.txt"); }
  EXPECT_EQ(readFile(folder / "out/old.txt"), "old");
  AtomicFolder result(folder / "out", "old.txt");
  writeFileAtomic(result.temporary() / "new.txt", "new");
  EXPECT_EQ(readFile(folder / "out/old.txt"), "old");
  result.commit();
  EXPECT_FALSE(fs::exists(folder / "out/old.txt"));
  EXPECT_EQ(readFile(folder / "out/new.txt"), "new");
  EXPECT_EQ(numEntries(folder.path()), 1u) << "the old folder was left under another name";
}

TEST(AtomicFolder, DoesNotReplaceWhatItDidNotWrite) {
  TemporaryFolder folder;
  writeFileAtomic(folder / "out/thesis.tex", "years of work");
  EXPECT_THAT(
      messageOf<InputError>([&] { AtomicFolder result(folder / "out", "provenance.json"); }),
      HasSubstr("not replaced"));
  EXPECT_EQ(readFile(folder / "out/thesis.tex"), "years of work");
}

}  // namespace
}  // namespace hydrabench
