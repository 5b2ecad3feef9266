// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
// Sweeps as a user runs, stops and resumes them.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class StudyCommand : public ::testing::Test {
 protected:
  StudyCommand() {
    const fs::path configs = fs::path(HYDRABENCH_SOURCE_DIR) / "configs";
    writeText(folder_ / "base.yaml",
              fmt::format("datasets:\n  - config: {0}/datasets/office_quick.yaml\n"
                          "    set: [camera.width_px=180, camera.height_px=120, camera.fx_px=104, "
                          "camera.fy_px=104, camera.cx_px=90, camera.cy_px=60]\n"
                          "methods:\n  - config: {0}/methods/hydra.yaml\n"
                          "  - config: {0}/methods/template_cad.yaml\n"
                          "max_frames: 60\n"
                          "evaluation: {{samples: 300, bootstrap_resamples: 10}}\n",
                          configs.string()));
    writeText(
        folder_ / "sweep.yaml",
        "name: faults\nexperiment: base.yaml\naxes:\n"
        "  - {name: misses, values: [0, 0.2, 0.4], set: ['dataset.masks.miss_probability={}']}\n");
  }

  struct Outcome {
    int exit_code = -1;
    std::string out;
    std::string err;
  };
  /// @param before  words of the shell in front of the command
  Outcome run(const std::string& arguments, const std::string& before = "",
              const std::string& store = "store") {
    const std::string line = fmt::format(
        "cd '{}' && HYDRABENCH_STORE='{}' {} '{}' {} >out.txt 2>err.txt", folder_.path().string(),
        (folder_ / store).string(), before, HYDRABENCH_COMMAND, arguments);
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), readText(folder_ / "out.txt"), readText(folder_ / "err.txt")};
  }
  /// The bytes of the tables of a result.
  std::map<std::string, std::string> tables(const std::string& result) const {
    std::map<std::string, std::string> content;
    for (const char* file : {"scores.csv", "table.md", "table.tex", "table.csv", "table.json",
                             "plots/faults_office_quick_exists.gp", "config.yaml"}) {
      content[file] = readText(folder_ / result / file);
      EXPECT_NE(content[file], "") << file;
    }
    return content;
  }
  /// When each run of the store was finished.
  std::map<std::string, fs::file_time_type> finished() const {
    std::map<std::string, fs::file_time_type> times;
    if (!fs::exists(folder_ / "store/runs")) return times;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "store/runs")) {
      if (entry.path().filename() == "run.json") {
        times[entry.path().parent_path().filename()] = fs::last_write_time(entry.path());
      }
    }
    return times;
  }

  TemporaryFolder folder_;
};

TEST_F(StudyCommand, ASweepIsOneTableAndOnePlot) {
  const Outcome outcome = run("sweep sweep.yaml --out swept");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Hydra, misses 0.4"));
  EXPECT_THAT(readText(folder_ / "swept/scores.csv"), ::testing::StartsWith("misses,dataset,seed"));
  EXPECT_THAT(readText(folder_ / "swept/scores.csv"),
              HasSubstr("\n0.2,office_quick,1,template_cad"));
  EXPECT_THAT(readText(folder_ / "swept/plots/faults_office_quick_one_to_one.gp"),
              HasSubstr("Template CAD"));
  const Outcome status = run("status sweep.yaml");
  EXPECT_EQ(status.exit_code, 0);
  EXPECT_THAT(status.out, HasSubstr("runs       6 done    0 running    0 failed    0 missing"));
}

TEST_F(StudyCommand, ASweepKilledAgainAndAgainEndsAsIfItHadNotBeen) {
  ASSERT_EQ(run("sweep sweep.yaml --out undisturbed", "", "other_store").exit_code, 0);
  std::map<std::string, fs::file_time_type> before;
  for (const double seconds : {0.3, 1.1, 1.9, 0.7, 2.4, 1.5}) {
    run("sweep sweep.yaml --out swept --jobs 2", fmt::format("timeout -s KILL {}", seconds));
    const auto after = finished();
    for (const auto& [hash, time] : before) EXPECT_EQ(after.at(hash), time) << "done twice";
    before = after;
  }
  const Outcome outcome = run("sweep sweep.yaml --out swept --replace");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(tables("swept"), tables("undisturbed"));
}

