// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/shape/crisp/shape_refinement.h"
#include "core/shape/nocs_pose.h"
#include "core/shape/sdf_mesher.h"
#include "core/shape/shape_estimator.h"

namespace hydrabench {

/// What a network says about a view: where points of it lie on the object, and the object's shape.
struct CrispPrediction {
  std::vector<Eigen::Vector3d> nocs;    ///< object coordinates
  std::vector<Eigen::Vector3d> points;  ///< the same points in the camera frame [m]
  SdfField field;                       ///< in object coordinates
  std::vector<float> code = {};         ///< what `field` was made from; empty where it is not told
};

/// The network of one preset with its weights; CrispEstimator does the rest.
class CrispModel {
 public:
  virtual ~CrispModel() = default;
  /// Thread-safe and a function of its arguments. The view has a valid camera, a mask with depth in
  /// it and, where needsColor(), colour. Values are as the network puts them out: unchecked.
  virtual CrispPrediction predict(const ShapeObservation& view, std::uint64_t seed) const = 0;
  virtual NocsFreedom freedom() const = 0;
  virtual double cubeHalfSide() const = 0;  ///< of the cube that holds all shapes, object units
  virtual bool needsColor() const = 0;

  /// Refines pose and code (shape_refinement.h) and makes `field` anew. Nothing where the model
  /// cannot.
  virtual void refine(const ShapeRefinementConfig& /*config*/, const ShapeObservation& /*best*/,
                      std::span<const ShapeObservation> /*others*/, std::uint64_t /*seed*/,
                      Similarity& /*camera_from_object*/, CrispPrediction& /*prediction*/) const {}
};

/// @param manifest  a manifest, or a folder with a manifest.yaml in it
/// @param device    cpu | cuda
/// Throws InputError for what is wrong with manifest, weights or device.
std::unique_ptr<const CrispModel> loadCrispModel(const std::filesystem::path& manifest,
                                                 const std::string& device);

}  // namespace hydrabench
