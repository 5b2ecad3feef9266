// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/variant_table.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "core/types/error.h"
#include "eval/evaluation/csv.h"
#include "eval/report/comparison_table.h"
#include "metrics/aggregate.h"

namespace hydrabench {
namespace {

struct Column {
  const char* name;
  const char* title;
  VariantRow::Value VariantRow::*value;
  std::optional<double> PairScores::*score;
};
constexpr Column kColumns[] = {
    {"chamfer_l1", "Chamf.L1↓ [m]", &VariantRow::chamfer_l1, &PairScores::chamfer_l1},
    {"b_iou", "B-IoU↑", &VariantRow::b_iou, &PairScores::b_iou},
    {"v_iou_solid", "V-IoU↑", &VariantRow::v_iou, &PairScores::v_iou_solid},
};

std::vector<std::string> csvColumns() {
  std::vector<std::string> columns = {"dataset",     "seed",   "method", "class",      "variant",
                                      "threshold_m", "truths", "found",  "found_share"};
  for (const Column& column : kColumns) {
    for (const char* suffix : {"", "_ci95_low", "_ci95_high"}) {
      columns.push_back(std::string(column.name) + suffix);
    }
  }
  return columns;
}

/// Columns of a terminal, not bytes.
std::size_t displayWidth(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string alignedTable(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 3);
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) {
      widths[c] = std::max(widths[c], displayWidth(line[c]));
    }
  }
  constexpr std::size_t kNames = 3;  // leading columns that are words
  std::string text;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const std::string space(widths[c] - displayWidth(lines[l][c]), ' ');
      text += c < kNames ? "| " + lines[l][c] + space + " " : "| " + space + lines[l][c] + " ";
    }
    text += "|\n";
    if (l > 0) continue;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      text += "|" + std::string(widths[c] + 1, '-') + (c < kNames ? "-" : ":");
    }
    text += "|\n";
  }
  return text;
}

std::string shown(const VariantRow::Value& value) {
  if (!value.mean) return "n/a";
  return value.ci95 ? fmt::format("{:.3f} [{:.3f}, {:.3f}]", *value.mean, value.ci95->low,
                                  value.ci95->high)
                    : fmt::format("{:.3f}", *value.mean);
}

}  // namespace

