// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/nocs_pose.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/geometry/median.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// Corresponding points: the object's and those measured.
struct Pairs {
  Points nocs;
  Points points;

  std::size_t size() const { return nocs.size(); }
  void clear() {
    nocs.clear();
    points.clear();
  }
  void add(const Eigen::Vector3d& n, const Eigen::Vector3d& p) {
    nocs.push_back(n);
    points.push_back(p);
  }
};

/// Twice the largest distance from the middle (CRISP), by medians and without what lies far off, so
/// that a few wild predictions do not decide how far an inlier may be.
double diameterOf(std::span<const Eigen::Vector3d> points) {
  const Eigen::Vector3d middle = median(points);
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const Eigen::Vector3d& p : points) distances.push_back((p - middle).norm());
  constexpr double kFarOff = 3;  // of the median distance
  const double limit = kFarOff * median(distances);
  double radius = 0;
  for (const double distance : distances) {
    if (distance <= limit) radius = std::max(radius, distance);
  }
  return 2 * radius;
}

/// Whether all points lie within a hundredth of their extent of one line.
bool onALine(const Points& points) {
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) {
    if ((p - points[0]).squaredNorm() > along.squaredNorm()) along = p - points[0];
  }
  const double squared_length = along.squaredNorm();
  return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& p) {
    return along.cross(p - points[0]).norm() <= 0.01 * squared_length;
  });
}

/// Whether the points leave the yaw about `axis` open.
bool onALineAlong(const Eigen::Vector3d& axis, const Points& points) {
  double across = 0;
  double extent = 0;
  for (const Eigen::Vector3d& p : points) {
    across = std::max(across, axis.cross(p - points[0]).norm());
    extent = std::max(extent, (p - points[0]).norm());
  }
  return across <= 0.01 * extent;
}

class Solver {
 public:
  Solver(std::span<const Eigen::Vector3d> nocs, std::span<const Eigen::Vector3d> points,
         NocsFreedom freedom, const Eigen::Vector3d& up, const NocsPoseConfig& config)
      : nocs_(nocs),
        points_(points),
        freedom_(freedom),
        up_(up),
        config_(config),
        diameter_(diameterOf(nocs)) {}

  std::optional<NocsPose> solve(std::uint64_t seed) {
    std::optional<Similarity> similarity = bestOfSamples(seed);
    if (!similarity) return std::nullopt;
    for (int i = 1; i <= config_.refits; ++i) {
      const double progress = static_cast<double>(i) / config_.refits;
      const double threshold =
          config_.threshold + progress * (config_.final_threshold - config_.threshold);
      gatherInliers(*similarity, threshold);
      const std::optional<Similarity> refit = fit(inliers_);
      if (!refit) return std::nullopt;
      similarity = refit;
    }
    NocsPose pose;
    pose.similarity = *similarity;
    pose.inlier_ratio = ratioOf(consensusOf(*similarity, config_.final_threshold));
    if (!(pose.inlier_ratio >= config_.min_inlier_ratio)) return std::nullopt;
    return pose;
  }

 private:
  struct Consensus {
    std::size_t inliers = 0;
    double squared_error = 0;  ///< sum over inliers, in units of the placed object
    bool betterThan(const Consensus& other) const {
      if (inliers != other.inliers) return inliers > other.inliers;
      return squared_error < other.squared_error;
    }
  };

  std::optional<Similarity> bestOfSamples(std::uint64_t seed) {
    std::optional<Similarity> best;
    Consensus best_consensus;
    double iterations = config_.max_iterations;
    for (int i = 0; i < iterations; ++i) {
      Random random(seed, static_cast<std::uint64_t>(i));
      if (!drawSample(random)) continue;
      const std::optional<Similarity> candidate = fit(sample_);
      if (!candidate) continue;
      const Consensus consensus = consensusOf(*candidate, config_.threshold);
      if (!consensus.betterThan(best_consensus)) continue;
      best = candidate;
      best_consensus = consensus;
      iterations = std::min(iterations, iterationsNeeded(ratioOf(consensus)));
    }
    return best;
  }

  /// Fischler and Bolles, CACM 1981: samples until one without outliers has been drawn with the
  /// wanted confidence.
  double iterationsNeeded(double inlier_ratio) const {
    const double clean = std::pow(inlier_ratio, config_.sample_size);
    if (clean >= 1) return 1;
    return std::ceil(std::log(1 - config_.confidence) / std::log1p(-clean));
  }

