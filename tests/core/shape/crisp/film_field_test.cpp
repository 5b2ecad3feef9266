// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/film_field.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

FilmSdf decoder(bool residual_gain) {
  torch::manual_seed(1);
  return FilmSdf(FilmSdfImpl::Options{.layers = 3, .width = 32, .residual_gain = residual_gain});
}

torch::Tensor modulationFor(FilmSdf& film) {
  torch::manual_seed(2);
  return 0.3 * torch::randn({1, film->modulationSize()});
}

std::vector<Eigen::Vector3f> somePoints(std::size_t count) {
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(3, i);
    Eigen::Vector3f p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<float>(random.uniform(-1, 1));
    points.push_back(p);
  }
  return points;
}

class FilmFieldTest : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(ResidualGain, FilmFieldTest, ::testing::Bool());

TEST_P(FilmFieldTest, EqualsTheDecoder) {
  FilmSdf film = decoder(GetParam());
  const torch::Tensor modulation = modulationFor(film);
  const std::vector<Eigen::Vector3f> points = somePoints(500);
  std::vector<float> values(points.size());
  makeFilmField(*film, modulation)(points, values);

  const torch::NoGradGuard no_grad;
  torch::Tensor input = torch::empty({1, 500, 3});
  for (int i = 0; i < 500; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      input[0][i][axis] = points[static_cast<std::size_t>(i)][axis];
    }
  }
  const torch::Tensor expected = film->forward(input, modulation);
  for (int i = 0; i < 500; ++i) {
    EXPECT_NEAR(values[static_cast<std::size_t>(i)], expected[0][i].item<float>(), 1e-4);
  }
}

TEST(FilmField, KeepsWhatItNeeds) {
  SdfField field;
  {
    FilmSdf film = decoder(true);
    field = makeFilmField(*film, modulationFor(film));
    const torch::NoGradGuard no_grad;
    for (torch::Tensor& parameter : film->parameters()) parameter.zero_();
  }
  const std::vector<Eigen::Vector3f> points = somePoints(10);
  std::vector<float> values(points.size(), 0.0f);
  field(points, values);
  EXPECT_NE(values[0], values[1]);
}

TEST(FilmField, IsTheSameFromAnyThread) {
  FilmSdf film = decoder(true);
  const SdfField field = makeFilmField(*film, modulationFor(film));
  const std::vector<Eigen::Vector3f> points = somePoints(1024);
  std::vector<float> expected(points.size());
  field(points, expected);
  setNumThreads(4);
  std::vector<std::vector<float>> values(16, std::vector<float>(points.size()));
  parallelFor(values.size(), [&](std::size_t i) { field(points, values[i]); });
  setNumThreads(0);
  for (const std::vector<float>& once : values) EXPECT_EQ(once, expected);
}

}  // namespace
}  // namespace hydrabench
