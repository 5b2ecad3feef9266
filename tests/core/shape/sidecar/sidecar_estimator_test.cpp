// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/sidecar/sidecar_estimator.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

bool hasPython() {
  static const bool found = std::system("python3 -c pass >/dev/null 2>&1") == 0;
  return found;
}

/// Children of this process that ended and were not waited for, or still run.
std::size_t children() {
  std::size_t count = 0;
  const auto tasks = std::filesystem::path("/proc/self/task");
  for (const auto& task : std::filesystem::directory_iterator(tasks)) {
    const std::string list = readText(task.path() / "children");
    count += static_cast<std::size_t>(std::count(list.begin(), list.end(), ' '));
  }
  return count;
}

std::size_t openHandles() {
  const auto handles = std::filesystem::directory_iterator("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(handles), end(handles)));
}

class Sidecar : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!hasPython()) GTEST_SKIP() << "no python3 here";
    children_before_ = children();
  }
  void TearDown() override {
    if (!IsSkipped()) {
      EXPECT_EQ(children(), children_before_);
    }
  }

  SidecarEstimator::Config config(const std::string& mode) const {
    SidecarEstimator::Config config;
    config.process.command = {"python3", FAKE_SIDECAR, mode, (folder_ / "starts").string()};
    config.process.log = folder_ / "log";
    config.process.start_s = 20;
    config.process.call_s = 20;
    return config;
  }
  static ShapeObservation view() {
    ShapeObservation view;
    view.camera = {64, 48, 60, 60, 32, 24};
    view.color = Image<Rgb>(64, 48);
    view.depth = Image<float>(64, 48, 2.5f);
    view.depth(3, 3) = 0;
    view.mask = Image<std::uint8_t>(64, 48);
    for (int u = 0; u < 20; ++u) view.mask(u, 3) = 1;
    return view;
  }
  /// The failure, or "".
  std::string asked(const SidecarEstimator::Config& config) const {
    const ShapeOutcome outcome = SidecarEstimator(config).estimate(view(), {}, 1);
    EXPECT_EQ(outcome.failure.empty(), outcome.estimate.has_value());
    return outcome.failure;
  }
  std::size_t starts() const { return readText(folder_ / "starts").size(); }

  TemporaryFolder folder_;
  std::size_t children_before_ = 0;
};

TEST_F(Sidecar, ChildrenAreSeenByTheseTests) {
  const ChildProcess child({.command = {"sleep", "100"}});
  EXPECT_EQ(children(), children_before_ + 1);
}

TEST_F(Sidecar, AnswersWithAShapeInTheAxesOfTheCamera) {
  for (const char* mode : {"ok", "pieces", "noisy"}) {
    const ShapeOutcome outcome = SidecarEstimator(config(mode)).estimate(view(), {}, 1);
    ASSERT_TRUE(outcome.estimate) << mode << ": " << outcome.failure;
    const ShapeEstimate& estimate = *outcome.estimate;
    // The corner at (0, 2, 0), half as large, turned by a quarter from y to -x.
    const Eigen::Vector3d corner =
        estimate.T_camera_object * (estimate.scale * estimate.mesh.vertices[2]);
    EXPECT_NEAR((corner - Eigen::Vector3d(0.25 - 1, -0.5, 2.5)).norm(), 0, 1e-6) << mode;
    EXPECT_EQ(estimate.mesh.faces.size(), 4u);
    std::vector<std::string> stages;
    for (const auto& stage : outcome.times.stages()) stages.push_back(stage.name);
    EXPECT_THAT(stages,
                ::testing::UnorderedElementsAre("sidecar", "sidecar.stage1", "sidecar.decode"));
  }
  EXPECT_THAT(readText(folder_ / "log"), ::testing::HasSubstr("a library that prints"));
}

TEST_F(Sidecar, TheOneInTheDocumentationSaysABox) {
  const std::string page =
      readText(std::filesystem::path(HYDRABENCH_SOURCE_DIR) / "docs/extend.md");
  const std::size_t begin = page.find("```python\nimport array, json") + 10;
  const std::string script = page.substr(begin, page.find("```", begin) - begin);
  ASSERT_LE(std::count(script.begin(), script.end(), '\n'), 30);
  std::ofstream(folder_ / "box.py") << script;
  SidecarEstimator::Config asking = config("ok");
  asking.process.command = {"python3", (folder_ / "box.py").string()};
  ShapeObservation seen = view();
  const SidecarEstimator estimator(asking);
  const ShapeOutcome outcome = estimator.estimate(seen, {}, 1);
  ASSERT_TRUE(outcome.estimate) << outcome.failure << readText(folder_ / "log");
  // Pixels 0 to 19 of row 3 at 2.5 m.
  Mesh mesh = outcome.estimate->mesh;
  for (auto& v : mesh.vertices) v = outcome.estimate->T_camera_object * v;
  EXPECT_NEAR((bounds(mesh).min() - seen.camera.backproject(0, 3, 2.5)).norm(), 0, 1e-6);
  EXPECT_NEAR((bounds(mesh).max() - seen.camera.backproject(19, 3, 2.5)).norm(), 0, 1e-6);
  EXPECT_EQ(mesh.faces.size(), 12u);
  seen.depth.fill(0);
  EXPECT_EQ(estimator.estimate(seen, {}, 1).failure, "the sidecar rejected the view");
}

