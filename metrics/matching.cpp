// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/matching.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <numeric>

#include "core/geometry/assignment.h"

namespace hydrabench {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

/// The objects of one class in one world, by ascending id: rows and columns of its distance table.
struct ClassMembers {
  std::vector<std::size_t> estimates;
  std::vector<std::size_t> truths;
};

void sortById(std::vector<std::size_t>& indices, std::span<const DetectionObject> objects) {
  std::stable_sort(indices.begin(), indices.end(),
                   [&](std::size_t a, std::size_t b) { return objects[a].id < objects[b].id; });
}

using ClassKey = std::pair<Label, std::uint32_t>;  ///< class and world

ClassKey keyOf(const DetectionObject& object) { return {object.label, object.world}; }

std::map<ClassKey, ClassMembers> groupByClass(std::span<const DetectionObject> estimates,
                                              std::span<const DetectionObject> truths) {
  std::map<ClassKey, ClassMembers> classes;
  for (std::size_t e = 0; e < estimates.size(); ++e) {
    classes[keyOf(estimates[e])].estimates.push_back(e);
  }
  for (std::size_t g = 0; g < truths.size(); ++g) classes[keyOf(truths[g])].truths.push_back(g);
  for (auto& [key, members] : classes) {
    sortById(members.estimates, estimates);
    sortById(members.truths, truths);
  }
  return classes;
}

/// Estimates x truths [m], infinite where the threshold does not admit the pair.
Eigen::MatrixXd gatedDistances(const ClassMembers& members,
                               std::span<const DetectionObject> estimates,
                               std::span<const DetectionObject> truths,
                               const Threshold& threshold) {
  Eigen::MatrixXd distances(members.estimates.size(), members.truths.size());
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    const DetectionObject& truth = truths[members.truths[static_cast<std::size_t>(column)]];
    for (Eigen::Index row = 0; row < distances.rows(); ++row) {
      const DetectionObject& estimate = estimates[members.estimates[static_cast<std::size_t>(row)]];
      const double distance = (estimate.center - truth.center).norm();
      distances(row, column) = threshold.admits(distance, truth) ? distance : kForbidden;
    }
  }
  return distances;
}

/// What both semantics share: empty answers, the gated distances of every class, and who is
/// ambiguous.
template <typename MatchClass>
DetectionMatches matchByClass(Matching matching, std::span<const DetectionObject> estimates,
                              std::span<const DetectionObject> truths, const Threshold& threshold,
                              const MatchClass& match_class) {
  DetectionMatches matches;
  matches.matching = matching;
  matches.truth_of_estimate.resize(estimates.size());
  matches.estimate_of_truth.resize(truths.size());
  for (const auto& [key, members] : groupByClass(estimates, truths)) {
    if (members.estimates.empty() || members.truths.empty()) continue;
    const Eigen::MatrixXd distances = gatedDistances(members, estimates, truths, threshold);
    match_class(members, distances, matches);
    for (std::size_t column = 0; column < members.truths.size(); ++column) {
      const auto candidates = distances.col(static_cast<Eigen::Index>(column)).array() < kForbidden;
      if (candidates.count() > 1) matches.ambiguous_truths.push_back(members.truths[column]);
    }
  }
  std::sort(matches.duplicates.begin(), matches.duplicates.end());
  std::sort(matches.ambiguous_truths.begin(), matches.ambiguous_truths.end());
  return matches;
}

}  // namespace

