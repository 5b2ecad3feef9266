// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "eval/simulation/sdf_operators.h"
#include "eval/simulation/sdf_primitives.h"
#include "eval/simulation/shape_family.h"

namespace hydrabench {

/// Where a family's parameters come from: drawn from their ranges, or each at the middle of its
/// range (the first of a choice).
class Parameters {
 public:
  explicit Parameters(Random random) : random_(random) {}
  static Parameters nominal() { return Parameters(); }

  double range(double low, double high) {
    return random_ ? random_->uniform(low, high) : 0.5 * (low + high);
  }
  int count(int low, int high) {  ///< both ends included
    return random_
               ? low + static_cast<int>(random_->index(static_cast<std::uint32_t>(high - low + 1)))
               : (low + high) / 2;
  }
  bool chance(double probability) {
    return random_ ? random_->chance(probability) : probability > 0.5;
  }
  int choice(int options) {
    return random_ ? static_cast<int>(random_->index(static_cast<std::uint32_t>(options))) : 0;
  }
  Rgb color(std::initializer_list<Rgb> palette) {
    return palette.begin()[choice(static_cast<int>(palette.size()))];
  }

 private:
  Parameters() = default;
  std::optional<Random> random_;
};

/// Entry of the table of families for a function that builds an instance.
template <ShapeInstance (*kBuild)(Parameters&)>
ShapeFamily makeFamily(std::string name, std::string class_name) {
  return {std::move(name), std::move(class_name),
          [](Random random) {
            Parameters parameters(random);
            return kBuild(parameters);
          },
          [] {
            Parameters parameters = Parameters::nominal();
            return kBuild(parameters);
          }};
}

/// Collects the parts of an instance.
class InstanceBuilder {
 public:
  explicit InstanceBuilder(std::string family) : family_(std::move(family)) {}
  void add(SdfPtr sdf, const Material& material) { parts_.push_back({std::move(sdf), material}); }
  void add(std::vector<SdfPtr> pieces, const Material& material) {
    add(unite(std::move(pieces)), material);
  }
  /// @param thinnest_m  smallest thickness of any part
  ShapeInstance finish(double thinnest_m, int yaw_symmetry = 1);

 private:
  std::string family_;
  std::vector<ShapePart> parts_;
};

/// Common surfaces.
Material plain(Rgb color, double gloss = 0);
Material metal(Parameters& parameters);   ///< chrome, aluminium or black lacquer
Material wood(Parameters& parameters);    ///< light, middle or dark
Material fabric(Parameters& parameters);  ///< upholstery
Material blackPlastic();
Rgb darker(Rgb color, double factor);

/// The families of each class, one source file each.
std::vector<ShapeFamily> chairFamilies();
std::vector<ShapeFamily> couchFamilies();
std::vector<ShapeFamily> plantFamilies();
std::vector<ShapeFamily> binFamilies();
std::vector<ShapeFamily> computerFamilies();
std::vector<ShapeFamily> furnitureFamilies();
std::vector<ShapeFamily> hydrantFamilies();
std::vector<ShapeFamily> carFamilies();
std::vector<ShapeFamily> benchFamilies();
std::vector<ShapeFamily> treeFamilies();
std::vector<ShapeFamily> streetFamilies();  ///< lamp posts, bollards, signs

}  // namespace hydrabench
