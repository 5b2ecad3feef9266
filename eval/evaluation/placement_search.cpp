// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/placement_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "core/geometry/median.h"

namespace hydrabench {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kMinGate_m = 0.2;
constexpr double kCell_m = 0.5;       ///< of votes for an offset: about two gates of a chair
constexpr std::size_t kTopCells = 3;  ///< tried out per lattice of votes
constexpr std::size_t kMaxVotes = 200000;
constexpr double kMaxChance = 1e-4;

/// Estimates and truths by class, and how well they agree under a change of coordinates.
class Agreement {
 public:
  Agreement(std::span<const PlacedObject> estimates, std::span<const PlacedObject> truths) {
    std::map<Label, Class> by_label;
    for (const PlacedObject& object : estimates) {
      by_label[object.label].estimates.push_back(object.center);
    }
    std::vector<double> sizes;
    for (const PlacedObject& object : truths) {
      Class& of_class = by_label[object.label];
      of_class.truths.push_back(object.center);
      of_class.gates.push_back(std::max(kMinGate_m, object.half_diagonal / 2));
      sizes.push_back(object.half_diagonal);
    }
    if (!sizes.empty()) bias_m_ = std::max(1.0, 2 * median(std::move(sizes)));
    for (auto& [label, of_class] : by_label) {
      possible_ += std::min(of_class.estimates.size(), of_class.truths.size());
      votes_ += of_class.estimates.size() * of_class.truths.size();
      if (!of_class.estimates.empty() && !of_class.truths.empty()) {
        classes_.push_back(std::move(of_class));
      }
    }
    stride_ = votes_ / kMaxVotes + 1;
  }

  std::size_t possible() const { return possible_; }
  std::size_t votes() const { return votes_; }
  /// A constant that an honest method may be off by.
  double bias() const { return bias_m_; }

  /// Mutually nearest pairs of a class inside the gate. Offsets of those pairs, if asked for.
  std::size_t count(const Eigen::Matrix3d& linear, const Eigen::Vector3d& offset,
                    Points* differences = nullptr) const {
    std::size_t pairs = 0;
    for (const Class& of_class : classes_) {
      std::vector<std::size_t> nearest_truth(of_class.estimates.size(), 0);
      std::vector<double> to_truth(of_class.estimates.size(), INFINITY);
      std::vector<std::size_t> nearest_estimate(of_class.truths.size(), 0);
      std::vector<double> to_estimate(of_class.truths.size(), INFINITY);
      for (std::size_t e = 0; e < of_class.estimates.size(); ++e) {
        const Eigen::Vector3d center = linear * of_class.estimates[e] + offset;
        for (std::size_t g = 0; g < of_class.truths.size(); ++g) {
          const double distance = (center - of_class.truths[g]).squaredNorm();
          if (distance < to_truth[e]) {
            to_truth[e] = distance;
            nearest_truth[e] = g;
          }
          if (distance < to_estimate[g]) {
            to_estimate[g] = distance;
            nearest_estimate[g] = e;
          }
        }
      }
      for (std::size_t e = 0; e < of_class.estimates.size(); ++e) {
        const std::size_t g = nearest_truth[e];
        const double gate = of_class.gates[g];
        if (nearest_estimate[g] != e || !(to_truth[e] < gate * gate)) continue;
        ++pairs;
        if (differences)
          differences->push_back(of_class.truths[g] - linear * of_class.estimates[e]);
      }
    }
    return pairs;
  }

  /// Offsets between any two of a class, those within `radius` of `around`; thinned out evenly.
  Points differences(const Eigen::Matrix3d& linear, const Eigen::Vector3d& around, double radius,
                     std::size_t stride) const {
    Points result;
    std::size_t i = 0;
    for (const Class& of_class : classes_) {
      for (const Eigen::Vector3d& estimate : of_class.estimates) {
        const Eigen::Vector3d center = linear * estimate;
        for (const Eigen::Vector3d& truth : of_class.truths) {
          if (i++ % stride != 0) continue;
          if ((truth - center - around).norm() < radius) result.push_back(truth - center);
        }
      }
    }
    return result;
  }