TEST_F(Sidecar, TheFramesOfSam3dComeBackAsThoseOfTheCamera) {
  ShapeObservation seen = view();
  seen.depth.fill(2);
  seen.depth(0, 0) = 0;
  for (int i = 0; i < 12; ++i) {
    Transform T_camera_object = Transform::Identity();
    // All components of the quaternion take turns in being the largest.
    const Eigen::Vector3d axis =
        Eigen::Vector3d(i % 3 == 0 ? 3 : 1, i % 3 == 1 ? -3 : 0.5, i % 3 == 2 ? 3 : -0.7);
    T_camera_object.linear() = Eigen::AngleAxisd(0.8 * i, axis.normalized()).toRotationMatrix();
    T_camera_object.translation() = Eigen::Vector3d(0.3, -0.2, 1.9);
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation = T_camera_object.linear();
    const nlohmann::json truth = {{"R", std::vector<double>(rotation.data(), rotation.data() + 9)},
                                  {"t", {0.3, -0.2, 1.9}},
                                  {"s", 0.7}};
    SidecarEstimator::Config asking = config("ok");
    asking.process.command = {"python3", SAM3D_STUB, HYDRABENCH_SOURCE_DIR "/scripts",
                              truth.dump()};
    const ShapeOutcome outcome = SidecarEstimator(asking).estimate(seen, {}, 1);
    ASSERT_TRUE(outcome.estimate) << outcome.failure << readText(folder_ / "log");
    EXPECT_TRUE(outcome.estimate->T_camera_object.isApprox(T_camera_object, 1e-6)) << i;
    EXPECT_NEAR(outcome.estimate->scale, 0.7, 1e-6);
    EXPECT_EQ(outcome.estimate->mesh.vertices[3], Eigen::Vector3d(0, 0, 3));
  }
}

TEST_F(Sidecar, Sam3dHasMadeACallBeforeItSaysHello) {
  for (const char* warm_up : {"works", "fails"}) {
    const nlohmann::json truth = {
        {"R", {1, 0, 0, 0, 1, 0, 0, 0, 1}}, {"t", {0, 0, 2}}, {"s", 1}, {"warm_up", warm_up}};
    SidecarProcess::Config asking = config("ok").process;
    asking.command = {"python3", SAM3D_STUB, HYDRABENCH_SOURCE_DIR "/scripts", truth.dump()};
    SidecarProcess process(asking);
    const nlohmann::json hello = process.hello();
    EXPECT_GT(hello.at("warm_up_s").get<double>(), 0) << warm_up;
    ASSERT_EQ(hello.at("seen").size(), 1u) << warm_up;
    // A ball with a radius of 0.3 m, 1.5 m away.
    const nlohmann::json& seen = hello.at("seen")[0];
    EXPECT_EQ(seen.at("bytes").get<int>(), 3 * seen.at("pixels").get<int>());
    EXPECT_GT(seen.at("on").get<int>(), 5000);
    EXPECT_NEAR(seen.at("nearest").get<double>(), 1.2, 1e-3);
    EXPECT_NEAR(seen.at("left").get<double>(), 0.3, 0.02);
    EXPECT_NEAR(seen.at("top").get<double>(), 0.3, 0.02);
    // It is warm, and answers whatever became of that.
    ShapeObservation view = Sidecar::view();
    view.depth.fill(2);
    view.depth(0, 0) = 0;
    const SidecarMessage answer = process.call(sidecarQuestion(view, 1, 20));
    EXPECT_EQ(answer.header.at("status"), "ok") << answer.header;
  }
  EXPECT_THAT(readText(folder_ / "log"),
              ::testing::HasSubstr("warm-up: RuntimeError('no voxels')"));
}

TEST_F(Sidecar, AFaultOnceIsAskedAgainOfAProgramStartedAnew) {
  for (const char* mode : {"garbage_once", "dies_once", "late_once"}) {
    std::filesystem::remove(folder_ / "starts");
    SidecarEstimator::Config asking = config(mode);
    asking.process.call_s = std::string(mode) == "late_once" ? 3 : 20;
    EXPECT_EQ(asked(asking), "") << mode;
    EXPECT_EQ(starts(), 2u) << mode;
  }
}

