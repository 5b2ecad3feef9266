// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/process/child_process.h"

#include <csignal>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

std::string everything(ChildProcess& process) {
  std::string text;
  while (const auto bytes = process.receive()) text += *bytes;
  return text;
}

TEST(ChildProcess, ReadsWhatItIsSentAndSaysWhatItHasToSay) {
  ChildProcess cat({.command = {"cat"}});
  EXPECT_TRUE(cat.send("hello\n"));
  cat.closeInput();
  EXPECT_EQ(everything(cat), "hello\n");
  EXPECT_TRUE(cat.wait().ok());
}

TEST(ChildProcess, MoreThanAPipeHoldsGoesThrough) {
  ChildProcess count({.command = {"wc", "-c"}});
  EXPECT_TRUE(count.send(std::string(3'000'000, 'x')));
  count.closeInput();
  EXPECT_THAT(everything(count), HasSubstr("3000000"));
}

TEST(ChildProcess, TellsHowItEnded) {
  ChildProcess three({.command = {"sh", "-c", "exit 3"}});
  EXPECT_EQ(three.wait().text(), "exit code 3");
  ChildProcess killed({.command = {"sh", "-c", "kill -9 $$"}});
  const ChildProcess::Exit exit = killed.wait();
  EXPECT_EQ(exit.signal, SIGKILL);
  EXPECT_EQ(exit.text(), "killed by signal 9 (Killed)");
}

TEST(ChildProcess, WritingToOneThatIsGoneFailsAndDoesNotKillUs) {
  ChildProcess gone({.command = {"true"}});
  everything(gone);
  gone.wait();
  bool sent = true;
  for (int i = 0; i < 100 && sent; ++i) sent = gone.send(std::string(65536, 'x'));
  EXPECT_FALSE(sent);
}

TEST(ChildProcess, AProgramThatIsNotThereIsNamed) {
  EXPECT_THAT(messageOf<OutputError>([] { ChildProcess({.command = {"no_such_program"}}); }),
              HasSubstr("no_such_program: cannot be started: No such file"));
}

TEST(ChildProcess, DoesNotOutliveItsOwner) {
  pid_t pid = 0;
  {
    ChildProcess sleeper({.command = {"sh", "-c", "echo $$; exec sleep 1000"}});
    pid = std::stoi(*sleeper.receive());
    EXPECT_EQ(::kill(pid, 0), 0);
  }
  EXPECT_NE(::kill(pid, 0), 0);
}

TEST(ChildProcess, CannotHaveMoreMemoryThanItIsGiven) {
  const char* greedy = "x = bytearray(400 << 20); print('had it')";
  ChildProcess free({.command = {"python3", "-c", greedy}});
  const std::string answer = everything(free);
  if (!free.wait().ok()) GTEST_SKIP() << "no python3 here";
  EXPECT_EQ(answer, "had it\n");
  const TemporaryFolder folder;
  ChildProcess limited({.command = {"python3", "-c", greedy},
                        .memory_limit_mib = 200,
                        .error_file = folder / "errors.txt"});
  EXPECT_EQ(everything(limited), "");
  EXPECT_FALSE(limited.wait().ok());
  EXPECT_THAT(readText(folder / "errors.txt"), HasSubstr("MemoryError"));
}

}  // namespace
}  // namespace hydrabench
