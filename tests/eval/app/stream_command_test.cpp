// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
// A run replayed with other latencies, and the studies of latency, as a user calls them.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/wait.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kConfigs = HYDRABENCH_SOURCE_DIR "/configs";
/// The quick world in small images.
const std::string kSmall =
    "[camera.width_px=180, camera.height_px=120, camera.fx_px=104, camera.fy_px=104, "
    "camera.cx_px=90, camera.cy_px=60]";

class StreamCommand : public ::testing::Test {
 protected:
  struct Outcome {
    int exit_code = -1;
    std::string out;
    std::string err;
  };
  Outcome run(const std::string& arguments) {
    const std::string line = fmt::format(
        "cd '{}' && HYDRABENCH_STORE='{}' '{}' {} >out.txt 2>err.txt", folder_.path().string(),
        (folder_ / "store").string(), HYDRABENCH_COMMAND, arguments);
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), readText(folder_ / "out.txt"), readText(folder_ / "err.txt")};
  }
  /// A run of methods that are told the true shape, one with the check and one without.
  void mapTrueShapes() {
    writeText(folder_ / "run.yaml",
              fmt::format("datasets:\n  - {{config: {0}/datasets/office_quick.yaml, set: {1}}}\n"
                          "methods:\n  - {{config: {0}/methods/oracle_shape.yaml}}\n"
                          "  - {{config: {0}/methods/oracle_shape.yaml, name: unchecked, "
                          "set: [rmcc.check=none]}}\n"
                          "  - {{config: {0}/methods/hydra.yaml}}\n"
                          "max_frames: 100\nevaluation: {{samples: 300, bootstrap_resamples: 0}}\n",
                          kConfigs, kSmall));
    const Outcome mapped = run("run run.yaml --out result");
    ASSERT_EQ(mapped.exit_code, 0) << mapped.err;
  }
  /// One line on standard error and exit code 2.
  void expectFault(const std::string& arguments, const std::string& text) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(text));
  }

  TemporaryFolder folder_;
};

TEST_F(StreamCommand, ReplaysARunWithOtherLatencies) {
  mapTrueShapes();
  const std::string replay =
      "stream result --request-after 0.5 --latency 0.01 --latency published:sam3d_indoor "
      "--latency measured --set evaluation.thresholds_m=[0.5] --out ";
  const Outcome outcome = run(replay + "streamed");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("## office_quick, seed 1\n\n9.9 s count;"));
  EXPECT_THAT(outcome.out, HasSubstr("SAM3D indoors, published"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("| Hydra |")));  // it estimates no shapes
  EXPECT_THAT(readText(folder_ / "streamed/stream.csv"),
              HasSubstr("\noffice_quick,1,unchecked,\"0.01 s, given\",0.5,one_to_one,"));
  EXPECT_THAT(readText(folder_ / "streamed/f1_over_time.csv"), HasSubstr("exists"));
  EXPECT_THAT(readText(folder_ / "streamed/plots/stream_office_quick_exists.gp"),
              HasSubstr("Requests that wait"));
  for (const std::string file :
       {"stream.md", "requests.csv", "queue.csv", "break_even.csv", "provenance.json"}) {
    EXPECT_NE(readText(folder_ / "streamed" / file), "") << file;
  }
  // What takes ten milliseconds is as good as no latency at all, what takes 7 to 38 s is late.
  ASSERT_EQ(run(replay + "again").exit_code, 0);
  for (const std::string file : {"stream.csv", "requests.csv", "break_even.csv", "stream.md"}) {
    EXPECT_EQ(readText(folder_ / "streamed" / file), readText(folder_ / "again" / file)) << file;
  }
  const std::string prediction = "result/predictions/office_quick/1/oracle_shape";
  expectFault("stream " + prediction + " --out x", "expected --dataset with its ground truth");
  writeText(folder_ / "world.yaml",
            "type: simulated\nworld: quick\ncamera: {width_px: 180, height_px: 120, fx_px: 104, "
            "fy_px: 104, cx_px: 90, cy_px: 60}\n");
  const Outcome single =
      run("stream " + prediction + " --dataset world.yaml --latency 1 --out single");
  EXPECT_EQ(single.exit_code, 0) << single.err;

  expectFault("stream result --method hydra --out x",
              "--method hydra: not among those that estimate shapes: oracle_shape, unchecked");
  expectFault("stream result --latency fast --out x", "latency 'fast': expected measured, seconds");
  expectFault("stream result --latncy 1 --out x", "did you mean '--latency'?");
  expectFault("stream result --set evaluation.thresholds=[1] --out x", "thresholds_m");
  expectFault("stream result result --out x", "given twice, expected each once");
  fs::remove(folder_ / prediction / "timing.csv");
  expectFault("stream result --out x", "its timing.csv has no stage 'estimate'");
  fs::remove(folder_ / prediction / "config.yaml");
  expectFault("stream result --latency 1 --out x", "config.yaml");
}

TEST_F(StreamCommand, NeedsAResultWithShapes) {
  expectFault("stream nowhere --out x", "nowhere: no such folder");
  fs::create_directories(folder_ / "empty");
  expectFault("stream empty --out x", "empty: no candidates.jsonl in there");
}

TEST_F(StreamCommand, LatenciesOfAStudyAreTabledDrawnAndReplayed) {
  mapTrueShapes();
  writeText(folder_ / "study.yaml",
            fmt::format("datasets:\n  - {{config: {}/datasets/office_quick.yaml, set: {}}}\n"
                        "estimators:\n  - {{name: truth, type: oracle}}\n"
                        "  - {{name: absent, type: sidecar, command: [/no/such/program]}}\n"
                        "views: {{frame_step: 50, min_pixels: 60}}\n"
                        "evaluation: {{samples: 300, bootstrap_resamples: 0}}\n",
                        kConfigs, kSmall));
  const Outcome outcome = run("estimate study.yaml --out timed");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("| office_quick | absent | total | 0 | n/a | n/a | n/a | n/a "
                                     "| n/a | not available: the sidecar did not start |"));
  EXPECT_THAT(readText(folder_ / "timed/latency.csv"), HasSubstr("\noffice_quick,truth,oracle,"));
  EXPECT_THAT(readText(folder_ / "timed/plots/latency.gp"), HasSubstr("$violin_0_0"));
  EXPECT_THAT(readText(folder_ / "timed/provenance.json"), HasSubstr("cpu"));
  const Outcome streamed =
      run("stream result --method unchecked --latency timed/views.csv:truth --request-after 0.5 "
          "--out streamed");
  EXPECT_EQ(streamed.exit_code, 0) << streamed.err;
  EXPECT_THAT(streamed.out, HasSubstr("truth, measured alone"));
  expectFault("stream result --latency timed/views.csv:absent --out x",
              "no estimate of 'absent', expected one of");
}

}  // namespace
}  // namespace hydrabench