TEST_F(Sidecar, WhatKeepsFailingIsAFailureOfItsKind) {
  const auto failureOf = [&](const char* mode) {
    SidecarEstimator::Config asking = config(mode);
    asking.process.start_s = std::string(mode) == "no_hello" ? 0.5 : 20;
    asking.process.call_s = std::string(mode) == "late" ? 0.5 : 20;
    asking.retries = 1;
    return asked(asking);
  };
  EXPECT_EQ(failureOf("late"), "the sidecar did not answer in time");
  EXPECT_EQ(failureOf("garbage"), "the sidecar answered nonsense");
  EXPECT_EQ(failureOf("wrong_length"), "the sidecar answered nonsense");
  EXPECT_EQ(failureOf("other_id"), "the sidecar answered nonsense");
  EXPECT_EQ(failureOf("dies"), "the sidecar ended");
  EXPECT_EQ(failureOf("closes_output"), "the sidecar ended");
  EXPECT_THAT(readText(folder_ / "log"),
              ::testing::HasSubstr("hydrabench: the sidecar ended: exit code 9\n"));
  EXPECT_EQ(failureOf("no_hello"), "the sidecar did not start");
  EXPECT_EQ(failureOf("dies_at_start"), "the sidecar did not start");
  EXPECT_EQ(failureOf("rejected"), "the sidecar rejected the view");
  EXPECT_EQ(failureOf("error"), "the sidecar reported an error");
  for (const char* mode : {"nan", "nan_pose", "mirrored", "negative", "bad_face", "no_shape"}) {
    EXPECT_THAT(failureOf(mode), ::testing::AnyOf("the sidecar's answer is no shape",
                                                  "the sidecar answered nonsense"))
        << mode;
  }
}

TEST_F(Sidecar, AProgramThatIsNotThereIsAFailureNotAnEnd) {
  SidecarEstimator::Config asking;
  asking.process.command = {"/nowhere/at_all"};
  EXPECT_EQ(asked(asking), "the sidecar did not start");
}

TEST_F(Sidecar, AProgramThatDoesNotReadDoesNotHoldUsUp) {
  SidecarEstimator::Config asking = config("deaf");
  asking.process.call_s = 0.5;
  asking.retries = 0;
  ShapeObservation large = view();
  large.camera = {1280, 960, 60, 60, 32, 24};
  large.color = Image<Rgb>(1280, 960);
  large.depth = Image<float>(1280, 960, 2.5f);
  large.mask = Image<std::uint8_t>(1280, 960, 1);
  EXPECT_EQ(SidecarEstimator(asking).estimate(large, {}, 1).failure,
            "the sidecar did not answer in time");
}

TEST_F(Sidecar, IsGivenUpAfterSeveralObjectsInARow) {
  SidecarEstimator::Config asking = config("dies");
  asking.retries = 0;
  asking.max_failed_objects = 2;
  const SidecarEstimator estimator(asking);
  EXPECT_EQ(estimator.estimate(view(), {}, 1).failure, "the sidecar ended");
  EXPECT_EQ(estimator.estimate(view(), {}, 1).failure, "the sidecar ended");
  EXPECT_EQ(estimator.estimate(view(), {}, 1).failure, "the sidecar was given up");
  EXPECT_EQ(starts(), 2u);
}

TEST_F(Sidecar, WhatWasRecordedIsAnsweredWithoutTheProgram) {
  SidecarEstimator::Config asking = config("ok");
  asking.record = folder_ / "kept";
  const ShapeOutcome live = SidecarEstimator(asking).estimate(view(), {}, 1);
  ASSERT_TRUE(live.estimate);
  SidecarEstimator::Config replaying;
  replaying.replay = folder_ / "kept";
  replaying.process.call_s = 1;  // another deadline is no other question
  const SidecarEstimator replay(replaying);
  const ShapeOutcome again = replay.estimate(view(), {}, 1);
  ASSERT_TRUE(again.estimate) << again.failure;
  EXPECT_EQ(again.estimate->mesh.vertices, live.estimate->mesh.vertices);
  EXPECT_TRUE(again.estimate->T_camera_object.isApprox(live.estimate->T_camera_object, 0));
  EXPECT_EQ(again.times.stages().size(), 3u);
  EXPECT_EQ(replay.estimate(view(), {}, 2).failure, "no recorded answer");
  ShapeObservation other = view();
  other.depth(5, 5) = 1;
  EXPECT_EQ(replay.estimate(other, {}, 1).failure, "no recorded answer");
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "kept")) {
    if (entry.path().extension() == ".answer") std::ofstream(entry.path()) << "cut";
  }
  EXPECT_EQ(replay.estimate(view(), {}, 1).failure, "the recorded answer is no message");
}

