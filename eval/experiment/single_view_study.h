// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/experiment/estimator_table.h"
#include "eval/experiment/experiment_config.h"
#include "metrics/bootstrap.h"

namespace hydrabench {

/// How good a shape estimator is by itself: every object once, from one view, against its true
/// mesh. No tracking, no check, no matching: association is known.
///
///     name: held_out_views
///     datasets: [{config: ../datasets/office.yaml, seeds: [1, 2]}]
///     estimators:
///       - {name: crisp_small, type: crisp, model: ../models/crisp_indoor, trained_on: [chair]}
///     views: {choose: largest_box, masks: true}
struct SingleViewStudy {
  struct Estimator {
    std::string name;
    EstimatorStart start;
    std::vector<std::string> trained_on = {};  ///< classes; empty: not told
  };
  struct Views {
    /// largest_box: of each object the view with the largest box around its points, as the pipeline
    /// chooses (paper, eq. 2). random: any view.
    std::string choose = "largest_box";
    /// true: exact masks. given: the instance of the frame that covers the object best.
    std::string masks = "true";
    int frame_step = 3;    ///< every n-th frame is looked at
    int min_pixels = 200;  ///< of the mask with a measured depth within max_range_m
    double max_range_m = 5;
  } views;
  std::string name;
  std::vector<ExperimentConfig::DatasetEntry> datasets;
  std::vector<Estimator> estimators;
  EvaluationConfig evaluation;
  std::uint64_t seed = 1;
  std::string resolved_config;
};

/// Throws InputError. @param overrides  key=value, "dataset.KEY=VALUE" for every dataset
SingleViewStudy readSingleViewStudy(const std::filesystem::path& config,
                                    const std::vector<std::string>& overrides = {});

/// An object as one estimator saw it; a line of views.csv.
struct SingleViewRow {
  std::string dataset;
  std::string world_seed;
  std::string estimator;
  std::string object;
  std::string class_name;
  std::optional<bool> in_domain;  ///< of a class that the estimator was trained on; where told
  std::string subtype;
  std::int64_t stamp_ns = 0;
  int pixels = 0;
  double distance_m = 0;     ///< from the camera to the centre of the object's box
  bool cut = false;          ///< the mask reaches the border of the image
  double seen_fraction = 0;  ///< of the object's surface, in this view
  std::string failure;       ///< of the estimator; empty with an estimate
  std::optional<double> chamfer_l1_m;
  std::optional<double> center_error_m;
  std::optional<double> v_iou;
  std::optional<double> b_iou;
  std::optional<double> inlier_ratio;
  std::map<std::string, double> wall_ms;  ///< per stage, and "total"; empty: never asked

  /// No estimate, or one that is plainly wrong: chamfer_l1 above 15 cm or v_iou below 0.1.
  bool failed() const;
};

inline constexpr const char* kAllClasses = "all";
inline constexpr const char* kInDomain = "in_domain";         ///< classes trained on, together
inline constexpr const char* kOutOfDomain = "out_of_domain";  ///< the others

/// Medians over objects (failures without an estimate count as infinitely bad), with 95 % bootstrap
/// intervals.
struct SingleViewSummary {
  struct Median {
    double value = 0;
    Interval interval;
  };
  std::string dataset;
  std::string estimator;
  std::string class_name;  ///< or one of the three above
  std::size_t objects = 0;
  Median chamfer_l1_m, center_error_m, v_iou, b_iou;
  Median failure_share;          ///< a mean, not a median
  std::optional<double> p50_ms;  ///< of the calls that gave a shape
  std::optional<double> p99_ms;
};
/// Per dataset and estimator, in order of appearance: all classes, those in and out of its domain
/// where it is told, each.
std::vector<SingleViewSummary> summarize(const std::vector<SingleViewRow>& rows,
                                         const BootstrapConfig& bootstrap);

/// An estimator that cannot be started fails on every object and says why; throws InputError where
/// none can. Each answers once before it is timed.
/// @param on_world  called with dataset and seed before each world
std::vector<SingleViewRow> runSingleViewStudy(
    const SingleViewStudy& study,
    const std::function<void(const std::string&, const std::string&)>& on_world);

std::string viewsCsv(const std::vector<SingleViewRow>& rows);
std::string summaryCsv(const std::vector<SingleViewSummary>& summaries);
std::string summaryTable(const std::vector<SingleViewSummary>& summaries);

}  // namespace hydrabench
