// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "metrics/matching.h"
#include "metrics/surface_distance.h"
#include "tests/metrics/random_objects.h"
#include "tests/metrics/shapes.h"
#include "tests/support/python_oracle.h"

namespace hydrabench {
namespace {

/// The numbers a script prints, or none where SciPy is absent.
std::optional<std::vector<double>> askScipy(std::string_view script, const std::string& input,
                                            std::string& reason) {
  const OracleAnswer answer = askPython({"numpy", "scipy"}, script, input);
  reason = answer.reason;
  if (!answer.output) return std::nullopt;
  std::istringstream stream(*answer.output);
  return std::vector<double>(std::istream_iterator<double>(stream), {});
}

TEST(ScipyAgreement, ChamferSqIsThatOfCkdtree) {
  const ObjectModel::Config config;
  const ObjectModel estimate(potato({3.02, 1, 0.5}, 0.5, 3, 0.8), ObjectModel::Role::kEstimate,
                             config);
  const ObjectModel truth(potato({3, 1, 0.5}, 0.5, 3), ObjectModel::Role::kTruth, config);
  std::string input;
  for (const ObjectModel* model : {&estimate, &truth}) {
    for (const Eigen::Vector3d& p : model->samples()) {
      fmt::format_to(std::back_inserter(input), "{} {} {}\n", p.x(), p.y(), p.z());
    }
  }
  std::string reason;
  const auto values = askScipy(R"(
import sys
import numpy
from scipy.spatial import cKDTree
points = numpy.loadtxt(sys.stdin)
estimate, truth = points[:10000], points[10000:]
to_truth, _ = cKDTree(truth).query(estimate)
to_estimate, _ = cKDTree(estimate).query(truth)
print(repr(float((to_truth ** 2).mean() + (to_estimate ** 2).mean())))
)",
                               input, reason);
  if (!values) GTEST_SKIP() << reason;
  ASSERT_EQ(values->size(), 1u);
  EXPECT_NEAR(*chamferSq(estimate, truth) / (*values)[0], 1, 1e-6);
}

TEST(ScipyAgreement, OneToOneMatchingIsThatOfLinearSumAssignment) {
  Random random(23);
  std::string input;
  std::vector<double> expected;
  for (int world = 0; world < 20; ++world) {
    const auto truths = randomObjects(30, 1, 2.5, random);
    const auto estimates = randomObjects(36, 1, 2.5, random);
    for (const auto* objects : {&estimates, &truths}) {
      for (const DetectionObject& o : *objects) {
        fmt::format_to(std::back_inserter(input), "{} {} {}\n", o.center.x(), o.center.y(),
                       o.center.z());
      }
    }
    const auto pairs = matchedPairs(matchOneToOne(estimates, truths, Threshold::tau(0.5)));
    double sum = 0;
    for (const MatchedPair& pair : pairs) {
      sum += (estimates[pair.estimate].center - truths[pair.truth].center).norm();
    }
    expected.push_back(static_cast<double>(pairs.size()));
    expected.push_back(sum);
  }
  std::string reason;
  // A forbidden pair costs more than any number of allowed ones: most pairs first, then the
  // shortest.
  const auto values = askScipy(R"(
import sys
import numpy
from scipy.optimize import linear_sum_assignment
from scipy.spatial.distance import cdist
for world in numpy.loadtxt(sys.stdin).reshape(20, 66, 3):
    cost = cdist(world[:36], world[36:])
    allowed = cost < 0.5
    rows, columns = linear_sum_assignment(numpy.where(allowed, cost, 1e4))
    kept = allowed[rows, columns]
    print(kept.sum(), repr(float(cost[rows, columns][kept].sum())))
)",
                               input, reason);
  if (!values) GTEST_SKIP() << reason;
  ASSERT_EQ(values->size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR((*values)[i], expected[i], 1e-7);
}

}  // namespace
}  // namespace hydrabench
