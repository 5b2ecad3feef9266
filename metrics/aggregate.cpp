// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/aggregate.h"

#include <algorithm>
#include <cassert>

namespace hydrabench {
namespace {

ValuesByClass emptyClasses(std::span<const TruthOutcome> truths) {
  ValuesByClass classes;
  for (const TruthOutcome& truth : truths) classes.try_emplace(truth.label);
  return classes;
}

void addTo(ClassSample& sample, const std::optional<double>& value) {
  if (value) {
    sample.values.push_back(*value);
  } else {
    ++sample.undefined;
  }
}

void sortAll(ValuesByClass& classes) {
  for (auto& [label, sample] : classes) std::sort(sample.values.begin(), sample.values.end());
}

/// Mean of the defined values of several classes.
class ClassMean {
 public:
  void add(const std::optional<double>& value) {
    if (value) {
      sum_ += *value;
      ++mean_.n;
    } else {
      ++mean_.undefined;
    }
  }
  Mean get() const {
    Mean mean = mean_;
    if (mean.n > 0) mean.value = sum_ / static_cast<double>(mean.n);
    return mean;
  }

 private:
  double sum_ = 0;
  Mean mean_;
};

}  // namespace

ValuesByClass valuesOverPairs(std::span<const PairOutcome> pairs,
                              std::span<const TruthOutcome> truths, const PairScoreColumn& column) {
  ValuesByClass classes = emptyClasses(truths);
  for (const PairOutcome& pair : pairs) addTo(classes[pair.label], pair.scores.*column.value);
  sortAll(classes);
  return classes;
}

std::optional<double> valueOfTruth(const TruthOutcome& truth, const PairScoreColumn& column) {
  if (!truth.has_surface) return std::nullopt;
  const std::optional<double> worst = column.worst(truth.half_diagonal);
  if (!worst) return std::nullopt;
  if (!truth.scores) return worst;
  const std::optional<double>& found = (*truth.scores).*column.value;
  if (!found) return worst;
  return column.direction == ScoreDirection::kHigherIsBetter ? std::max(*found, *worst)
                                                             : std::min(*found, *worst);
}

ValuesByClass valuesOverTruths(std::span<const TruthOutcome> truths,
                               const PairScoreColumn& column) {
  ValuesByClass classes = emptyClasses(truths);
  for (const TruthOutcome& truth : truths) {
    addTo(classes[truth.label], valueOfTruth(truth, column));
  }
  sortAll(classes);
  return classes;
}

Mean mean(const ClassSample& sample) {
  Mean result;
  result.n = sample.values.size();
  result.undefined = sample.undefined;
  if (result.n == 0) return result;
  double sum = 0;
  for (const double value : sample.values) sum += value;
  result.value = sum / static_cast<double>(result.n);
  return result;
}

Mean mean(const ValuesByClass& values, Averaging averaging) {
  if (averaging == Averaging::kMacro) {
    ClassMean classes;
    for (const auto& [label, sample] : values) classes.add(mean(sample).value);
    return classes.get();
  }
  Mean pooled;
  double sum = 0;
  for (const auto& [label, sample] : values) {
    for (const double value : sample.values) sum += value;
    pooled.n += sample.values.size();
    pooled.undefined += sample.undefined;
  }
  if (pooled.n > 0) pooled.value = sum / static_cast<double>(pooled.n);
  return pooled;
}

Mean score(const CountsByClass& counts, DetectionScore detection_score, Averaging averaging) {
  if (averaging == Averaging::kMacro) {
    ClassMean classes;
    for (const auto& [label, of_class] : counts) {
      if (of_class.truths > 0) classes.add(detection_score(of_class));
    }
    return classes.get();
  }
  DetectionCounts pooled;
  for (const auto& [label, of_class] : counts) pooled += of_class;
  Mean result;
  result.value = detection_score(pooled);
  result.n = detection_score == precision ? pooled.estimates
             : detection_score == recall  ? pooled.truths
                                          : pooled.estimates + pooled.truths;
  return result;
}

}  // namespace hydrabench
