// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/latency_model.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/config/config_reader.h"
#include "core/types/error.h"
#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

constexpr const char* kPublishedPrefix = "published:";

/// Runtime per object in Hydra++, from its project page. CRISP: a mean, "nearly constant".
struct Published {
  const char* name;
  const char* label;
  double mean_s;
  double low_s;  ///< low = high: constant
  double high_s;
};
constexpr Published kPublished[] = {
    {"sam3d_indoor", "SAM3D indoors, published", 14.62, 7, 38},
    {"sam3d_outdoor", "SAM3D outdoors, published", 11.01, 7, 16},
    {"crisp_indoor", "CRISP indoors, published", 0.43, 0.43, 0.43},
    {"crisp_outdoor", "CRISP outdoors, published", 0.42, 0.42, 0.42},
};

std::optional<double> numberIn(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError(fmt::format("latency '{}': {}", text, why));
}

LatencyModel publishedLatency(const std::string& text) {
  const std::string name = text.substr(std::string(kPublishedPrefix).size());
  for (const Published& published : kPublished) {
    if (name != published.name) continue;
    if (published.low_s < published.high_s) {
      return rangedLatency(published.label, published.mean_s, published.low_s, published.high_s);
    }
    LatencyModel model = constantLatency(published.mean_s);
    model.label = published.label;
    return model;
  }
  const std::string guess = didYouMean(name, publishedLatencies());
  refuse(text, fmt::format("expected one of {}{}", fmt::join(publishedLatencies(), ", "),
                           guess.empty() ? "" : fmt::format("; did you mean '{}'?", guess)));
}

LatencyModel statedLatency(const std::string& text) {
  std::map<std::string, double> stated;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = part.find('=');
    const std::string key = part.substr(0, equals);
    const std::set<std::string> known = {"mean", "p50", "p90", "p99", "max"};
    const auto value = numberIn(equals == std::string::npos ? "" : part.substr(equals + 1));
    if (!known.contains(key) || !value || *value < 0 || stated.contains(key)) {
      refuse(text,
             fmt::format("'{}', expected mean, p50, p90, p99 or max, each once, = seconds", part));
    }
    stated[key] = *value;
  }
  LatencySummary summary;
  double last = stated.contains("p50")    ? stated["p50"]
                : stated.contains("mean") ? stated["mean"]
                                          : -1;
  if (last < 0) refuse(text, "expected mean= or p50=");
  if (stated.contains("mean")) summary.mean = stated["mean"];
  for (const auto& [key, field] : {std::pair{"p50", &LatencySummary::p50},
                                   {"p90", &LatencySummary::p90},
                                   {"p99", &LatencySummary::p99},
                                   {"max", &LatencySummary::max}}) {
    const double value = stated.contains(key) ? stated[key] : last;
    if (value < last) refuse(text, fmt::format("{} is below what comes before it", key));
    summary.*field = last = value;
  }
  return summarizedLatency(text + " s, given", summary);
}

LatencyModel recordedLatency(const std::filesystem::path& file, const std::string& estimator) {
  const auto cells = readCsvCells(file);
  const auto column = [&](const std::string& name) -> std::size_t {
    if (!cells.empty()) {
      const auto found = std::find(cells[0].begin(), cells[0].end(), name);
      if (found != cells[0].end()) return static_cast<std::size_t>(found - cells[0].begin());
    }
    throw InputError(fmt::format("{}: no column '{}', expected views.csv of 'hydrabench estimate'",
                                 file.string(), name));
  };
  const std::size_t of_estimator = column("estimator");
  const std::size_t of_failure = column("failure");
  const std::size_t of_total = column("total_wall_ms");
  std::vector<double> seconds;
  std::set<std::string> estimators;
  for (std::size_t row = 1; row < cells.size(); ++row) {
    if (cells[row].size() != cells[0].size()) {
      throw InputError(fmt::format("{}:{}: {} cells, expected {}", file.string(), row + 1,
                                   cells[row].size(), cells[0].size()));
    }
    estimators.insert(cells[row][of_estimator]);
    if (cells[row][of_estimator] != estimator || !cells[row][of_failure].empty()) continue;
    const auto ms = numberIn(cells[row][of_total]);
    if (!ms || *ms < 0) {
      throw InputError(fmt::format("{}:{}: total_wall_ms: '{}', expected a time", file.string(),
                                   row + 1, cells[row][of_total]));
    }
    seconds.push_back(*ms / 1e3);
  }
  if (seconds.empty()) {
    throw InputError(fmt::format("{}: no estimate of '{}', expected one of {}", file.string(),
                                 estimator, fmt::join(estimators, ", ")));
  }
  return sampledLatency(fmt::format("{}, measured alone", estimator), std::move(seconds));
}

}  // namespace

