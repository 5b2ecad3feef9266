// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/semantic_fusion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/types/error.h"

namespace hydrabench {
namespace {

// Memory comes with the first label: most blocks hold nothing but free space. The unknown label
// carries no evidence and is passed over, except by `binary`, to which it is "not the object".

/// Hydra's SingleLabelIntegrator: the majority vote of Boyer and Moore, with weights.
class SingleLabelBlock : public SemanticBlock {
 public:
  explicit SingleLabelBlock(std::size_t num_voxels) : num_voxels_(num_voxels) {}

  void fuse(std::size_t voxel, Label label, float weight) override {
    if (label == kUnknownLabel) return;
    if (voxels_.empty()) voxels_.resize(num_voxels_);
    Voxel& v = voxels_[voxel];
    if (label == v.label) {
      v.weight += weight;
    } else if (weight >= v.weight) {
      v = {label, weight - v.weight};
    } else {
      v.weight -= weight;
    }
  }
  std::optional<Label> label(std::size_t voxel) const override {
    if (voxels_.empty() || voxels_[voxel].label == kUnknownLabel) return std::nullopt;
    return voxels_[voxel].label;
  }
  std::optional<float> share(std::size_t voxel, Label label) const override {
    const std::optional<Label> held = this->label(voxel);
    if (!held) return std::nullopt;
    return *held == label ? 1.0f : 0.0f;
  }

 private:
  struct Voxel {
    Label label = kUnknownLabel;
    float weight = 0;
  };
  std::size_t num_voxels_;
  std::vector<Voxel> voxels_;
};

/// Khronos' BinarySemanticIntegrator.
class BinaryBlock : public SemanticBlock {
 public:
  explicit BinaryBlock(std::size_t num_voxels) : num_voxels_(num_voxels) {}

  void fuse(std::size_t voxel, Label label, float) override {
    if (voxels_.empty()) voxels_.resize(num_voxels_);
    ++(label == kObject ? voxels_[voxel].object : voxels_[voxel].other);
  }
  /// Of two equal counts the object's wins.
  std::optional<Label> label(std::size_t voxel) const override {
    const std::optional<float> object = share(voxel, kObject);
    if (!object) return std::nullopt;
    return *object >= 0.5f ? kObject : kUnknownLabel;
  }
  std::optional<float> share(std::size_t voxel, Label label) const override {
    if (voxels_.empty()) return std::nullopt;
    const Voxel& v = voxels_[voxel];
    const std::uint32_t total = v.object + v.other;
    if (total == 0) return std::nullopt;
    return static_cast<float>(label == kObject ? v.object : v.other) / static_cast<float>(total);
  }

 private:
  static constexpr Label kObject = 1;
  struct Voxel {
    std::uint32_t object = 0;
    std::uint32_t other = 0;
  };
  std::size_t num_voxels_;
  std::vector<Voxel> voxels_;
};

/// How often each voxel met each label, in order of first appearance: few labels ever meet in one
/// voxel, so each has a short list.
class LabelCounts {
 public:
  struct Entry {
    Label label = kUnknownLabel;
    std::uint32_t count = 0;
    std::int32_t next = kEnd;
  };
  static constexpr std::int32_t kEnd = -1;

  explicit LabelCounts(std::size_t num_voxels) : num_voxels_(num_voxels) {}

  /// Counts a label; a new one only if the voxel holds fewer than max_labels.
  void add(std::size_t voxel, Label label, int max_labels) {
    if (first_.empty()) first_.assign(num_voxels_, kEnd);
    std::int32_t last = kEnd;
    int size = 0;
    for (std::int32_t i = first_[voxel]; i != kEnd; i = at(i).next) {
      if (at(i).label == label) {
        ++at(i).count;
        return;
      }
      last = i;
      ++size;
    }
    if (size >= max_labels) return;
    (last == kEnd ? first_[voxel] : at(last).next) = static_cast<std::int32_t>(entries_.size());
    entries_.push_back({label, 1, kEnd});
  }
  bool empty(std::size_t voxel) const { return first_.empty() || first_[voxel] == kEnd; }
  template <typename Visit>
  void forEach(std::size_t voxel, const Visit& visit) const {
    if (first_.empty()) return;
    for (std::int32_t i = first_[voxel]; i != kEnd; i = entries_[static_cast<std::size_t>(i)].next)
      visit(entries_[static_cast<std::size_t>(i)]);
  }

 private:
  Entry& at(std::int32_t i) { return entries_[static_cast<std::size_t>(i)]; }

