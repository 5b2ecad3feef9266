// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/assignment.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace hydrabench {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

template <typename Cost>
struct Optimum {
  std::vector<std::size_t> column_of;  ///< per row
  std::vector<Cost> row_price;  ///< dual variables: cost(r, c) - row_price[r] - column_price[c] >=
                                ///< 0, = 0 on the assignment
  std::vector<Cost> column_price;
};

/// Assigns every row, num_rows <= num_columns, by shortest augmenting paths over reduced costs.
/// Cost is an ordered additive group.
template <typename Cost, typename CostOf>
Optimum<Cost> solve(std::size_t num_rows, std::size_t num_columns, const CostOf& cost_of) {
  Optimum<Cost> optimum{std::vector<std::size_t>(num_rows, kNone), std::vector<Cost>(num_rows, 0),
                        std::vector<Cost>(num_columns, 0)};
  std::vector<std::size_t> row_of(num_columns, kNone);
  std::vector<Cost> distance(num_columns);
  std::vector<std::size_t> previous_row(num_columns);
  for (std::size_t start = 0; start < num_rows; ++start) {
    std::vector<bool> reached(num_columns, false);   // distance known
    std::vector<bool> finished(num_columns, false);  // distance final
    std::vector<std::size_t> order;
    std::size_t row = start;
    Cost length = 0;
    std::size_t last = kNone;
    while (last == kNone) {
      std::size_t next = kNone;
      for (std::size_t column = 0; column < num_columns; ++column) {
        if (finished[column]) continue;
        const Cost candidate =
            length + cost_of(row, column) - optimum.row_price[row] - optimum.column_price[column];
        if (!reached[column] || candidate < distance[column]) {
          reached[column] = true;
          distance[column] = candidate;
          previous_row[column] = row;
        }
        const bool is_nearer = next == kNone || distance[column] < distance[next] ||
                               (distance[column] == distance[next] && row_of[column] == kNone &&
                                row_of[next] != kNone);
        if (is_nearer) next = column;
      }
      length = distance[next];
      finished[next] = true;
      order.push_back(next);
      if (row_of[next] == kNone)
        last = next;
      else
        row = row_of[next];
    }
    optimum.row_price[start] += length;
    for (const std::size_t column : order) {
      const Cost slack = length - distance[column];
      optimum.column_price[column] -= slack;
      if (row_of[column] != kNone) optimum.row_price[row_of[column]] += slack;
    }
    for (std::size_t column = last; column != kNone;) {
      const std::size_t owner = previous_row[column];
      const std::size_t freed = optimum.column_of[owner];
      row_of[column] = owner;
      optimum.column_of[owner] = column;
      column = owner == start ? kNone : freed;
    }
  }
  return optimum;
}

// Ties can only be told from rounding when costs add up exactly, so the gated problem is solved in
// whole numbers.
__extension__ using Whole = __int128;
constexpr int kCostBits = 52;  ///< of the largest cost: as many as a double has

/// One connected part of the gated problem, padded to a square: a forbidden pair and a padded one
/// both mean "stays alone" and cost more than all allowed pairs together, so the cheapest
/// assignment has the most allowed pairs.
class Component {
 public:
  Component(const Eigen::MatrixXd& cost, double unit, std::vector<std::size_t> rows,
            std::vector<std::size_t> columns)
      : cost_(cost),
        rows_(std::move(rows)),
        columns_(std::move(columns)),
        size_(std::max(rows_.size(), columns_.size())),
        alone_((static_cast<Whole>(2 * size_) + 2) << kCostBits) {
    whole_cost_.assign(size_ * size_, alone_);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        if (!isAllowed(r, c)) continue;
        whole_cost_[r * size_ + c] =
            static_cast<std::int64_t>(std::nearbyint(givenCost(r, c) / unit));
      }
    }
  }

  void solveInto(Assignment& pairs) {
    optimum_ =
        solve<Whole>(size_, size_, [this](std::size_t r, std::size_t c) { return costOf(r, c); });
    row_of_.assign(size_, kNone);
    for (std::size_t r = 0; r < size_; ++r) row_of_[optimum_.column_of[r]] = r;
    settled_column_.assign(size_, false);
    // The optimal assignments are the perfect ones among pairs of reduced cost 0. Settle row by row
    // for the first column that still lets all others be assigned that way.
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      settle(r);
      const std::size_t column = optimum_.column_of[r];
      if (!isAllowed(r, column)) continue;
      settled_column_[column] = true;
      pairs.emplace_back(rows_[r], columns_[column]);
    }
  }

 private:
  double givenCost(std::size_t r, std::size_t c) const {
    return cost_(static_cast<Eigen::Index>(rows_[r]), static_cast<Eigen::Index>(columns_[c]));
  }
  bool isAllowed(std::size_t r, std::size_t c) const {
    return r < rows_.size() && c < columns_.size() && std::isfinite(givenCost(r, c));
  }
  Whole costOf(std::size_t r, std::size_t c) const { return whole_cost_[r * size_ + c]; }
  bool isTight(std::size_t r, std::size_t c) const {
    return costOf(r, c) == optimum_.row_price[r] + optimum_.column_price[c];
  }

  void settle(std::size_t r) {
    const std::size_t current = optimum_.column_of[r];
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (c == current && isAllowed(r, c)) return;
      if (settled_column_[c] || !isAllowed(r, c) || !isTight(r, c)) continue;
      // Row r takes c; whoever had it must find another column, the one r gives up being free.
      const std::size_t displaced = row_of_[c];
      std::vector<bool> visited = settled_column_;
      visited[c] = true;
      row_of_[optimum_.column_of[r]] = kNone;
      if (reassign(displaced, visited)) {
        optimum_.column_of[r] = c;
        row_of_[c] = r;
        return;
      }
      row_of_[optimum_.column_of[r]] = r;
    }
  }

  /// Finds a column for `row` along an alternating path of tight pairs. A settled row that stays
  /// alone may be moved to another padded column, but never finds a partner here: it would have
  /// found it when it was settled.
  bool reassign(std::size_t row, std::vector<bool>& visited) {
    for (std::size_t c = 0; c < size_; ++c) {
      if (visited[c] || !isTight(row, c)) continue;
      visited[c] = true;
      if (row_of_[c] == kNone || reassign(row_of_[c], visited)) {
        optimum_.column_of[row] = c;
        row_of_[c] = row;
        return true;
      }
    }
    return false;
  }

  const Eigen::MatrixXd& cost_;
  std::vector<std::size_t> rows_;
  std::vector<std::size_t> columns_;
  std::size_t size_;
  Whole alone_;
  std::vector<Whole> whole_cost_;  ///< size_ x size_, in units
  Optimum<Whole> optimum_;
  std::vector<std::size_t> row_of_;
  std::vector<bool> settled_column_;
};