TEST_F(StudyCommand, AFailedUnitIsNamedWithTheCommandThatDoesItAgain) {
  // Template CAD cannot do without instance images; a recording of the world has none.
  ASSERT_EQ(run("export " +
                (fs::path(HYDRABENCH_SOURCE_DIR) / "configs/datasets/office_quick.yaml").string() +
                " --frames 8 --out world --set camera.width_px=90 --set camera.height_px=60 "
                "--set camera.fx_px=52 --set camera.fy_px=52 --set camera.cx_px=45 "
                "--set camera.cy_px=30")
                .exit_code,
            0);
  fs::remove_all(folder_ / "world/instances");
  const std::string set = " --set 'datasets=[{config: world/dataset.yaml}]'";
  const Outcome outcome = run("run base.yaml --out result" + set);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  const Outcome status = run("status base.yaml" + set);
  EXPECT_EQ(status.exit_code, 4);
  EXPECT_THAT(status.out, HasSubstr("runs       1 done    0 running    1 failed    0 missing"));
  const std::string again = "again: hydrabench ";
  const std::size_t at = status.out.find(again);
  ASSERT_NE(at, std::string::npos) << status.out;
  const std::size_t begin = at + again.size();
  const std::string command = status.out.substr(begin, status.out.find('\n', begin) - begin);
  EXPECT_THAT(outcome.err, HasSubstr(command));
  EXPECT_THAT(readText(folder_ / "result/failures.txt"), HasSubstr(command));
  const Outcome work = run(command);
  EXPECT_EQ(work.exit_code, 4);
  EXPECT_THAT(work.err, HasSubstr("has no instance image"));
}

TEST_F(StudyCommand, AResultWithFailuresMayBeWrittenAgainAWholeOneNot) {
  ASSERT_EQ(run("run base.yaml --out result").exit_code, 0);
  EXPECT_EQ(run("run base.yaml --out result").exit_code, 2);
  writeText(folder_ / "result/failures.txt", "x");
  EXPECT_EQ(run("run base.yaml --out result").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "result/failures.txt"));
}

TEST_F(StudyCommand, AProcessWithoutMemoryFailsItsUnitsAndSaysSo) {
  const Outcome outcome = run("run base.yaml --out result --memory-limit 30");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("every method failed"));
  EXPECT_FALSE(fs::exists(folder_ / "result"));
}

TEST_F(StudyCommand, AGateTellsAWorseResultFromTheSame) {
  ASSERT_EQ(run("run base.yaml --out before").exit_code, 0);
  ASSERT_EQ(run("run base.yaml --out after").exit_code, 0);
  const Outcome same = run("compare before after --gate");
  EXPECT_EQ(same.exit_code, 0) << same.out;
  EXPECT_THAT(same.out, HasSubstr("| same |"));
  ASSERT_EQ(run("run base.yaml --out less --set max_frames=3").exit_code, 0);
  const Outcome worse = run("compare before less --gate --no-times --junit junit.xml");
  EXPECT_THAT(worse.exit_code, ::testing::AnyOf(1, 3)) << worse.out;
  EXPECT_THAT(readText(folder_ / "junit.xml"), HasSubstr("<testsuite"));
  EXPECT_EQ(run("compare before nowhere --gate").exit_code, 2);
}

TEST_F(StudyCommand, RunsOfOneProgramExecuteTheSameInstructions) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "valgrind does not run a program with sanitizers";
#endif
  const std::string small =
      " --count-instructions --set max_frames=13 --set methods='[{config: " +
      (fs::path(HYDRABENCH_SOURCE_DIR) / "configs/methods/hydra.yaml").string() + "}]'";
  ASSERT_EQ(run("run base.yaml --out before" + small).exit_code, 0);
  const Outcome again = run("run base.yaml --out after" + small, "", "another_store");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, Not(HasSubstr("peak memory")));
  EXPECT_FALSE(fs::exists(folder_ / "after/timing.csv"));
  const Outcome same = run("compare before after --gate --floor-time 0.002");
  EXPECT_EQ(same.exit_code, 0) << same.out;
  EXPECT_THAT(same.out, HasSubstr("instructions per frame"));
  for (const auto& entry : fs::directory_iterator(folder_ / "store")) {
    EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("counting")));
  }
}

