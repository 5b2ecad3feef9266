// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/experiment_config.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kConfigs = HYDRABENCH_SOURCE_DIR "/configs";

/// An experiment of two methods on the quick world, with more lines below.
std::filesystem::path experiment(const TemporaryFolder& folder, const std::string& methods,
                                 const std::string& more = "") {
  const std::filesystem::path path = folder / "experiment.yaml";
  std::ofstream(path) << "datasets:\n  - config: " << kConfigs
                      << "/datasets/office_quick.yaml\n    seeds: [4, 7]\nmethods:\n"
                      << methods << more;
  return path;
}

std::string method(const std::string& file, const std::string& more = "") {
  return "  - config: " + kConfigs + "/methods/" + file + "\n" + more;
}

std::string faultOf(const std::filesystem::path& path,
                    const std::vector<std::string>& overrides = {}) {
  try {
    readExperiment(path, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ExperimentConfig, EverySeedIsAWorldOfItsOwn) {
  const TemporaryFolder folder;
  const ExperimentConfig config =
      readExperiment(experiment(folder, method("hydra.yaml")), {"dataset.masks.min_pixels=40"});
  ASSERT_EQ(config.datasets.size(), 1u);
  EXPECT_THAT(config.datasets[0].overrides, ElementsAre("masks.min_pixels=40"));
  ASSERT_EQ(config.datasets[0].numWorlds(), 2u);
  EXPECT_EQ(config.datasets[0].read(1).seed, 7u);
  EXPECT_EQ(config.name, "experiment");
}

TEST(ExperimentConfig, OneMethodMayRunTwiceUnderTwoNames) {
  const TemporaryFolder folder;
  const ExperimentConfig config = readExperiment(
      experiment(folder, method("hydra.yaml") + method("hydra.yaml", "    name: hydra_2\n")),
      {"methods.hydra_2.min_range_m=0.25"});
  ASSERT_EQ(config.methods.size(), 2u);
  EXPECT_EQ(config.methods[1].name, "hydra_2");
  EXPECT_THAT(config.methods[1].resolved_config, HasSubstr("min_range_m: 0.25"));
  EXPECT_THAT(config.methods[0].resolved_config, HasSubstr("min_range_m: 0.1"));
}

TEST(ExperimentConfig, TheSameNameTwiceIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(faultOf(experiment(folder, method("hydra.yaml") + method("hydra.yaml"))),
              HasSubstr("methods: name 'hydra' occurs twice"));
}

TEST(ExperimentConfig, AMistypedMethodInAnOverrideGetsAGuess) {
  const TemporaryFolder folder;
  EXPECT_THAT(faultOf(experiment(folder, method("hydra.yaml")), {"methods.hidra.min_range_m=1"}),
              HasSubstr("no method 'hidra'"));
  EXPECT_THAT(faultOf(experiment(folder, method("hydra.yaml")), {"methods.hidra.min_range_m=1"}),
              HasSubstr("did you mean 'hydra'?"));
}

TEST(ExperimentConfig, AllFaultsOfTheFileComeAtOnce) {
  const TemporaryFolder folder;
  const std::string fault =
      faultOf(experiment(folder, "  - config: nowhere.yaml\n", "evaluaton: {}\nmax_frames: -1\n"));
  EXPECT_THAT(fault, HasSubstr("no such file"));
  EXPECT_THAT(fault, HasSubstr("evaluaton: unknown key"));
  EXPECT_THAT(fault, HasSubstr("max_frames"));
}

TEST(ExperimentConfig, AnUnknownKeyOfAMethodNamesFileAndEntry) {
  const TemporaryFolder folder;
  EXPECT_THAT(faultOf(experiment(folder, method("hydra.yaml", "    set: [\"min_rnge_m=1\"]\n"))),
              HasSubstr("experiment.yaml: methods.0: min_rnge_m: unknown key"));
}

TEST(ExperimentConfig, OneDatasetTwiceNeedsTwoNames) {
  const TemporaryFolder folder;
  const auto again = [&](const std::string& more) {
    const std::filesystem::path path = folder / "twice.yaml";
    std::ofstream(path) << "datasets:\n  - config: " << kConfigs << "/datasets/office_quick.yaml\n"
                        << "  - config: " << kConfigs << "/datasets/office_quick.yaml\n"
                        << more << "methods:\n"
                        << method("hydra.yaml");
    return path;
  };
  EXPECT_THAT(faultOf(again("")), HasSubstr("the dataset occurs twice, expected different names"));
  EXPECT_EQ(faultOf(again("    name: noisy\n    set: [\"masks.miss_probability=0.5\"]\n")), "");
  EXPECT_THAT(faultOf(again("    name: a/b\n")), HasSubstr("'a/b', expected letters"));
}

TEST(ExperimentConfig, ASeedBesideAListOfSeedsIsAContradiction) {
  const TemporaryFolder folder;
  EXPECT_THAT(faultOf(experiment(folder, method("hydra.yaml")), {"dataset.seed=3"}),
              HasSubstr("set datasets.0.seeds"));
}

TEST(ExperimentConfig, AnotherKindOfStudyNamesItsCommand) {
  EXPECT_THAT(faultOf(kConfigs + "/studies/timing.yaml"), HasSubstr("'hydrabench estimate "));
  EXPECT_THAT(faultOf(kConfigs + "/sweeps/d_extra.yaml"), HasSubstr("'hydrabench sweep "));
}

TEST(ExperimentConfig, EveryShippedExperimentIsReadable) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kConfigs + "/experiments")) {
    EXPECT_EQ(faultOf(entry.path()), "") << entry.path();
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(MethodTable, EveryShippedMethodIsReadable) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kConfigs + "/methods")) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(readMethod(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST(MethodTable, AMissingTypeListsAll) {
  const TemporaryFolder folder;
  std::ofstream(folder / "m.yaml") << "name: mine\n";
  try {
    readMethod(folder / "m.yaml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("type: missing, expected one of: hydra, khronos"));
  }
}

TEST(MethodTable, ANameThatIsNoFileNameIsRefused) {
  EXPECT_THROW(readMethod(kConfigs + "/methods/hydra.yaml", {"name=../hydra"}), InputError);
}

}  // namespace
}  // namespace hydrabench
