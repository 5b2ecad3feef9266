// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/similarity_alignment.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "core/types/random.h"

namespace hydrabench {
namespace {

using Points = std::span<const Eigen::Vector3d>;

Eigen::Vector3d meanOf(Points points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

std::vector<Eigen::Vector3d> select(Points points, std::span<const std::size_t> indices) {
  std::vector<Eigen::Vector3d> selected;
  selected.reserve(indices.size());
  for (const std::size_t index : indices) selected.push_back(points[index]);
  return selected;
}

/// The correspondences a similarity explains, and how well.
struct Consensus {
  std::vector<std::size_t> inliers;
  double squared_error = 0;
  bool betterThan(const Consensus& other) const {
    if (inliers.size() != other.inliers.size()) return inliers.size() > other.inliers.size();
    return squared_error < other.squared_error;
  }
};

Consensus consensusOf(const Similarity& similarity, Points source, Points target,
                      double max_error) {
  Consensus consensus;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const double squared = (similarity(source[i]) - target[i]).squaredNorm();
    if (!(squared <= max_error * max_error)) continue;
    consensus.inliers.push_back(i);
    consensus.squared_error += squared;
  }
  return consensus;
}

/// Three different indices below `count`.
std::array<std::size_t, 3> drawSample(std::size_t count, Random& random) {
  std::array<std::size_t, 3> sample;
  const auto draw = [&] { return std::size_t{random.index(static_cast<std::uint32_t>(count))}; };
  sample[0] = draw();
  do sample[1] = draw();
  while (sample[1] == sample[0]);
  do sample[2] = draw();
  while (sample[2] == sample[0] || sample[2] == sample[1]);
  return sample;
}

}  // namespace

std::optional<Similarity> alignSimilarity(Points source, Points target, bool with_scale) {
  assert(source.size() == target.size());
  if (source.size() < 3) return std::nullopt;
  const Eigen::Vector3d source_mean = meanOf(source);
  const Eigen::Vector3d target_mean = meanOf(target);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double source_spread = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    covariance += (target[i] - target_mean) * (source[i] - source_mean).transpose();
    source_spread += (source[i] - source_mean).squaredNorm();
  }
  if (!covariance.allFinite() || !std::isfinite(source_spread)) return std::nullopt;

  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  // Points on one line leave the rotation about it open. 1e-16 of the squared extents is 1e-8 of
  // the length.
  if (!(svd.singularValues()[1] > 1e-16 * svd.singularValues()[0])) return std::nullopt;
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) signs[2] = -1;

  Similarity similarity;
  const Eigen::Matrix3d R = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  if (with_scale) similarity.scale = svd.singularValues().dot(signs) / source_spread;
  if (!(similarity.scale > 0)) return std::nullopt;
  similarity.T_target_source.linear() = R;
  similarity.T_target_source.translation() = target_mean - R * (similarity.scale * source_mean);
  return similarity;
}

std::optional<Similarity> alignUpright(Points source, Points target, const Eigen::Vector3d& up) {
  assert(source.size() == target.size() && std::abs(up.squaredNorm() - 1) < 1e-6);
  if (source.size() < 2) return std::nullopt;
  const Eigen::Matrix3d R_target_level =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up).toRotationMatrix();
  const Eigen::Vector3d source_mean = meanOf(source);
  const Eigen::Vector3d target_mean = meanOf(target);
  // trace of the covariance after a turn by yaw: cosine * cos(yaw) + sine * sin(yaw) + vertical
  double cosine = 0;
  double sine = 0;
  double vertical = 0;
  double source_spread = 0;
  double source_across = 0;
  double target_across = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Eigen::Vector3d p = source[i] - source_mean;
    const Eigen::Vector3d q = R_target_level.transpose() * (target[i] - target_mean);
    cosine += p.x() * q.x() + p.y() * q.y();
    sine += p.x() * q.y() - p.y() * q.x();
    vertical += p.z() * q.z();
    source_spread += p.squaredNorm();
    source_across += p.head<2>().squaredNorm();
    target_across += q.head<2>().squaredNorm();
  }
  const double horizontal = std::hypot(cosine, sine);
  if (!std::isfinite(horizontal + vertical + source_spread)) return std::nullopt;
  // Points above each other leave the yaw open; the bound is as in alignSimilarity.
  if (!(source_across > 1e-16 * source_spread)) return std::nullopt;
  if (!(horizontal > 1e-8 * std::sqrt(source_across * target_across))) return std::nullopt;

  Similarity similarity;
  similarity.scale = (horizontal + vertical) / source_spread;
  if (!(similarity.scale > 0)) return std::nullopt;
  const Eigen::AngleAxisd yaw(std::atan2(sine, cosine), Eigen::Vector3d::UnitZ());
  const Eigen::Matrix3d R = R_target_level * yaw.toRotationMatrix();
  similarity.T_target_source.linear() = R;
  similarity.T_target_source.translation() = target_mean - R * (similarity.scale * source_mean);
  return similarity;
}

std::optional<RobustAlignment> alignSimilarityRobust(Points source, Points target, double max_error,
                                                     int iterations, std::uint64_t seed,
                                                     bool with_scale) {
  assert(source.size() == target.size());
  if (source.size() < 3) return std::nullopt;

  const auto fit = [&](std::span<const std::size_t> indices) {
    return alignSimilarity(select(source, indices), select(target, indices), with_scale);
  };
  std::optional<Similarity> best;
  Consensus best_consensus;
  for (int i = 0; i < iterations; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    const std::optional<Similarity> candidate = fit(drawSample(source.size(), random));
    if (!candidate) continue;
    Consensus consensus = consensusOf(*candidate, source, target, max_error);
    if (consensus.inliers.size() < 3 || !consensus.betterThan(best_consensus)) continue;
    best = candidate;
    best_consensus = std::move(consensus);
  }
  if (!best) return std::nullopt;

  // A refit can swap points in and out for ever; the bound only stops that.
  constexpr int kMaxRefits = 50;
  for (int i = 0; i < kMaxRefits; ++i) {
    const std::optional<Similarity> refit = fit(best_consensus.inliers);
    if (!refit) break;
    Consensus consensus = consensusOf(*refit, source, target, max_error);
    if (consensus.inliers.size() < 3) break;
    best = refit;
    const bool is_stable = consensus.inliers == best_consensus.inliers;
    best_consensus = std::move(consensus);
    if (is_stable) break;
  }
  return RobustAlignment{*best, std::move(best_consensus.inliers)};
}

}  // namespace hydrabench
