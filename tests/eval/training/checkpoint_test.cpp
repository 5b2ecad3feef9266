// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/checkpoint.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

/// A line fitted to a point: everything that a training has.
struct ToyTraining {
  explicit ToyTraining(const std::filesystem::path& path, int width = 1)
      : module(width, 1),
        codes(torch::zeros({3})),
        optimizer(module->parameters(), torch::optim::AdamOptions(0.1)),
        file(path, {{"step", [this] { return torch::tensor(step); },
                     [this](const torch::Tensor& t) { step = t.item<int>(); }}}) {
    file.add("codes", codes);
    file.add("module", module.ptr());
    file.add("optimizer", optimizer);
  }
  void train() {
    optimizer.zero_grad();
    module->forward(torch::ones({1, module->options.in_features()})).sum().square().backward();
    optimizer.step();
    codes += module->weight.sum().detach();
    ++step;
  }
  torch::nn::Linear module;
  torch::Tensor codes;
  torch::optim::Adam optimizer;
  int step = 0;
  Checkpoint file;
};

void expectTheSame(const ToyTraining& a, const ToyTraining& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_TRUE(torch::equal(a.codes, b.codes));
  EXPECT_TRUE(torch::equal(a.module->weight, b.module->weight));
  EXPECT_TRUE(torch::equal(a.module->bias, b.module->bias));
}

TEST(Checkpoint, GoesOnWithWeightsMomentsAndSteps) {
  const TemporaryFolder folder;
  ToyTraining first(folder / "a/state");
  EXPECT_FALSE(first.file.load());
  for (int i = 0; i < 3; ++i) first.train();
  first.file.save();
  ToyTraining second(folder / "a/state");
  ASSERT_TRUE(second.file.load());
  expectTheSame(first, second);
  for (int i = 0; i < 3; ++i) {
    first.train();
    second.train();
  }
  expectTheSame(first, second);
  EXPECT_EQ(second.step, 6);
}

TEST(Checkpoint, LeavesNothingBesideTheFile) {
  const TemporaryFolder folder;
  ToyTraining training(folder / "state");
  training.file.save();
  training.file.save();
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_EQ(entry.path().filename(), "state");
    ++files;
  }
  EXPECT_EQ(files, 1);
}

TEST(Checkpoint, SaysInOneLineThatAFileIsBrokenOrOfAnotherNetwork) {
  const TemporaryFolder folder;
  ToyTraining training(folder / "state");
  training.file.save();
  const std::string whole = readText(folder / "state");
  const auto fault = [&](ToyTraining& reader) {
    const std::string text = messageOf<InputError>([&] { reader.file.load(); });
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0) << text;
    EXPECT_THAT(text, ::testing::StartsWith((folder / "state").string() + ": is no checkpoint"));
  };
  ToyTraining wider(folder / "state", 2);
  fault(wider);
  for (const std::string& bytes :
       {std::string(), std::string("not a checkpoint\n"), whole.substr(0, whole.size() / 2)}) {
    writeText(folder / "state", bytes);
    fault(training);
  }
}

}  // namespace
}  // namespace hydrabench
