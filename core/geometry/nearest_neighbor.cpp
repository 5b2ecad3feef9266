// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/nearest_neighbor.h"

#include <algorithm>
#include <limits>

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

using Distance = flann::L2_3D<double>;
using Tree = flann::KDTreeSingleIndex<Distance>;

static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));  // FLANN reads the points in place

/// FLANN keeps the distance to a cell by adding and subtracting squares, whose rounding may drop a
/// point that is just as near as the best one. This much room makes the search exact; every
/// candidate is compared again with its own distance.
double withRoom(double squared_distance) { return squared_distance * (1 + 1e-12) + 1e-300; }

class NearestOne final : public flann::ResultSet<double> {
 public:
  bool full() const override { return true; }
  void addPoint(double squared_distance, std::size_t index) override {
    // Of equally near points the first one, whatever the shape of the tree.
    if (squared_distance < best_.squared_distance ||
        (squared_distance == best_.squared_distance && index < best_.index)) {
      best_ = {index, squared_distance};
    }
  }
  double worstDist() const override { return withRoom(best_.squared_distance); }
  NearestNeighbor::Match best() const { return best_; }

 private:
  NearestNeighbor::Match best_ = {std::numeric_limits<std::size_t>::max(),
                                  std::numeric_limits<double>::infinity()};
};

class AllWithin final : public flann::ResultSet<double> {
 public:
  explicit AllWithin(double squared_radius) : squared_radius_(squared_radius) {}
  bool full() const override { return true; }
  void addPoint(double squared_distance, std::size_t index) override {
    if (squared_distance <= squared_radius_) indices_.push_back(index);
  }
  double worstDist() const override { return withRoom(squared_radius_); }
  std::vector<std::size_t> sorted() && {
    std::sort(indices_.begin(), indices_.end());
    return std::move(indices_);
  }

 private:
  double squared_radius_;
  std::vector<std::size_t> indices_;
};

}  // namespace

struct NearestNeighbor::Impl {
  explicit Impl(std::span<const Eigen::Vector3d> points)
      // FLANN's matrix is not const-correct; it copies the points in the order of the tree and
      // writes to none of ours.
      : tree(flann::Matrix<double>(const_cast<double*>(points.front().data()), points.size(), 3),
             flann::KDTreeSingleIndexParams(kLeafSize, true)) {
    tree.buildIndex();
  }
  static constexpr int kLeafSize = 10;
  Tree tree;
  flann::SearchParams exact{flann::FLANN_CHECKS_UNLIMITED, 0.0f};
};

NearestNeighbor::NearestNeighbor(std::span<const Eigen::Vector3d> points) {
  if (points.empty()) throw InputError("nearest neighbours of an empty point set are not defined");
  impl_ = std::make_unique<Impl>(points);
}
NearestNeighbor::~NearestNeighbor() = default;
NearestNeighbor::NearestNeighbor(NearestNeighbor&&) noexcept = default;
NearestNeighbor& NearestNeighbor::operator=(NearestNeighbor&&) noexcept = default;

NearestNeighbor::Match NearestNeighbor::nearest(const Eigen::Vector3d& query) const {
  NearestOne result;
  impl_->tree.findNeighbors(result, query.data(), impl_->exact);
  return result.best();
}

std::vector<NearestNeighbor::Match> NearestNeighbor::nearest(
    std::span<const Eigen::Vector3d> queries) const {
  std::vector<Match> matches(queries.size());
  constexpr std::size_t kGrain = 256;
  parallelFor(
      queries.size(), [&](std::size_t i) { matches[i] = nearest(queries[i]); }, kGrain);
  return matches;
}

std::vector<std::size_t> NearestNeighbor::within(const Eigen::Vector3d& query,
                                                 double radius) const {
  AllWithin result(radius * radius);
  impl_->tree.findNeighbors(result, query.data(), impl_->exact);
  return std::move(result).sorted();
}

}  // namespace hydrabench