  /// Different correspondences that fix a pose; drawn again where they do not.
  bool drawSample(Random& random) {
    constexpr int kMaxDraws = 10;
    for (int draw = 0; draw < kMaxDraws; ++draw) {
      drawn_.clear();
      sample_.clear();
      while (drawn_.size() < static_cast<std::size_t>(config_.sample_size)) {
        const std::size_t i = random.index(static_cast<std::uint32_t>(nocs_.size()));
        if (std::find(drawn_.begin(), drawn_.end(), i) != drawn_.end()) continue;
        drawn_.push_back(i);
        sample_.add(nocs_[i], points_[i]);
      }
      if (fixesAPose(sample_)) return true;
    }
    return false;
  }

  bool fixesAPose(const Pairs& pairs) const {
    if (freedom_ == NocsFreedom::kUpright) {
      return !onALineAlong(Eigen::Vector3d::UnitZ(), pairs.nocs) &&
             !onALineAlong(up_, pairs.points);
    }
    return !onALine(pairs.nocs) && !onALine(pairs.points);
  }

  std::optional<Similarity> fit(const Pairs& pairs) const {
    if (freedom_ == NocsFreedom::kUpright) return alignUpright(pairs.nocs, pairs.points, up_);
    return alignSimilarity(pairs.nocs, pairs.points, freedom_ == NocsFreedom::kSimilarity);
  }

  /// Calls visit(i, squared residual in units of the object) for every inlier.
  template <typename Visit>
  void forEachInlier(const Similarity& similarity, double threshold, const Visit& visit) const {
    const Eigen::Matrix3d A = similarity.scale * similarity.T_target_source.linear();
    const Eigen::Vector3d t = similarity.T_target_source.translation();
    const double limit = threshold * diameter_ * similarity.scale;
    const double squared_limit = limit * limit;
    for (std::size_t i = 0; i < nocs_.size(); ++i) {
      const double squared = (A * nocs_[i] + t - points_[i]).squaredNorm();
      if (squared <= squared_limit) visit(i, squared / squared_limit);
    }
  }
  Consensus consensusOf(const Similarity& similarity, double threshold) const {
    Consensus consensus;
    forEachInlier(similarity, threshold, [&](std::size_t, double squared) {
      ++consensus.inliers;
      consensus.squared_error += squared;
    });
    return consensus;
  }
  void gatherInliers(const Similarity& similarity, double threshold) {
    inliers_.clear();
    forEachInlier(similarity, threshold,
                  [&](std::size_t i, double) { inliers_.add(nocs_[i], points_[i]); });
  }
  double ratioOf(const Consensus& consensus) const {
    return static_cast<double>(consensus.inliers) / static_cast<double>(nocs_.size());
  }

  std::span<const Eigen::Vector3d> nocs_;
  std::span<const Eigen::Vector3d> points_;
  NocsFreedom freedom_;
  Eigen::Vector3d up_;
  const NocsPoseConfig& config_;
  double diameter_;
  std::vector<std::size_t> drawn_;
  Pairs sample_;
  Pairs inliers_;
};

bool allFinite(std::span<const Eigen::Vector3d> points) {
  return std::all_of(points.begin(), points.end(),
                     [](const Eigen::Vector3d& p) { return p.allFinite(); });
}

}  // namespace

void read(ConfigReader& reader, NocsPoseConfig& config) {
  reader.field("min_points", config.min_points, Bounds{3, 1e6});
  reader.field("sample_size", config.sample_size, Bounds{3, 20});
  reader.field("max_iterations", config.max_iterations, Bounds{1, 1e5});
  reader.field("confidence", config.confidence, Bounds{0, 1 - 1e-9});
  reader.field("threshold", config.threshold, Bounds{1e-6, 1});
  reader.field("final_threshold", config.final_threshold, Bounds{1e-6, 1});
  reader.field("refits", config.refits, Bounds{0, 100});
  reader.field("min_inlier_ratio", config.min_inlier_ratio, Bounds{0, 1});
}

std::optional<NocsPose> solveNocsPose(std::span<const Eigen::Vector3d> nocs,
                                      std::span<const Eigen::Vector3d> points, NocsFreedom freedom,
                                      const Eigen::Vector3d& up, const NocsPoseConfig& config,
                                      std::uint64_t seed) {
  assert(nocs.size() == points.size());
  const int needed = std::max(config.min_points, config.sample_size);
  if (nocs.size() < static_cast<std::size_t>(needed)) return std::nullopt;
  if (!allFinite(nocs) || !allFinite(points) || !up.allFinite()) return std::nullopt;
  return Solver(nocs, points, freedom, up, config).solve(seed);
}

}  // namespace hydrabench
