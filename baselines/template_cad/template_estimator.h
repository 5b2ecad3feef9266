// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "baselines/template_cad/template_cad.h"
#include "core/shape/shape_estimator.h"

namespace hydrabench {

/// The CAD model of a class, put where one view shows an object, by TemplateCad's rules: what a
/// shape estimator has to be better than. All points of the mask count but for the nearest and the
/// farthest; TemplateCad sees an object many times and takes a thin slice of each view.
/// Stages: measure, place.
class TemplateEstimator : public ShapeEstimator {
 public:
  struct Config {
    double trim = 0.05;  ///< share of the points that is left out at either end of their depths
    PlacementConfig placement;
    std::vector<TemplateCad::ClassRules> templates;  ///< a class without one gets no shape
  };
  /// Throws InputError where a template cannot be read.
  TemplateEstimator(const Config& config, const LabelSpace& label_space);

  ShapeOutcome estimate(const ShapeObservation& best, std::span<const ShapeObservation> others,
                        std::uint64_t seed) const override;

 private:
  struct Template {
    TemplateCad::ClassRules rules;
    TemplateModel model;
  };
  Config config_;
  std::map<Label, Template> templates_;
};

void read(ConfigReader& reader, TemplateEstimator::Config& config);

}  // namespace hydrabench