DetectionMatches matchExists(std::span<const DetectionObject> estimates,
                             std::span<const DetectionObject> truths, const Threshold& threshold) {
  // minCoeff returns the first of equal minima, which is the one of the smallest id.
  const auto match_class = [](const ClassMembers& members, const Eigen::MatrixXd& distances,
                              DetectionMatches& matches) {
    Eigen::Index nearest = 0;
    for (std::size_t row = 0; row < members.estimates.size(); ++row) {
      if (distances.row(static_cast<Eigen::Index>(row)).minCoeff(&nearest) == kForbidden) continue;
      matches.truth_of_estimate[members.estimates[row]] =
          members.truths[static_cast<std::size_t>(nearest)];
    }
    for (std::size_t column = 0; column < members.truths.size(); ++column) {
      if (distances.col(static_cast<Eigen::Index>(column)).minCoeff(&nearest) == kForbidden) {
        continue;
      }
      matches.estimate_of_truth[members.truths[column]] =
          members.estimates[static_cast<std::size_t>(nearest)];
    }
  };
  return matchByClass(Matching::kExists, estimates, truths, threshold, match_class);
}

DetectionMatches matchOneToOne(std::span<const DetectionObject> estimates,
                               std::span<const DetectionObject> truths,
                               const Threshold& threshold) {
  const auto match_class = [](const ClassMembers& members, const Eigen::MatrixXd& distances,
                              DetectionMatches& matches) {
    for (const auto& [row, column] : assignGated(distances)) {
      matches.truth_of_estimate[members.estimates[row]] = members.truths[column];
      matches.estimate_of_truth[members.truths[column]] = members.estimates[row];
    }
    // With as many pairs as possible, whatever a loner could have had is taken.
    for (std::size_t row = 0; row < members.estimates.size(); ++row) {
      const std::size_t estimate = members.estimates[row];
      const bool has_candidate =
          (distances.row(static_cast<Eigen::Index>(row)).array() < kForbidden).any();
      if (has_candidate && !matches.truth_of_estimate[estimate]) {
        matches.duplicates.push_back(estimate);
      }
    }
  };
  return matchByClass(Matching::kOneToOne, estimates, truths, threshold, match_class);
}

DetectionMatches match(Matching matching, std::span<const DetectionObject> estimates,
                       std::span<const DetectionObject> truths, const Threshold& threshold) {
  return matching == Matching::kExists ? matchExists(estimates, truths, threshold)
                                       : matchOneToOne(estimates, truths, threshold);
}

DetectionCounts counts(const DetectionMatches& matches) {
  const auto partnered = [](const std::vector<std::optional<std::size_t>>& partners) {
    return static_cast<std::size_t>(std::count_if(partners.begin(), partners.end(),
                                                  [](const auto& p) { return p.has_value(); }));
  };
  return {matches.truth_of_estimate.size(), partnered(matches.truth_of_estimate),
          matches.estimate_of_truth.size(), partnered(matches.estimate_of_truth)};
}

CountsByClass countsByClass(const DetectionMatches& matches,
                            std::span<const DetectionObject> estimates,
                            std::span<const DetectionObject> truths) {
  assert(matches.truth_of_estimate.size() == estimates.size());
  assert(matches.estimate_of_truth.size() == truths.size());
  CountsByClass by_class;
  for (std::size_t e = 0; e < estimates.size(); ++e) {
    DetectionCounts& of_class = by_class[estimates[e].label];
    ++of_class.estimates;
    of_class.matched_estimates += matches.truth_of_estimate[e].has_value();
  }
  for (std::size_t g = 0; g < truths.size(); ++g) {
    DetectionCounts& of_class = by_class[truths[g].label];
    ++of_class.truths;
    of_class.found_truths += matches.estimate_of_truth[g].has_value();
  }
  return by_class;
}

std::vector<MatchedPair> matchedPairs(const DetectionMatches& matches) {
  std::vector<MatchedPair> pairs;
  for (std::size_t e = 0; e < matches.truth_of_estimate.size(); ++e) {
    if (matches.truth_of_estimate[e]) pairs.push_back({e, *matches.truth_of_estimate[e]});
  }
  return pairs;
}

std::vector<MatchedPair> pairsToScore(const DetectionMatches& matches) {
  std::vector<MatchedPair> pairs = matchedPairs(matches);
  for (std::size_t g = 0; g < matches.estimate_of_truth.size(); ++g) {
    if (matches.estimate_of_truth[g]) pairs.push_back({*matches.estimate_of_truth[g], g});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace hydrabench
