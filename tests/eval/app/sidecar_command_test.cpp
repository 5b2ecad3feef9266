// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
// Hydra++ with its shapes from a program beside it, as a user runs it.
#include <cstdlib>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ContainsRegex;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

/// Maps the quick world in small images with tests/core/shape/sidecar/fake_sidecar.py.
class SidecarCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("python3 -c pass >/dev/null 2>&1") != 0) GTEST_SKIP() << "no python3 here";
    writeText(folder_ / "beside.yaml",
              fmt::format("base: {0}/configs/methods/hydra_plus_plus.yaml\n"
                          "type: hydra_plus_plus\n"
                          "name: beside\n"
                          "estimator:\n"
                          "  type: sidecar\n"
                          "  command: [python3]\n"
                          "  script: {0}/tests/core/shape/sidecar/fake_sidecar.py\n"
                          "  arguments: [box, starts_beside]\n"
                          "  log: beside.log\n",
                          HYDRABENCH_SOURCE_DIR));
  }
  /// As an item of an experiment's methods.
  static std::string method(const std::string& name, const std::string& mode, int retries) {
    return fmt::format(
        "  - {{config: beside.yaml, name: {0}, set: ['estimator.arguments=[{1}, starts_{0}]', "
        "estimator.log={0}.log, estimator.retries={2}]}}\n",
        name, mode, retries);
  }
  /// Exit code of `hydrabench run` on the methods; the result is in `result`.
  int run(const std::string& methods) const {
    writeText(
        folder_ / "run.yaml",
        fmt::format("datasets:\n  - config: {}/configs/datasets/office_quick.yaml\n"
                    "    set: [camera.width_px=180, camera.height_px=120, camera.fx_px=104, "
                    "camera.fy_px=104, camera.cx_px=90, camera.cy_px=60]\n"
                    "methods:\n{}max_frames: 100\n"
                    "evaluation: {{thresholds_m: [0.5], samples: 300, bootstrap_resamples: 0}}\n",
                    HYDRABENCH_SOURCE_DIR, methods));
    const std::string line = fmt::format(
        "cd '{}' && HYDRABENCH_STORE=store '{}' run run.yaml --out result "
        ">out.txt 2>err.txt",
        folder_.path().string(), HYDRABENCH_COMMAND);
    return WEXITSTATUS(std::system(line.c_str()));
  }
  std::string result(const std::string& file) const { return readText(folder_ / "result" / file); }
  std::string prediction(const std::string& name, const std::string& file) const {
    return result("predictions/office_quick/1/" + name + "/" + file);
  }
  /// Failures of the candidates of a method in the order of the file, "" where there is a shape.
  std::vector<std::string> failures(const std::string& name) const {
    std::vector<std::string> failures;
    std::istringstream lines(prediction(name, "candidates.jsonl"));
    for (std::string line; std::getline(lines, line);) {
      failures.push_back(nlohmann::json::parse(line).value("failure", ""));
    }
    return failures;
  }
  std::size_t starts(const std::string& name) const {
    return readText(folder_ / ("starts_" + name)).size();
  }

  TemporaryFolder folder_;
};

TEST_F(SidecarCommand, ARunFinishesAndSaysWhatBecameOfEveryQuestion) {
  ASSERT_EQ(run(method("steady", "box", 0) + method("dying", "box_dies_every_third", 0) +
                method("asked_again", "box_dies_every_third", 1) + method("garbage", "garbage", 0)),
            0)
      << readText(folder_ / "err.txt");
  const std::vector<std::string> steady = failures("steady");
  ASSERT_GE(steady.size(), 6u);
  EXPECT_THAT(steady, Each(""));
  EXPECT_EQ(starts("steady"), 1u);

  // Every third answer breaks off; the next question starts the program anew.
  std::vector<std::string> third = steady;
  for (std::size_t i = 2; i < third.size(); i += 3) third[i] = "the sidecar ended";
  EXPECT_EQ(failures("dying"), third);
  EXPECT_EQ(starts("dying"), (steady.size() + 2) / 3);

  // Of every start two answers are whole, and nothing is lost.
  EXPECT_THAT(failures("asked_again"), Each(""));
  EXPECT_EQ(starts("asked_again"), (steady.size() + 1) / 2);
  const std::string graph = prediction("steady", "scene_graph.json");
  EXPECT_NE(graph, "");
  EXPECT_TRUE(prediction("asked_again", "scene_graph.json") == graph);  // too long to print

  std::vector<std::string> nonsense(3, "the sidecar answered nonsense");
  nonsense.resize(steady.size(), "the sidecar was given up");
  EXPECT_EQ(failures("garbage"), nonsense);
  EXPECT_EQ(starts("garbage"), 3u);

  const std::string notes = result("notes.txt");
  EXPECT_THAT(notes, HasSubstr("asked_again: shapes: "));
  EXPECT_THAT(notes, Not(ContainsRegex("(steady|asked_again): [^\n]*failure")));
  EXPECT_THAT(notes, ContainsRegex(fmt::format("dying: [^\n]*{} failure: the sidecar ended",
                                               steady.size() / 3)));
  EXPECT_THAT(notes, HasSubstr(fmt::format("garbage: shapes: 0 of {0} accepted, in 0 objects; "
                                           "rejected: 3 failure: the sidecar answered nonsense, "
                                           "{1} failure: the sidecar was given up",
                                           steady.size(), steady.size() - 3)));
  EXPECT_THAT(readText(folder_ / "dying.log"), HasSubstr("the sidecar ended: exit code 9\n"));

  const auto found = [&](const std::string& name, const std::string& count) {
    return HasSubstr("office_quick,1," + name + ",all_micro,tau_m,0.5,one_to_one,found_truths," +
                     count);
  };
  const std::string scores = result("scores.csv");
  for (const std::string name : {"steady", "dying", "asked_again"}) {
    EXPECT_THAT(result("table.md"), HasSubstr("| " + name + " |"));
    EXPECT_THAT(scores, found(name, ""));
    EXPECT_THAT(scores, Not(found(name, "0,"))) << name;
  }
  EXPECT_THAT(result("table.md"), HasSubstr("| garbage |"));
  EXPECT_THAT(scores, found("garbage", "0,"));
}

}  // namespace
}  // namespace hydrabench