  std::size_t num_voxels_;
  std::vector<std::int32_t> first_;  ///< per voxel
  std::vector<Entry> entries_;
};

/// Hydra's FirstKIntegrator. Of equal counts the label met first wins.
class FirstKBlock : public SemanticBlock {
 public:
  FirstKBlock(std::size_t num_voxels, int k) : counts_(num_voxels), k_(k) {}

  void fuse(std::size_t voxel, Label label, float) override {
    if (label != kUnknownLabel) counts_.add(voxel, label, k_);
  }
  std::optional<Label> label(std::size_t voxel) const override {
    LabelCounts::Entry best;
    counts_.forEach(voxel, [&](const auto& entry) {
      if (entry.count > best.count) best = entry;
    });
    return best.count > 0 ? std::optional(best.label) : std::nullopt;
  }
  std::optional<float> share(std::size_t voxel, Label label) const override {
    if (counts_.empty(voxel)) return std::nullopt;
    std::uint32_t total = 0;
    std::uint32_t own = 0;
    counts_.forEach(voxel, [&](const auto& entry) {
      total += entry.count;
      if (entry.label == label) own = entry.count;
    });
    return static_cast<float>(own) / static_cast<float>(total);
  }

 private:
  LabelCounts counts_;
  int k_;
};

/// Hydra's MLESemanticIntegrator. Its log-likelihood of label l after n hits, c_l of them of l, is
/// log(1/N) + c_l log 0.9 + (n - c_l) log 0.1: counts hold all of it. The probability is
/// 9^c_l / sum_j 9^c_j. Of equal counts the lowest label wins.
class MleBlock : public SemanticBlock {
 public:
  MleBlock(std::size_t num_voxels, int num_labels) : counts_(num_voxels), num_labels_(num_labels) {}

  void fuse(std::size_t voxel, Label label, float) override {
    if (label == kUnknownLabel || label < 0 || label >= num_labels_) return;
    counts_.add(voxel, label, num_labels_);
  }
  std::optional<Label> label(std::size_t voxel) const override {
    LabelCounts::Entry best;
    counts_.forEach(voxel, [&](const auto& entry) {
      const bool wins_tie = entry.count == best.count && entry.label < best.label;
      if (entry.count > best.count || wins_tie) best = entry;
    });
    return best.count > 0 ? std::optional(best.label) : std::nullopt;
  }
  std::optional<float> share(std::size_t voxel, Label label) const override {
    if (counts_.empty(voxel)) return std::nullopt;
    if (label < 0 || label >= num_labels_) return 0.0f;
    std::uint32_t most = 0;
    std::uint32_t own = 0;
    int met = 0;
    counts_.forEach(voxel, [&](const auto& entry) {
      most = std::max(most, entry.count);
      if (entry.label == label) own = entry.count;
      ++met;
    });
    // Against the most frequent label, so that nothing overflows.
    const auto odds = [&](std::uint32_t count) {
      return std::pow(kHit / kMiss, static_cast<double>(count) - static_cast<double>(most));
    };
    double sum = (num_labels_ - met) * odds(0);
    counts_.forEach(voxel, [&](const auto& entry) { sum += odds(entry.count); });
    return static_cast<float>(odds(own) / sum);
  }

 private:
  static constexpr double kHit = 0.9;
  static constexpr double kMiss = 0.1;
  LabelCounts counts_;
  int num_labels_;
};

}  // namespace

std::unique_ptr<SemanticBlock> makeSemanticBlock(const SemanticFusionConfig& config,
                                                 std::size_t num_voxels) {
  if (config.type == "none") return nullptr;
  if (config.type == "single_label") return std::make_unique<SingleLabelBlock>(num_voxels);
  if (config.type == "mle") return std::make_unique<MleBlock>(num_voxels, config.num_labels);
  if (config.type == "first_k") return std::make_unique<FirstKBlock>(num_voxels, config.first_k);
  if (config.type == "binary") return std::make_unique<BinaryBlock>(num_voxels);
  throw InputError("semantics: type '" + config.type +
                   "' is unknown; expected none, single_label, mle, first_k or binary");
}

void read(ConfigReader& reader, SemanticFusionConfig& config) {
  reader.choice("type", config.type, {"none", "single_label", "mle", "first_k", "binary"});
  reader.field("num_labels", config.num_labels, {1, 65536});
  reader.field("first_k", config.first_k, {1, 65536});
}

}  // namespace hydrabench
