// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/audit/audit.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

/// Totals with as few scores off as the best one has.
std::vector<TotalFit> best(std::vector<TotalFit> fits) {
  std::erase_if(fits, [&, least = fits.empty() ? 0 : fits.front().off](const TotalFit& fit) {
    return fit.off > least;
  });
  return fits;
}

void fillBounds(std::size_t truths, AuditedRow& row) {
  for (const AuditedRow::Counts& counts : row.possible) {
    const auto pairs = static_cast<double>(std::min(counts.matched, counts.found));
    const auto estimates = static_cast<double>(counts.estimates);
    const auto total = static_cast<double>(truths);
    row.one_to_one_precision = std::max(row.one_to_one_precision, pairs / estimates);
    row.one_to_one_recall = std::max(row.one_to_one_recall, pairs / total);
    row.one_to_one_f1 = std::max(row.one_to_one_f1, 2 * pairs / (estimates + total));
  }
}

std::string score(const PrintedScore& printed) {
  const int decimals = printed.unit < 1e-3 ? 4 : 3;
  return fmt::format("{:.{}f}", printed.value, decimals);
}

std::string remark(const AuditedRow& row) {
  if (row.possible.empty()) return "impossible: no whole numbers give these scores";
  std::string text = row.many_to_one ? "many-to-one" : "";
  if (!row.f1_follows) text += std::string(text.empty() ? "" : "; ") + "F1 is not of this P and R";
  return text;
}

std::vector<std::size_t> totals(const std::vector<TotalFit>& fits) {
  std::vector<std::size_t> result;
  for (const TotalFit& fit : fits) result.push_back(fit.total);
  return result;
}

/// "88", "88 or 176", "88, 176 or 9 others"
std::string choices(const std::vector<std::size_t>& numbers) {
  if (numbers.size() == 1) return fmt::format("{}", numbers[0]);
  if (numbers.size() == 2) return fmt::format("{} or {}", numbers[0], numbers[1]);
  return fmt::format("{}, {} or {} others", numbers[0], numbers[1], numbers.size() - 2);
}

}  // namespace

std::size_t Audit::impossible() const {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [](const AuditedRow& row) { return row.possible.empty(); }));
}

Audit audit(const std::vector<PublishedRow>& rows, std::size_t max_objects) {
  Audit result;
  result.max_objects = max_objects;
  std::vector<PrintedScore> recalls;
  std::map<std::string, std::vector<PrintedScore>> precisions;
  for (const PublishedRow& row : rows) {
    recalls.push_back(row.recall);
    precisions[row.method].push_back(row.precision);
  }
  result.truths = best(fitTotals(recalls, max_objects));
  std::map<std::string, std::vector<TotalFit>> estimates;
  for (const auto& [method, printed] : precisions) {
    estimates[method] = best(fitTotals(printed, max_objects));
  }
  for (const PublishedRow& row : rows) {
    AuditedRow audited;
    audited.printed = row;
    audited.f1_follows = f1Follows(row.precision, row.recall, row.f1);
    if (!result.truths.empty()) {
      const std::size_t truths = result.truths.front().total;
      for (const TotalFit& fit : estimates[row.method]) {
        audited.possible.push_back({fit.total, fitRatio(row.precision, fit.total)->count,
                                    fitRatio(row.recall, truths)->count});
      }
      audited.many_to_one =
          !audited.possible.empty() &&
          std::none_of(audited.possible.begin(), audited.possible.end(),
                       [](const AuditedRow::Counts& c) { return c.matched == c.found; });
      fillBounds(truths, audited);
    }
    result.rows.push_back(std::move(audited));
  }
  return result;
}

