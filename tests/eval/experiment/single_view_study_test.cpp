// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/single_view_study.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

const std::string kConfigs = HYDRABENCH_SOURCE_DIR "/configs";

std::filesystem::path studyFile(const TemporaryFolder& folder, const std::string& estimators,
                                const std::string& more = "") {
  writeText(folder / "study.yaml", "datasets:\n  - config: " + kConfigs +
                                       "/datasets/office_quick.yaml\nestimators:\n" + estimators +
                                       more);
  return folder / "study.yaml";
}

/// What is wrong with a study, in one line.
std::string faultOf(const std::string& estimators, const std::string& more = "") {
  const TemporaryFolder folder;
  const std::filesystem::path file = studyFile(folder, estimators, more);
  const std::string text = messageOf<InputError>([&] { readSingleViewStudy(file); });
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0) << text;
  EXPECT_THAT(text, HasSubstr("study.yaml"));
  return text;
}

const std::string kOracle = "  - {name: truth, type: oracle}\n";

/// The quick world with few objects, small images, a few frames, and an odometry that drifts.
const std::vector<std::string> kSmall = {"dataset.camera.width_px=180",
                                         "dataset.camera.height_px=120",
                                         "dataset.camera.fx_px=104",
                                         "dataset.camera.fy_px=104",
                                         "dataset.camera.cx_px=90",
                                         "dataset.camera.cy_px=60",
                                         "dataset.odometry.translation_m_per_sqrt_m=0.2",
                                         "dataset.office.chairs=3",
                                         "dataset.office.couches=1",
                                         "dataset.office.plants=1",
                                         "dataset.office.bins=2",
                                         "dataset.office.computers=0",
                                         "dataset.trajectory.duration_s=20",
                                         "views.frame_step=25",
                                         "views.min_pixels=60",
                                         "evaluation.samples=300"};

class FailingEstimator : public ShapeEstimator {
 public:
  ShapeOutcome estimate(const ShapeObservation&, std::span<const ShapeObservation>,
                        std::uint64_t) const override {
    ShapeOutcome outcome;
    outcome.failure = "always";
    return outcome;
  }
};

TEST(SingleViewStudy, ReadsItsFile) {
  const TemporaryFolder folder;
  const SingleViewStudy study = readSingleViewStudy(
      studyFile(folder, kOracle, "views: {choose: random, masks: given, frame_step: 7}\n"),
      {"views.min_pixels=90", "dataset.masks.min_pixels=40"});
  EXPECT_EQ(study.name, "study");
  ASSERT_EQ(study.estimators.size(), 1u);
  EXPECT_EQ(study.estimators[0].name, "truth");
  EXPECT_EQ(study.views.choose, "random");
  EXPECT_EQ(study.views.masks, "given");
  EXPECT_EQ(study.views.frame_step, 7);
  EXPECT_EQ(study.views.min_pixels, 90);
  EXPECT_THAT(study.datasets.at(0).overrides, ::testing::ElementsAre("masks.min_pixels=40"));
  EXPECT_THAT(study.resolved_config, HasSubstr("min_pixels: 90"));
}

TEST(SingleViewStudy, TheShippedOneIsValidUpToItsWeights) {
  const SingleViewStudy study = readSingleViewStudy(kConfigs + "/studies/held_out_views.yaml");
  EXPECT_EQ(study.views.masks, "true");
  EXPECT_EQ(study.datasets.at(0).numWorlds(), 5u);
}

TEST(SingleViewStudy, TheShippedStudiesOfTimeAndDomainAreValid) {
  const SingleViewStudy timing = readSingleViewStudy(kConfigs + "/studies/timing.yaml");
  ASSERT_EQ(timing.datasets.size(), 2u);
  EXPECT_THAT(timing.resolved_config, HasSubstr("type: sidecar"));
  const SingleViewStudy domain = readSingleViewStudy(kConfigs + "/studies/out_of_domain.yaml");
  EXPECT_EQ(domain.estimators.at(0).trained_on.size(), 4u);
}

TEST(SingleViewStudy, SaysWhatIsWrongWithItsFile) {
  EXPECT_THAT(faultOf("  - {name: truth, type: orakle}\n"), HasSubstr("oracle"));
  EXPECT_THAT(faultOf("  - {type: oracle}\n"), HasSubstr("name"));
  EXPECT_THAT(faultOf("  - {name: ../truth, type: oracle}\n"), HasSubstr("'../truth'"));
  EXPECT_THAT(faultOf(kOracle, "views: {chose: random}\n"), HasSubstr("choose"));
  EXPECT_THAT(faultOf(kOracle, "views: {frame_step: 0}\n"), HasSubstr("frame_step"));
  EXPECT_THAT(faultOf(kOracle, "vews: {}\n"), HasSubstr("views"));
}