std::vector<VariantRow> variantRows(const std::vector<MethodEvaluation>& evaluations,
                                    const EvaluationConfig& config) {
  std::set<std::string> with_pool;
  for (const MethodEvaluation& evaluation : evaluations) {
    if (evaluation.seed == kPooledSeed) with_pool.insert(evaluation.dataset);
  }
  // Class and variant in order of appearance; within them the thresholds, then the methods.
  std::map<std::pair<std::string, std::string>, std::size_t> order;
  std::vector<VariantRow> rows;
  for (const MethodEvaluation& evaluation : evaluations) {
    if (with_pool.contains(evaluation.dataset) && evaluation.seed != kPooledSeed) continue;
    using Key = std::tuple<double, std::string, std::string>;
    struct Group {
      std::size_t truths = 0;
      std::vector<const PairScores*> found;
    };
    std::map<Key, Group> groups;
    for (const ObjectRow& row : evaluation.objects) {
      if (row.matching != Matching::kOneToOne || row.threshold.kind != Threshold::Kind::kTauM ||
          !row.truth || (!row.scores && row.outcome != ObjectRow::Outcome::kMissed)) {
        continue;
      }
      const ScoredObject& truth = evaluation.truths[*row.truth];
      if (truth.subtype.empty()) continue;
      Group& group = groups[{row.threshold.value, truth.class_name, truth.subtype}];
      ++group.truths;
      if (row.scores) group.found.push_back(&*row.scores);
    }
    for (const ScoredObject& truth : evaluation.truths) {
      order.emplace(std::pair(truth.class_name, truth.subtype), order.size());
    }
    for (const auto& [key, group] : groups) {
      VariantRow row;
      row.dataset = evaluation.dataset;
      row.seed = evaluation.seed;
      row.method = evaluation.method;
      std::tie(row.threshold_m, row.class_name, row.variant) = key;
      row.truths = group.truths;
      row.found = group.found.size();
      for (const Column& column : kColumns) {
        ClassSample sample;
        for (const PairScores* scores : group.found) {
          if (const auto value = scores->*column.score) sample.values.push_back(*value);
        }
        std::sort(sample.values.begin(), sample.values.end());
        const ValuesByClass values = {{kUnknownLabel, sample}};
        VariantRow::Value& value = row.*column.value;
        value.mean = mean(values, Averaging::kMicro).value;
        if (config.bootstrap_resamples > 0 && sample.values.size() > 1) {
          value.ci95 = bootstrapMean(values, Averaging::kMicro, config.bootstrapConfig());
        }
      }
      rows.push_back(std::move(row));
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [&](const VariantRow& a, const VariantRow& b) {
    const auto key = [&](const VariantRow& row) {
      return std::tuple(row.threshold_m, row.class_name, order.at({row.class_name, row.variant}));
    };
    return a.dataset == b.dataset && key(a) < key(b);
  });
  return rows;
}

std::string renderVariantsCsv(const std::vector<VariantRow>& rows) {
  std::string text = csvLine(csvColumns());
  for (const VariantRow& row : rows) {
    std::vector<std::string> cells = {row.dataset,
                                      row.seed,
                                      row.method,
                                      row.class_name,
                                      row.variant,
                                      csvNumber(row.threshold_m),
                                      std::to_string(row.truths),
                                      std::to_string(row.found),
                                      csvNumber(row.foundShare())};
    for (const Column& column : kColumns) {
      const VariantRow::Value& value = row.*column.value;
      cells.push_back(csvNumber(value.mean));
      cells.push_back(value.ci95 ? csvNumber(value.ci95->low) : "");
      cells.push_back(value.ci95 ? csvNumber(value.ci95->high) : "");
    }
    text += csvLine(cells);
  }
  return text;
}

std::vector<VariantRow> readVariantsCsv(const std::filesystem::path& path) {
  const CsvTable table = readCsv(path, csvColumns());
  std::vector<VariantRow> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& cells = table.rows[i];
    VariantRow& row = rows.emplace_back();
    row.dataset = cells[0];
    row.seed = cells[1];
    row.method = cells[2];
    row.class_name = cells[3];
    row.variant = cells[4];
    row.threshold_m = table.number(i, 5).value_or(0);
    row.truths = static_cast<std::size_t>(table.number(i, 6).value_or(0));
    row.found = static_cast<std::size_t>(table.number(i, 7).value_or(0));
    std::size_t cell = 9;
    for (const Column& column : kColumns) {
      VariantRow::Value& value = row.*column.value;
      value.mean = table.number(i, cell++);
      const auto low = table.number(i, cell++);
      const auto high = table.number(i, cell++);
      if (low && high) value.ci95 = Interval{*low, *high};
    }
  }
  return rows;
}

std::string renderVariantsMarkdown(const std::vector<VariantRow>& rows) {
  std::string text;
  for (std::size_t begin = 0; begin < rows.size();) {
    const VariantRow& first = rows[begin];
    std::vector<std::vector<std::string>> lines = {{"class", "variant", "method", "found", "of"}};
    for (const Column& column : kColumns) lines.front().push_back(column.title);
    std::size_t end = begin;
    for (; end < rows.size() && rows[end].dataset == first.dataset &&
           rows[end].threshold_m == first.threshold_m;
         ++end) {
      const VariantRow& row = rows[end];
      const bool repeated = end > begin && rows[end - 1].variant == row.variant &&
                            rows[end - 1].class_name == row.class_name;
      auto& line = lines.emplace_back(std::vector<std::string>{
          repeated ? "" : row.class_name, repeated ? "" : row.variant, methodLabel(row.method),
          fmt::format("{:.2f}", row.foundShare()), std::to_string(row.truths)});
      for (const Column& column : kColumns) line.push_back(shown(row.*column.value));
    }
    text += fmt::format("{}### {}, tau_d = {:g} m, one_to_one\n\n", begin == 0 ? "" : "\n",
                        first.dataset, first.threshold_m) +
            alignedTable(lines);
    begin = end;
  }
  return text +
         "\nShape scores are means over the objects found; [low, high]: 95 % percentile "
         "bootstrap over objects.\n";
}

}  // namespace hydrabench