TEST_F(StudyCommand, AnExperimentIsNoSweep) {
  const Outcome outcome = run("sweep base.yaml --out swept");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("'hydrabench run' takes experiments"));
}

TEST_F(StudyCommand, AJobOfAnotherBuildIsRefused) {
  writeText(folder_ / "job.json", R"({"program": "0", "world": {}, "runs": [], "scores": []})");
  const Outcome outcome = run("work job.json");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("job.json: of another build of hydrabench"));
}

TEST_F(StudyCommand, SlurmThatIsNotThereIsNamed) {
  // No PATH in which sbatch could be.
  const Outcome outcome = run("run base.yaml --out result --executor slurm", "PATH=/nowhere");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--executor slurm: sbatch: cannot be started"));
}

/// With a cluster of one node: real slurmctld, slurmd and munged on loopback.
class SlurmCommand : public StudyCommand {
 protected:
  void SetUp() override {
    const int status =
        std::system((kCluster + " start " + cluster() + " >" + cluster() + ".why").c_str());
    if (status != 0) GTEST_SKIP() << readText(cluster() + ".why");
    setenv("SLURM_CONF", (cluster() + "/slurm.conf").c_str(), 1);
  }
  void TearDown() override {
    std::system((kCluster + " stop " + cluster()).c_str());
    fs::remove_all(cluster());
    fs::remove(cluster() + ".why");
  }

  // Names of sockets are short.
  std::string cluster() const { return fmt::format("/tmp/hydrabench_slurm_{}", getpid()); }
  const std::string kCluster = HYDRABENCH_SOURCE_DIR "/tests/support/slurm_cluster.sh";
};

TEST_F(SlurmCommand, AJobArrayGivesTheBytesOfTheLocalExecutor) {
  ASSERT_EQ(run("sweep sweep.yaml --out local", "", "other_store").exit_code, 0);
  const Outcome outcome =
      run("sweep sweep.yaml --out swept --executor slurm --sbatch cpus-per-task=1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("6/6 runs"));
  EXPECT_EQ(tables("swept"), tables("local"));
}

TEST_F(SlurmCommand, ATaskKilledAndRequeuedInTheMiddleGivesTheSameBytes) {
  ASSERT_EQ(run("sweep sweep.yaml --out local", "", "other_store").exit_code, 0);
  // Slurm holds back what was requeued for two minutes unless it is told otherwise.
  writeText(folder_ / "requeue.sh",
            "for i in $(seq 600); do\n"
            "  task=$(squeue -h -t R -o %i | head -n 1)\n"
            "  [ -n \"$task\" ] && break\n"
            "  sleep 0.05\n"
            "done\n"
            "sleep 0.7\n"
            "scontrol requeue $task && echo $task\n"
            "for i in $(seq 60); do scontrol update jobid=$task starttime=now; sleep 0.5; done\n");
  const Outcome outcome = run("sweep sweep.yaml --out swept --executor slurm --jobs 1",
                              "env sh -c 'bash requeue.sh >requeued.txt 2>&1 & exec \"$@\"' sh");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(readText(folder_ / "requeued.txt"), HasSubstr("_")) << "nothing was requeued";
  EXPECT_EQ(tables("swept"), tables("local"));
}

TEST_F(SlurmCommand, WhatSbatchRefusesIsSaidInOneLine) {
  const Outcome outcome =
      run("run base.yaml --out result --executor slurm --sbatch partition=nowhere");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--executor slurm: sbatch refused: sbatch: error: "));
}

}  // namespace
}  // namespace hydrabench
