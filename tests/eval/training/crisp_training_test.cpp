// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/crisp_training.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/crisp_model.h"
#include "core/shape/crisp/torch_runtime.h"
#include "core/shape/crisp/torch_weights.h"
#include "core/types/error.h"
#include "tests/eval/training/toy_samples.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

/// Trains in `out`, at most `max_steps` of a phase or of two, then asks to stop.
TrainingState trainFor(int max_steps, const CrispTrainingConfig& config,
                       const std::filesystem::path& out, PointNetwork network) {
  int steps = 0;
  return trainCrisp(
      config, out, std::move(network),
      [&](const std::string& phase, int, int, const std::map<std::string, double>&) {
        steps += phase != "worlds";
      },
      [&] { return steps >= max_steps; });
}

PointNetwork newNetwork(const CrispTrainingConfig& config) {
  keepTorchOnThisThread();
  torch::manual_seed(config.seed);
  return PointNetwork(networkOptions(config));
}

bool sameWeights(PointNetwork a, PointNetwork b) {
  const auto left = a->named_parameters();
  const auto right = b->named_parameters();
  return std::all_of(left.begin(), left.end(), [&](const auto& item) {
    return torch::equal(item.value(), right[item.key()]);
  });
}

double largestDifference(PointNetwork a, PointNetwork b) {
  double largest = 0;
  const auto right = b->named_parameters();
  for (const auto& item : a->named_parameters()) {
    const torch::Tensor difference = (item.value() - right[item.key()]).abs();
    largest = std::max(largest, difference.max().item<double>());
  }
  return largest;
}

constexpr int kAll = std::numeric_limits<int>::max();

class CrispTraining : public ::testing::Test {
 protected:
  CrispTraining() {
    cacheToyWorlds(folder_ / "through/worlds", config_.worlds);
    cacheToyWorlds(folder_ / "stopped/worlds", config_.worlds);
  }
  CrispTrainingConfig config_ = toyTraining();
  TemporaryFolder folder_;
};

TEST_F(CrispTraining, StoppedAfterAnyStepComesToTheSameWeightsAsOneThatGoesThrough) {
  PointNetwork through = newNetwork(config_);
  ASSERT_EQ(trainFor(kAll, config_, folder_ / "through", through), TrainingState::kFinished);
  PointNetwork stopped = newNetwork(config_);
  std::vector<TrainingState> states;
  do {
    stopped = newNetwork(config_);
    states.push_back(trainFor(2, config_, folder_ / "stopped", stopped));
  } while (states.back() != TrainingState::kFinished && states.size() < 20);
  // 5 steps of the decoder, then 5 of all: two calls end within the first phase, the third with the
  // first step of the second.
  using enum TrainingState;
  EXPECT_EQ(states, (std::vector{kNoNetworkYet, kNoNetworkYet, kStopped, kStopped, kFinished}));
  EXPECT_TRUE(sameWeights(through, stopped));
  EXPECT_FALSE(sameWeights(through, newNetwork(config_)));
  EXPECT_EQ(readText(folder_ / "through/loss.csv"), readText(folder_ / "stopped/loss.csv"));
}

TEST_F(CrispTraining, DoesNotDependOnTheNumberOfThreads) {
  PointNetwork through = newNetwork(config_);
  setNumThreads(1);
  trainFor(8, config_, folder_ / "through", through);
  PointNetwork other = newNetwork(config_);
  setNumThreads(2);
  trainFor(8, config_, folder_ / "stopped", other);
  setNumThreads(0);
  EXPECT_TRUE(sameWeights(through, other));
}

TEST_F(CrispTraining, GoesOnFromTheLastCheckpointAfterACrash) {
  config_.checkpoint_every = 2;
  PointNetwork through = newNetwork(config_);
  trainFor(kAll, config_, folder_ / "through", through);
  struct Crash {};
  int steps = 0;
  PointNetwork stopped = newNetwork(config_);
  const auto crashing = [&](const std::string& phase, int, int,
                            const std::map<std::string, double>&) {
    steps += phase == "network";
    if (steps == 4) throw Crash();
  };
  EXPECT_THROW(trainCrisp(config_, folder_ / "stopped", stopped, crashing, [] { return false; }),
               Crash);
  stopped = newNetwork(config_);
  EXPECT_EQ(trainFor(3, config_, folder_ / "stopped", stopped), TrainingState::kFinished);
  EXPECT_TRUE(sameWeights(through, stopped));
}

