// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/parallel/work_queue.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;

/// Closed until somebody opens it.
class Gate {
 public:
  void open() { open_.store(true); }
  void pass() const {
    while (!open_.load()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

 private:
  std::atomic<bool> open_ = false;
};

void waitUntil(const std::function<bool()>& condition) {
  while (!condition()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(WorkQueue, ResultsComeInOrderOfSubmissionWhateverFinishesFirst) {
  WorkQueue<int> queue(2, 8);
  Gate gate;
  std::atomic<bool> second_is_done = false;
  queue.submit([&] {
    gate.pass();
    return 1;
  });
  queue.submit([&] {
    second_is_done.store(true);
    return 2;
  });
  waitUntil([&] { return second_is_done.load(); });
  EXPECT_FALSE(queue.ready());
  EXPECT_EQ(queue.size(), 2u);
  gate.open();
  EXPECT_EQ(queue.take(), 1);
  EXPECT_EQ(queue.take(), 2);
  EXPECT_EQ(queue.size(), 0u);
}

TEST(WorkQueue, AnExceptionReachesWhoeverTakesTheResult) {
  WorkQueue<int> queue(1, 8);
  queue.submit([] { return 1; });
  queue.submit([]() -> int { throw std::runtime_error("job 2"); });
  queue.submit([] { return 3; });
  EXPECT_EQ(queue.take(), 1);
  EXPECT_THROW(
      {
        try {
          queue.take();
        } catch (const std::runtime_error& error) {
          EXPECT_STREQ(error.what(), "job 2");
          throw;
        }
      },
      std::runtime_error);
  EXPECT_EQ(queue.take(), 3);
}

TEST(WorkQueue, SubmitWaitsWhileTooManyJobsDo) {
  // One job runs, two wait; the fourth has to wait outside.
  WorkQueue<int> queue(1, 2);
  Gate gate;
  std::atomic<int> num_submitted = 0;
  std::thread submitter([&] {
    for (int i = 0; i < 4; ++i) {
      queue.submit([&, i] {
        gate.pass();
        return i;
      });
      ++num_submitted;
    }
  });
  waitUntil([&] { return num_submitted.load() == 3; });
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  EXPECT_EQ(num_submitted.load(), 3);
  gate.open();
  submitter.join();
  std::vector<int> results;
  while (queue.size() > 0) results.push_back(queue.take());
  EXPECT_THAT(results, ElementsAre(0, 1, 2, 3));
}

TEST(WorkQueue, TheDestructorWaitsForRunningJobsAndDropsTheOthers) {
  std::atomic<int> num_begun = 0;
  std::atomic<int> num_ended = 0;
  const auto held = std::make_shared<int>(7);
  {
    WorkQueue<int> queue(1, 8);
    for (int i = 0; i < 5; ++i) {
      queue.submit([&, held] {
        ++num_begun;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ++num_ended;
        return *held;
      });
    }
    waitUntil([&] { return num_begun.load() > 0; });
  }
  EXPECT_EQ(num_begun.load(), num_ended.load());
  EXPECT_LT(num_begun.load(), 5);
  EXPECT_EQ(held.use_count(), 1);
}

TEST(WorkQueue, WithoutThreadsTheCallerDoesTheWork) {
  WorkQueue<std::thread::id> queue(0, 1);
  for (int i = 0; i < 3; ++i) queue.submit([] { return std::this_thread::get_id(); });
  queue.submit([]() -> std::thread::id { throw std::runtime_error("out of luck"); });
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(queue.ready());
    EXPECT_EQ(queue.take(), std::this_thread::get_id());
  }
  EXPECT_THROW(queue.take(), std::runtime_error);
}

TEST(WorkQueue, AnIdleQueueEnds) { const WorkQueue<int> queue(3, 1); }

TEST(WorkQueue, JobsMayRunLoopsOfTheirOwn) {
  WorkQueue<std::size_t> queue(2, 2);
  for (std::size_t job = 0; job < 6; ++job) {
    queue.submit([job] {
      return parallelReduce(
          100, std::size_t{0}, [job](std::size_t i) { return i * job; },
          [](std::size_t& sum, std::size_t value) { sum += value; });
    });
  }
  for (std::size_t job = 0; job < 6; ++job) EXPECT_EQ(queue.take(), 4950 * job);
}

}  // namespace
}  // namespace hydrabench