  struct Offset {
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    std::size_t matches = 0;
  };

  /// The offset within `radius` of `around` under which most pairs agree, by votes.
  Offset bestOffset(const Eigen::Matrix3d& linear, const Eigen::Vector3d& around,
                    double radius) const {
    Offset best{around, count(linear, around)};
    const Points votes = differences(linear, around, radius, stride_);
    for (const double shift : {0.0, kCell_m / 2}) {
      std::map<std::array<double, 3>, Points> cells;
      for (const Eigen::Vector3d& vote : votes) {
        const Eigen::Array3d cell = ((vote.array() + shift) / kCell_m).floor();
        cells[{cell.x(), cell.y(), cell.z()}].push_back(vote);
      }
      std::vector<const Points*> order;
      for (const auto& [cell, members] : cells) order.push_back(&members);
      const std::size_t top = std::min(kTopCells, order.size());
      std::stable_sort(order.begin(), order.end(),
                       [](const Points* a, const Points* b) { return a->size() > b->size(); });
      for (std::size_t i = 0; i < top; ++i) {
        Eigen::Vector3d offset = median(*order[i]);
        for (int round = 0; round < 2; ++round) {
          Points agreeing;
          const std::size_t matches = count(linear, offset, &agreeing);
          if (matches > best.matches && (offset - around).norm() < radius) best = {offset, matches};
          if (agreeing.empty()) break;
          offset = median(agreeing);
        }
      }
    }
    return best;
  }

 private:
  struct Class {
    Points estimates;
    Points truths;
    std::vector<double> gates;
  };
  std::vector<Class> classes_;
  std::size_t possible_ = 0;
  std::size_t votes_ = 0;
  std::size_t stride_ = 1;
  double bias_m_ = 1;
};

/// The 47 signed permutations other than the identity.
std::vector<Eigen::Matrix3d> otherAxes() {
  std::vector<Eigen::Matrix3d> result;
  std::array<int, 3> order = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
      for (int row = 0; row < 3; ++row) {
        axes(row, order[static_cast<std::size_t>(row)]) = (signs >> row & 1) != 0 ? -1 : 1;
      }
      if (!axes.isIdentity()) result.push_back(axes);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return result;
}

std::vector<Placement> startFrames(const Transform& T_world_camera) {
  Placement camera;
  camera.frame = Placement::Frame::kFirstCamera;
  camera.T_rotation = T_world_camera.linear();
  camera.offset = T_world_camera.translation();
  Placement forward = camera;  // the same frame in the axes of ROS: x forward, y left, z up
  forward.axes << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  std::vector<Placement> frames = {camera, forward};

  const Eigen::Vector3d heading = camera.T_rotation.col(2);
  if (heading.head<2>().norm() > 1e-3) {
    Placement level = camera;
    level.frame = Placement::Frame::kFirstHeading;
    level.T_rotation =
        Eigen::AngleAxisd(std::atan2(heading.y(), heading.x()), Eigen::Vector3d::UnitZ())
            .toRotationMatrix();
    frames.push_back(level);
    level.offset.z() = 0;
    frames.push_back(level);
  }
  return frames;
}

/// Changes of coordinates by how many mistakes they stand for: one, two, three.
std::array<std::vector<Placement>, 3> placements(const std::optional<Transform>& T_world_camera) {
  std::array<std::vector<Placement>, 3> levels;
  const std::vector<Eigen::Matrix3d> all_axes = otherAxes();
  const double units[] = {0.001, 0.01, 1000};
  Placement moved;
  moved.moved = true;
  levels[0].push_back(moved);
  for (const double unit : units) {
    Placement scaled;
    scaled.unit_m = unit;
    levels[0].push_back(scaled);
    scaled.moved = true;
    levels[1].push_back(scaled);
  }
  for (const Eigen::Matrix3d& axes : all_axes) {
    Placement turned;
    turned.axes = axes;
    levels[0].push_back(turned);
    turned.moved = true;
    levels[1].push_back(turned);
    for (const double unit : units) {
      turned.unit_m = unit;
      turned.moved = false;
      levels[1].push_back(turned);
      turned.moved = true;
      levels[2].push_back(turned);
    }
  }
  Placement doubled;
  doubled.doubled_positions = true;
  levels[0].push_back(doubled);
  if (T_world_camera) {
    for (const Placement& frame : startFrames(*T_world_camera)) levels[0].push_back(frame);
  }
  return levels;
}

/// P(X >= hits) of a binomial variable.
double binomialTail(std::size_t trials, double chance, std::size_t hits) {
  double tail = 0;
  for (std::size_t k = hits; k <= trials; ++k) {
    const double n = static_cast<double>(trials);
    const double x = static_cast<double>(k);
    tail += std::exp(std::lgamma(n + 1) - std::lgamma(x + 1) - std::lgamma(n - x + 1) +
                     x * std::log(chance) + (n - x) * std::log1p(-chance));
  }
  return tail;
}

/// The rule of the header.
bool isOverwhelming(const Agreement& agreement, const Misplacement& found, std::size_t tried) {
  const Placement& placement = found.placement;
  const bool free = placement.moved;
  if (found.matches < (free ? 8u : 6u) || found.matches < 3 * found.matches_as_is) return false;
  if (found.matches * (free ? 2 : 3) < found.possible) return false;
  if (free && placement.linear().isIdentity() && placement.offset.norm() < agreement.bias()) {
    return false;
  }
  // How often do offsets agree that are certainly wrong?
  const Eigen::Matrix3d linear = placement.linear();
  const Points wrong =
      agreement.differences(linear, Eigen::Vector3d::Zero(), INFINITY, agreement.votes() / 200 + 1);
  std::size_t samples = 0;
  std::size_t most = 0;
  double sum = 0;
  for (const Eigen::Vector3d& offset : wrong) {
    if ((offset - placement.offset).norm() < agreement.bias()) continue;
    const std::size_t matches = agreement.count(linear, offset);
    most = std::max(most, matches);
    sum += static_cast<double>(matches);
    ++samples;
  }
  if (samples < 5) return false;
  if (free && 2 * found.matches < 3 * most) return false;
  // One pair agrees by construction of the offset.
  const double others = static_cast<double>(found.possible - 1);
  const double chance = std::clamp((sum / static_cast<double>(samples) - 1) / others, 0.01, 0.99);
  const double tail = binomialTail(found.possible - 1, chance, found.matches - 1);
  const double offsets = free ? static_cast<double>(agreement.votes()) : 1;
  return tail * static_cast<double>(tried) * offsets < kMaxChance;
}

}  // namespace