/// Rows and columns connected by allowed pairs. Every part is small where the gate is narrow, and
/// the work is cubic in its size.
std::vector<Component> componentsOf(const Eigen::MatrixXd& cost, double unit) {
  const auto num_rows = static_cast<std::size_t>(cost.rows());
  const auto num_columns = static_cast<std::size_t>(cost.cols());
  std::vector<bool> row_seen(num_rows, false);
  std::vector<bool> column_seen(num_columns, false);
  std::vector<Component> components;
  for (std::size_t start = 0; start < num_rows; ++start) {
    if (row_seen[start]) continue;
    row_seen[start] = true;
    std::vector<std::size_t> rows = {start};
    std::vector<std::size_t> columns;
    for (std::size_t next_row = 0, next_column = 0; next_row < rows.size();) {
      const auto r = static_cast<Eigen::Index>(rows[next_row++]);
      for (std::size_t c = 0; c < num_columns; ++c) {
        if (column_seen[c] || !std::isfinite(cost(r, static_cast<Eigen::Index>(c)))) continue;
        column_seen[c] = true;
        columns.push_back(c);
      }
      for (; next_column < columns.size(); ++next_column) {
        const auto c = static_cast<Eigen::Index>(columns[next_column]);
        for (std::size_t row = 0; row < num_rows; ++row) {
          if (row_seen[row] || !std::isfinite(cost(static_cast<Eigen::Index>(row), c))) continue;
          row_seen[row] = true;
          rows.push_back(row);
        }
      }
    }
    if (columns.empty()) continue;
    std::sort(rows.begin(), rows.end());
    std::sort(columns.begin(), columns.end());
    components.emplace_back(cost, unit, std::move(rows), std::move(columns));
  }
  return components;
}

}  // namespace

Assignment assignMinCost(const Eigen::MatrixXd& cost) {
  assert(cost.allFinite());
  const bool is_tall = cost.rows() > cost.cols();
  const auto num_rows = static_cast<std::size_t>(is_tall ? cost.cols() : cost.rows());
  const auto num_columns = static_cast<std::size_t>(is_tall ? cost.rows() : cost.cols());
  const auto optimum = solve<double>(num_rows, num_columns, [&](std::size_t r, std::size_t c) {
    const auto row = static_cast<Eigen::Index>(r);
    const auto column = static_cast<Eigen::Index>(c);
    return is_tall ? cost(column, row) : cost(row, column);
  });
  Assignment pairs;
  for (std::size_t r = 0; r < num_rows; ++r) {
    const std::size_t c = optimum.column_of[r];
    pairs.emplace_back(is_tall ? c : r, is_tall ? r : c);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Assignment assignGated(const Eigen::MatrixXd& cost) {
  double largest = 0;
  for (const double value : cost.reshaped()) {
    assert(!std::isnan(value) && value != -std::numeric_limits<double>::infinity());
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  // A power of two, so that dividing by it rounds nothing away that the whole numbers can hold.
  const double unit = std::exp2(std::ilogb(largest > 0 ? largest : 1.0) + 1 - kCostBits);
  Assignment pairs;
  for (Component& component : componentsOf(cost, unit)) component.solveInto(pairs);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace hydrabench