std::string auditText(const Audit& audit) {
  std::string text;
  if (audit.truths.empty()) {
    text += fmt::format(
        "ground-truth objects: no number up to {} fits all recalls. Rows of different worlds, or a "
        "misprint?\n",
        audit.max_objects);
  } else {
    text += fmt::format("ground-truth objects: {}", choices(totals(audit.truths)));
    if (audit.truths.front().off > 0) {
      text += fmt::format(" ({} of {} recalls not rounded to nearest)", audit.truths.front().off,
                          audit.rows.size());
    }
    text += '\n';
  }
  std::size_t width = 6;
  for (const AuditedRow& row : audit.rows) {
    width = std::max({width, row.printed.method.size(), row.printed.group.size()});
  }
  std::string group = "\n";
  for (const AuditedRow& row : audit.rows) {
    if (row.printed.group != group) {
      group = row.printed.group;
      text +=
          fmt::format("\n{:<{}}  {:>5} {:>5} {:>5}  {:>9} {:>7} {:>5}  {}\n", group, width, "P",
                      "R", "F1", "estimates", "matched", "found", "P, R, F1 at most, one to one");
    }
    std::string counts = fmt::format("{:>9} {:>7} {:>5}  {:<28}", "-", "-", "-", "-");
    if (!row.possible.empty()) {
      const AuditedRow::Counts& first = row.possible.front();
      counts = fmt::format("{:>9} {:>7} {:>5}  {:.3f} {:.3f} {:.3f}           ", first.estimates,
                           first.matched, first.found, row.one_to_one_precision,
                           row.one_to_one_recall, row.one_to_one_f1);
    }
    text += fmt::format("{:<{}}  {} {} {}  {}  {}", row.printed.method, width,
                        score(row.printed.precision), score(row.printed.recall),
                        score(row.printed.f1), counts, remark(row));
    while (text.back() == ' ') text.pop_back();
    text += '\n';
  }
  const auto many = std::count_if(audit.rows.begin(), audit.rows.end(),
                                  [](const AuditedRow& row) { return row.many_to_one; });
  text += '\n';
  if (many > 0) {
    text += fmt::format(
        "many-to-one: in {} of {} rows no matching of pairs gives both P and R: several estimates "
        "share an object, or several objects an estimate.\n",
        many, audit.rows.size());
  }
  if (audit.impossible() > 0) {
    text += fmt::format("impossible: {} of {} rows come from no whole numbers up to {}.\n",
                        audit.impossible(), audit.rows.size(), audit.max_objects);
  }
  if (many == 0 && audit.impossible() == 0) {
    text += "every row can come from one-to-one pairs.\n";
  }
  text += fmt::format(
      "Counts: the smallest number of estimates up to {} that fits all rows of the method; more in "
      "the CSV.\n",
      audit.max_objects);
  return text;
}

std::string auditCsv(const Audit& audit) {
  std::string text =
      csvLine({"group", "method", "precision", "recall", "f1", "truths", "estimates",
               "matched_estimates", "found_truths", "one_to_one_precision_max",
               "one_to_one_recall_max", "one_to_one_f1_max", "many_to_one", "f1_follows"});
  for (const AuditedRow& row : audit.rows) {
    std::vector<AuditedRow::Counts> possible = row.possible;
    if (possible.empty()) possible.emplace_back();
    for (const AuditedRow::Counts& counts : possible) {
      const bool any = !row.possible.empty();
      const auto number = [&](std::size_t n) { return any ? std::to_string(n) : std::string(); };
      const auto bound = [&](double v) { return any ? csvNumber(v) : std::string(); };
      text +=
          csvLine({row.printed.group, row.printed.method, csvNumber(row.printed.precision.value),
                   csvNumber(row.printed.recall.value), csvNumber(row.printed.f1.value),
                   number(any ? audit.truths.front().total : 0), number(counts.estimates),
                   number(counts.matched), number(counts.found), bound(row.one_to_one_precision),
                   bound(row.one_to_one_recall), bound(row.one_to_one_f1),
                   any ? (row.many_to_one ? "yes" : "no") : "", row.f1_follows ? "yes" : "no"});
    }
  }
  return text;
}

}  // namespace hydrabench