Eigen::Matrix3d Placement::linear() const {
  return (doubled_positions ? 0.5 : unit_m) * T_rotation * axes;
}

std::optional<Misplacement> findMisplacement(std::span<const PlacedObject> estimates,
                                             std::span<const PlacedObject> truths,
                                             const std::optional<Transform>& T_world_first_camera) {
  const Agreement agreement(estimates, truths);
  Misplacement best;
  best.possible = agreement.possible();
  best.matches_as_is =
      agreement.bestOffset(Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), agreement.bias())
          .matches;
  // Nothing can agree three times as often: the answer for every prediction that is any good.
  if (3 * best.matches_as_is > best.possible || best.possible < 6) return std::nullopt;
  bool found = false;
  std::size_t tried = 0;
  for (const std::vector<Placement>& level : placements(T_world_first_camera)) {
    tried += level.size();
    Misplacement of_level = best;
    of_level.matches = 0;
    for (Placement placement : level) {
      const Agreement::Offset offset = agreement.bestOffset(
          placement.linear(), placement.offset, placement.moved ? INFINITY : agreement.bias());
      if (offset.matches <= of_level.matches) continue;
      if (placement.moved) placement.offset = offset.value;
      of_level.placement = placement;
      of_level.matches = offset.matches;
    }
    const bool better = !found || 2 * of_level.matches > 3 * best.matches;
    if (better && isOverwhelming(agreement, of_level, tried)) {
      best = of_level;
      found = true;
    }
    if (found && 3 * best.matches >= 2 * best.possible) break;
  }
  return found ? std::optional<Misplacement>(best) : std::nullopt;
}

}  // namespace hydrabench