TEST_F(CrispTraining, LeavesAModelThatAnEstimatorCanLoad) {
  const TrainingProgress quiet = [](const auto&...) {};
  int calls = 0;
  const StopRequest stop = [&] { return ++calls > 9; };  // two worlds, five and two steps
  EXPECT_EQ(trainCrispModel(config_, "a: 1\n", folder_ / "through", quiet, stop),
            TrainingState::kStopped);
  EXPECT_EQ(readText(folder_ / "through/config.yaml"), "a: 1\n");
  const auto model = loadCrispModel(folder_ / "through/model", "cpu");
  EXPECT_EQ(model->freedom(), NocsFreedom::kUpright);
  EXPECT_FALSE(model->needsColor());
  EXPECT_GT(model->cubeHalfSide(), 1);

  EXPECT_THAT(messageOf<InputError>(
                  [&] { trainCrispModel(config_, "a: 2\n", folder_ / "through", quiet, stop); }),
              ::testing::HasSubstr("config.yaml: belongs to a training with other settings"));
}

TEST_F(CrispTraining, BeginsWithTheWeightsOfAnotherModel) {
  const TrainingProgress quiet = [](const auto&...) {};
  const StopRequest never = [] { return false; };
  trainCrispModel(config_, "a: 1\n", folder_ / "through", quiet, never);
  config_.seed = 2;
  config_.start_from = folder_ / "through/model";
  config_.decoder.learning_rate = config_.joint.learning_rate = 1e-8;
  trainCrispModel(config_, "a: 2\n", folder_ / "stopped", quiet, never);
  PointNetwork first = newNetwork(config_);
  loadWeights(*first, folder_ / "through/model/weights.safetensors");
  PointNetwork second = newNetwork(config_);
  EXPECT_GT(largestDifference(first, second), 0.01);
  loadWeights(*second, folder_ / "stopped/model/weights.safetensors");
  EXPECT_LT(largestDifference(first, second), 1e-4);
}

TEST_F(CrispTraining, SaysThatTheModelToBeginWithHasOtherSizes) {
  const TrainingProgress quiet = [](const auto&...) {};
  trainCrispModel(config_, "a: 1\n", folder_ / "through", quiet, [] { return false; });
  config_.start_from = folder_ / "through/model";
  config_.network.dim = 32;
  EXPECT_THAT(messageOf<InputError>([&] {
                trainCrispModel(config_, "a: 2\n", folder_ / "stopped", quiet,
                                [] { return false; });
              }),
              ::testing::HasSubstr("through/model/weights.safetensors"));
}

TEST_F(CrispTraining, MayAskForMoreShapesPerStepThanThereAre) {
  config_.decoder.shapes_per_step = 200;
  config_.decoder.steps = 1;
  EXPECT_EQ(trainFor(1, config_, folder_ / "through", newNetwork(config_)),
            TrainingState::kStopped);
}

TEST_F(CrispTraining, SaysThatACheckpointIsBroken) {
  writeText(folder_ / "through/decoder.checkpoint", "x");
  EXPECT_THAT(messageOf<InputError>(
                  [&] { trainFor(kAll, config_, folder_ / "through", newNetwork(config_)); }),
              ::testing::HasSubstr("decoder.checkpoint: is no checkpoint of this training"));
}

/// The first value over the mean of the last five.
double fall(const std::vector<double>& values) {
  return 5 * values.front() / std::accumulate(values.end() - 5, values.end(), 0.0);
}

TEST_F(CrispTraining, TheDecoderLearnsFourShapesByHeart) {
  config_.network.decoder_width = 32;
  config_.decoder.worlds = 1;
  config_.decoder.steps = 100;
  config_.decoder.points_per_shape = 100;
  TrainingPool pool(config_.worlds, InstanceSplit::kTraining, folder_ / "through/worlds");
  pool.load(0, 1);
  std::vector<double> losses;
  const std::optional<ShapeCodes> codes = trainShapeDecoder(
      config_, pool, newNetwork(config_), folder_.path(),
      [&](const auto&, int, int, const auto& numbers) { losses.push_back(numbers.at("sdf")); },
      [] { return false; });
  EXPECT_GT(fall(losses), 2);
  // Bin, chair and couch have a row; the plant was learned in two directions of no name.
  ASSERT_TRUE(codes);
  EXPECT_EQ(codes->rows, (std::map<std::int64_t, std::int64_t>{{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_EQ(codes->codes.size(0), 5);
  EXPECT_GT(codes->variance, 0);
}

TEST(CrispLoss, FallsWhenAToyNetworkLearnsAFewViewsByHeart) {
  CrispTrainingConfig config = toyTraining();
  config.network.dim = 32;
  PointNetwork network = newNetwork(config);
  const TrainingBatch batch = makeTrainingBatch(toySamples(4), {});
  torch::optim::Adam optimizer(network->parameters(), torch::optim::AdamOptions(1e-2));
  std::vector<double> losses;
  for (int step = 0; step < 60; ++step) {
    optimizer.zero_grad();
    const CrispLoss loss = crispLoss(config, network, batch, {});
    losses.push_back(loss.total.item<double>());
    loss.total.backward();
    optimizer.step();
  }
  EXPECT_GT(fall(losses), 2);
}

}  // namespace
}  // namespace hydrabench