LatencyModel constantLatency(double seconds) {
  return {fmt::format("{:g} s, given", seconds), [seconds](double) { return seconds; }};
}

LatencyModel sampledLatency(const std::string& label, std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return {label, [seconds = std::move(seconds)](double share) {
            const auto index =
                static_cast<std::size_t>(share * static_cast<double>(seconds.size()));
            return seconds[std::min(index, seconds.size() - 1)];
          }};
}

LatencyModel summarizedLatency(const std::string& label, const LatencySummary& summary) {
  // The mean of straight lines is that of their ends, by length; the first end is what is left.
  const double above = 0.4 * (summary.p50 + summary.p90) / 2 +
                       0.09 * (summary.p90 + summary.p99) / 2 +
                       0.01 * (summary.p99 + summary.max) / 2;
  const double wanted = summary.mean ? 2 * (*summary.mean - above) / 0.5 - summary.p50
                                     : summary.p50 - (summary.p90 - summary.p50);
  const double low = std::clamp(wanted, 0.0, summary.p50);
  struct Knot {
    double share;
    double seconds;
  };
  std::vector<Knot> knots = {
      {0, low}, {0.5, summary.p50}, {0.9, summary.p90}, {0.99, summary.p99}, {1, summary.max}};
  return {label, [knots = std::move(knots)](double share) {
            std::size_t i = 1;
            while (i + 1 < knots.size() && knots[i].share < share) ++i;
            const Knot& a = knots[i - 1];
            const Knot& b = knots[i];
            return a.seconds + (b.seconds - a.seconds) * (share - a.share) / (b.share - a.share);
          }};
}

LatencyModel measuredLatency(const TimingRow& row) {
  return summarizedLatency("measured", {row.mean_ms / 1e3, row.p50_ms / 1e3, row.p90_ms / 1e3,
                                        row.p99_ms / 1e3, row.max_ms / 1e3});
}

LatencyModel rangedLatency(const std::string& label, double mean_s, double low_s, double high_s) {
  // The mean of share^k is 1 / (k + 1).
  const double power = (high_s - low_s) / (mean_s - low_s) - 1;
  return {label, [=](double share) { return low_s + (high_s - low_s) * std::pow(share, power); }};
}

std::vector<std::string> publishedLatencies() {
  std::vector<std::string> names;
  for (const Published& published : kPublished) names.emplace_back(published.name);
  return names;
}

LatencyModel readLatency(const std::string& text) {
  if (text.starts_with(kPublishedPrefix)) return publishedLatency(text);
  const std::size_t csv = text.rfind(".csv:");
  if (csv != std::string::npos)
    return recordedLatency(text.substr(0, csv + 4), text.substr(csv + 5));
  if (text.find('=') != std::string::npos) return statedLatency(text);
  const auto seconds = numberIn(text);
  if (!seconds || *seconds < 0) {
    refuse(text, fmt::format("expected measured, seconds, mean=...,p50=..., {}NAME or "
                             "FILE.csv:ESTIMATOR",
                             kPublishedPrefix));
  }
  return constantLatency(*seconds);
}

}  // namespace hydrabench