TEST(SingleViewStudy, AnExperimentNamesItsCommand) {
  try {
    readSingleViewStudy(kConfigs + "/experiments/campus.yaml");
    ADD_FAILURE() << "an experiment was read as a study";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'hydrabench run "));
  }
}

TEST(SingleViewStudy, TheOracleIsExactWhateverOdometrySaysAndAnEstimatorThatFailsFails) {
  const TemporaryFolder folder;
  SingleViewStudy study = readSingleViewStudy(studyFile(folder, kOracle), kSmall);
  study.estimators.push_back(
      {"none", [](const Dataset&) { return std::make_shared<FailingEstimator>(); }});
  study.estimators.push_back({"absent", [](const Dataset&) -> std::shared_ptr<ShapeEstimator> {
                                throw InputError("no weights");
                              }});
  study.estimators[0].trained_on = {"chair"};
  std::vector<std::string> worlds;
  const auto rows =
      runSingleViewStudy(study, [&](const std::string& dataset, const std::string& seed) {
        worlds.push_back(dataset + " " + seed);
      });
  EXPECT_EQ(worlds.size(), 1u);
  ASSERT_EQ(rows.size() % 3, 0u);
  ASSERT_GE(rows.size(), 15u);
  const std::size_t count = rows.size() / 3;
  std::set<std::string> objects;
  for (std::size_t i = 0; i < count; ++i) {
    const SingleViewRow& exact = rows[i];
    objects.insert(exact.object);
    EXPECT_EQ(exact.estimator, "truth");
    EXPECT_FALSE(exact.failed()) << exact.object;
    EXPECT_LT(exact.chamfer_l1_m.value(), 1e-5) << exact.object;
    EXPECT_LT(exact.center_error_m.value(), 1e-5);
    EXPECT_GT(exact.v_iou.value(), 0.95) << exact.object;
    EXPECT_GT(exact.b_iou.value(), 0.999);
    EXPECT_EQ(exact.inlier_ratio, 1);
    EXPECT_GE(exact.pixels, 60);
    EXPECT_GT(exact.distance_m, 0.3);
    EXPECT_LT(exact.distance_m, 6);
    EXPECT_GT(exact.seen_fraction, 0);
    EXPECT_LT(exact.seen_fraction, 0.8);
    EXPECT_FALSE(exact.subtype.empty());
    EXPECT_GE(exact.wall_ms.at("total"), 0);
    EXPECT_EQ(exact.in_domain.value(), exact.class_name == "chair");

    const SingleViewRow& failed = rows[i + count];
    EXPECT_EQ(failed.estimator, "none");
    EXPECT_EQ(failed.object, exact.object);
    EXPECT_EQ(failed.stamp_ns, exact.stamp_ns);
    EXPECT_EQ(failed.failure, "always");
    EXPECT_TRUE(failed.failed());
    EXPECT_FALSE(failed.chamfer_l1_m);
    EXPECT_FALSE(failed.in_domain);

    const SingleViewRow& absent = rows[i + 2 * count];
    EXPECT_EQ(absent.object, exact.object);
    EXPECT_EQ(absent.failure, "no weights");
    EXPECT_TRUE(absent.wall_ms.empty());
  }
  EXPECT_EQ(objects.size(), count);  // every object once
  const auto summaries = summarize(rows, {.resamples = 0});
  EXPECT_EQ(summaries.front().failure_share.value, 0);
  EXPECT_EQ(summaries.front().objects, objects.size());

  // Other views of the same objects.
  study.estimators.erase(study.estimators.begin() + 1, study.estimators.end());
  study.views.choose = "random";
  study.views.masks = "given";
  const auto random = runSingleViewStudy(study, [](const auto&, const auto&) {});
  std::set<std::pair<std::string, std::int64_t>> by_box, by_chance;
  for (std::size_t i = 0; i < count; ++i) by_box.insert({rows[i].object, rows[i].stamp_ns});
  for (const SingleViewRow& row : random) by_chance.insert({row.object, row.stamp_ns});
  EXPECT_GE(random.size(), 4u);
  EXPECT_NE(by_box, by_chance);
}

TEST(SingleViewStudy, EndsWhereNoEstimatorCanBeStarted) {
  const TemporaryFolder folder;
  SingleViewStudy study = readSingleViewStudy(studyFile(folder, kOracle), kSmall);
  study.estimators[0].start = [](const Dataset&) -> std::shared_ptr<ShapeEstimator> {
    throw InputError("no weights");
  };
  EXPECT_EQ(
      messageOf<InputError>([&] { runSingleViewStudy(study, [](const auto&, const auto&) {}); }),
      "no weights");
}

}  // namespace
}  // namespace hydrabench