TEST_F(Sidecar, ManyThreadsMayAskAtOnce) {
  const SidecarEstimator estimator(config("ok"));
  std::vector<std::thread> threads;
  std::vector<int> good(8, 0);
  for (std::size_t i = 0; i < good.size(); ++i) {
    threads.emplace_back([&, i] {
      for (int k = 0; k < 5; ++k) good[i] += estimator.estimate(view(), {}, i).estimate.has_value();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(good, ::testing::Each(5));
  EXPECT_EQ(starts(), 1u);
}

TEST_F(Sidecar, RestartsLeaveNothingBehind) {
  SidecarProcess::Config program = config("dies").process;
  program.command = {"/bin/sh", "-c", "exit 1"};
  SidecarProcess process(program);
  const auto restart = [&] {
    try {
      process.call({});
      ADD_FAILURE();
    } catch (const SidecarFault& fault) {
      EXPECT_EQ(fault.what, "exit code 1");
    }
  };
  restart();
  const std::size_t handles = openHandles();
  for (int i = 1; i < 1000; ++i) restart();
  EXPECT_EQ(process.starts(), 1000);
  EXPECT_EQ(openHandles(), handles);
  EXPECT_EQ(children(), children_before_);
}

SidecarEstimator::Config configOf(const ConfigDocument& document) {
  SidecarEstimator::Config config;
  ConfigReader reader(document);
  read(reader, config);
  reader.finish();
  return config;
}
/// The fault of a document.
std::string faultOf(const std::string& yaml) {
  return messageOf<InputError>([&] { configOf(ConfigDocument::fromString(yaml, "s.yaml")); });
}

TEST(SidecarConfig, ACommandIsNeeded) {
  EXPECT_THROW(SidecarEstimator({}), InputError);
  EXPECT_EQ(faultOf("call_s: 5"),
            "s.yaml: command: missing, expected the program to start and its arguments");
  EXPECT_EQ(faultOf("command: []\nscript: estimator.py\n"),
            "s.yaml:1: command: missing, expected the program to start and its arguments");
  EXPECT_EQ(configOf(ConfigDocument::fromString("replay: /answers")).replay, "/answers");
}

TEST(SidecarConfig, EveryKeyIsRead) {
  const TemporaryFolder folder;
  writeText(folder / "methods/sidecar.yaml",
            "command: [python3, -u]\n"
            "script: ../estimator.py\n"
            "arguments: [--model, small]\n"
            "log: said.log\n"
            "start_s: 600\n"
            "call_s: 0.25\n"
            "retries: 0\n"
            "max_failed_objects: 7\n"
            "max_faces: 500\n"
            "record: kept\n"
            "replay: answers\n");
  const SidecarEstimator::Config config =
      configOf(ConfigDocument::fromFile(folder / "methods/sidecar.yaml"));
  EXPECT_THAT(config.process.command,
              ::testing::ElementsAre("python3", "-u", (folder / "estimator.py").string(), "--model",
                                     "small"));
  EXPECT_EQ(config.process.log, "said.log");
  EXPECT_EQ(config.process.start_s, 600);
  EXPECT_EQ(config.process.call_s, 0.25);
  EXPECT_EQ(config.retries, 0);
  EXPECT_EQ(config.max_failed_objects, 7);
  EXPECT_EQ(config.max_faces, 500);
  EXPECT_EQ(config.record, "kept");
  EXPECT_EQ(config.replay, folder / "methods/answers");
}

TEST(SidecarConfig, WhatIsNotGivenKeepsItsDefault) {
  const SidecarEstimator::Config config =
      configOf(ConfigDocument::fromString("command: [estimator]"));
  const SidecarEstimator::Config untouched;
  EXPECT_THAT(config.process.command, ::testing::ElementsAre("estimator"));
  EXPECT_EQ(config.process.start_s, untouched.process.start_s);
  EXPECT_EQ(config.process.call_s, untouched.process.call_s);
  EXPECT_EQ(config.retries, untouched.retries);
  EXPECT_EQ(config.max_failed_objects, untouched.max_failed_objects);
  EXPECT_EQ(config.max_faces, untouched.max_faces);
  EXPECT_TRUE(config.process.log.empty() && config.record.empty() && config.replay.empty());
}

TEST(SidecarConfig, AMistakeIsOneLineWithItsPlace) {
  EXPECT_EQ(faultOf("command: [estimator]\nretrys: 1\n"),
            "s.yaml:2: retrys: unknown key, did you mean retries?");
  EXPECT_EQ(faultOf("command: [estimator]\ncall_s: 0\n"),
            "s.yaml:2: call_s: 0 is out of bounds, expected 0.01 to 1000000");
  EXPECT_EQ(faultOf("command: [estimator]\n\nmax_failed_objects: 0\n"),
            "s.yaml:3: max_failed_objects: 0 is out of bounds, expected 1 to 1000000000");
}

}  // namespace
}  // namespace hydrabench
