// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/mesh_topology.h"
#include "core/parallel/parallel_for.h"
#include "eval/simulation/sdf_primitives.h"
#include "eval/simulation/shape_family.h"
#include "eval/simulation/surface_mesher.h"
#include "eval/simulation/surface_simplifier.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

struct Sample {
  std::string name;
  ShapeInstance instance;
  SurfaceMesh surface;
};

#ifdef NDEBUG
constexpr std::size_t kInstances = 2;  // a drawn one and the nominal one
#else
constexpr std::size_t kInstances = 1;  // unoptimised and sanitized builds are slow
#endif

/// Instances of every family, meshed once for all tests.
const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = [] {
    const std::vector<ShapeFamily>& families = shapeFamilies();
    std::vector<Sample> made(kInstances * families.size());
    parallelFor(made.size(), [&](std::size_t i) {
      const ShapeFamily& family = families[i / kInstances];
      made[i].name = family.name;
      made[i].instance =
          i % kInstances == 1
              ? family.nominal()
              : family.draw(Random(instanceSeed(InstanceSplit::kEvaluation, 100 + i)));
      made[i].surface = meshInstance(made[i].instance);
    });
    return made;
  }();
  return all;
}

/// The grid of a car or a tree is coarser than that of furniture, and so is its mesh.
double coarseness(const ShapeInstance& instance) {
  return instance.max_pitch_m / ShapeInstance{}.max_pitch_m;
}

/// What stands on the ground: crowns and arms reach out to any side.
Aabb footOf(const Mesh& mesh) {
  Aabb box;
  for (const Vector3d& vertex : mesh.vertices) {
    if (vertex.z() < 0.05) box.extend(vertex);
  }
  return box;
}

TEST(MeshInstance, IsWatertightAndInOnePiece) {
  for (const Sample& sample : samples()) {
    const MeshTopology topology = analyzeTopology(sample.surface.mesh);
    EXPECT_TRUE(topology.watertight()) << sample.name;
    EXPECT_EQ(topology.components, 1u) << sample.name;
    EXPECT_GT(signedVolume(sample.surface.mesh), 0) << sample.name;
  }
}

TEST(MeshInstance, LeavesOutNothingButVoidsAndCrumbs) {
  for (std::size_t i = 0; i < samples().size(); i += kInstances) {  // the drawn ones
    const Sample& sample = samples()[i];
    const double pitch =
        std::clamp(0.45 * sample.instance.thinnest_m, 0.006, sample.instance.max_pitch_m);
    const SurfaceMesh everything = extractSurface(sample.instance.parts, pitch);
    for (const Mesh& piece : connectedComponents(everything.mesh)) {
      if (bounds(piece).diagonal().norm() < 0.03) continue;  // a crumb
      const bool is_void = signedVolume(piece) < 0;
      const bool is_object = signedVolume(piece) > 0.9 * signedVolume(sample.surface.mesh);
      EXPECT_TRUE(is_void || is_object) << sample.name << ": a piece floats";
    }
  }
}

TEST(MeshInstance, HasItsVerticesOnTheZeroSet) {
  for (const Sample& sample : samples()) {
    std::size_t off = 0;
    for (const Vector3d& vertex : sample.surface.mesh.vertices) {
      const double distance = std::abs(sample.instance.sdf->value(vertex));
      off += distance > 1e-4 * coarseness(sample.instance);
      ASSERT_LE(distance, 1.5e-3) << sample.name;  // the thickness of a pane on a car
    }
    // Coarse cells can hold the whole edge of a pane.
    const bool coarse = coarseness(sample.instance) > 1;
    EXPECT_LE(off, coarse ? sample.surface.mesh.vertices.size() / 500 : 0) << sample.name;
  }
}

TEST(MeshInstance, HasItsFacesNearTheZeroSet) {
  for (const Sample& sample : samples()) {
    double sum = 0;
    double area = 0;
    for (const Eigen::Vector3i& face : sample.surface.mesh.faces) {
      const auto vertex = [&](int k) -> const Vector3d& {
        return sample.surface.mesh.vertices[static_cast<std::size_t>(face[k])];
      };
      const double size = (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)).norm();
      const double off =
          std::abs(sample.instance.sdf->value((vertex(0) + vertex(1) + vertex(2)) / 3));
      EXPECT_LE(off, 0.015 * coarseness(sample.instance)) << sample.name;
      sum += size * off;
      area += size;
    }
    EXPECT_LE(sum / area, 1e-3 * coarseness(sample.instance)) << sample.name;
  }
}

TEST(MeshInstance, IsSmallAndFloatExactAndKnowsItsParts) {
  for (const Sample& sample : samples()) {
    EXPECT_LE(sample.surface.mesh.faces.size(), 12000u) << sample.name;
    EXPECT_GE(sample.surface.mesh.faces.size(), 300u) << sample.name;
    for (const Vector3d& vertex : sample.surface.mesh.vertices) {
      ASSERT_EQ(vertex, vertex.cast<float>().cast<double>()) << sample.name;
    }
    ASSERT_EQ(sample.surface.face_part.size(), sample.surface.mesh.faces.size());
    for (std::uint16_t part : sample.surface.face_part) {
      ASSERT_LT(part, sample.instance.parts.size()) << sample.name;
    }
  }
}

struct SizeRange {
  Vector3d low;
  Vector3d high;
};

TEST(MeshInstance, HasTheSizeOfItsClass) {
  const std::map<std::string, SizeRange> ranges = {
      {"office_chair_arms", {{0.55, 0.55, 0.95}, {0.82, 0.80, 1.40}}},
      {"office_chair", {{0.55, 0.55, 0.80}, {0.80, 0.80, 1.25}}},
      {"table_chair", {{0.40, 0.38, 0.75}, {0.70, 0.56, 1.02}}},
      {"couch_1_seat", {{0.75, 0.70, 0.70}, {1.02, 1.20, 1.02}}},
      {"couch_2_seats", {{0.75, 1.20, 0.70}, {1.02, 1.90, 1.02}}},
      {"couch_3_seats", {{0.75, 1.80, 0.70}, {1.02, 2.60, 1.02}}},
      {"plant_large", {{0.40, 0.40, 0.95}, {1.50, 1.50, 1.90}}},
      {"plant_small", {{0.14, 0.14, 0.24}, {0.60, 0.60, 0.65}}},
      {"bin_small", {{0.15, 0.20, 0.25}, {0.36, 0.36, 0.43}}},
      {"bin_large", {{0.26, 0.28, 0.55}, {0.56, 0.50, 0.90}}},
      {"water_dispenser", {{0.29, 0.27, 1.20}, {0.42, 0.36, 1.50}}},
      {"monitor", {{0.12, 0.47, 0.28}, {0.32, 0.76, 0.66}}},
      {"laptop", {{0.20, 0.29, 0.17}, {0.45, 0.40, 0.30}}},
      {"desktop_tower", {{0.35, 0.16, 0.34}, {0.52, 0.24, 0.50}}},
      {"keyboard", {{0.11, 0.27, 0.015}, {0.18, 0.48, 0.05}}},
      {"all_in_one", {{0.12, 0.50, 0.40}, {0.32, 0.68, 0.62}}},
      {"printer", {{0.38, 0.38, 0.22}, {0.60, 0.52, 0.42}}},
      {"desk", {{0.60, 1.15, 0.70}, {0.90, 1.75, 0.78}}},
      {"table_rectangular", {{0.70, 1.00, 0.70}, {1.25, 2.70, 0.78}}},
      {"table_round", {{0.80, 0.80, 0.70}, {1.35, 1.35, 0.78}}},
      {"coffee_table", {{0.45, 0.75, 0.34}, {0.65, 1.20, 0.48}}},
      {"shelf", {{0.26, 0.70, 1.15}, {0.40, 1.10, 2.05}}},
      {"cabinet", {{0.38, 0.38, 0.68}, {0.70, 1.05, 1.95}}},
      {"cubicle_partition", {{0.35, 1.15, 1.10}, {0.45, 1.65, 1.65}}},
      {"whiteboard", {{0.50, 1.15, 1.60}, {0.60, 1.85, 2.05}}},
      {"hydrant_dry_barrel", {{0.33, 0.34, 0.67}, {0.47, 0.52, 1.01}}},
      {"hydrant_wet_barrel", {{0.32, 0.29, 0.71}, {0.44, 0.49, 0.97}}},
      {"hydrant_pillar", {{0.25, 0.25, 0.77}, {0.41, 0.45, 1.11}}},
      {"car_hatchback", {{3.55, 2.00, 1.40}, {4.34, 2.18, 1.56}}},
      {"car_sedan", {{4.28, 2.10, 1.38}, {5.00, 2.26, 1.50}}},
      {"car_estate", {{4.35, 2.10, 1.42}, {4.97, 2.26, 1.60}}},
      {"car_van", {{4.28, 2.16, 1.81}, {5.27, 2.36, 2.07}}},
      {"car_pickup", {{4.88, 2.18, 1.71}, {5.34, 2.36, 1.87}}},
      {"bench_park", {{0.52, 1.24, 0.77}, {0.95, 1.96, 0.96}}},
      {"bench_slab", {{0.37, 1.19, 0.40}, {0.57, 2.21, 0.49}}},
      {"bench_picnic", {{1.40, 1.44, 0.70}, {1.80, 1.96, 0.78}}},
      {"tree_broadleaf", {{1.50, 1.50, 4.00}, {4.60, 4.60, 6.90}}},
      {"tree_conifer", {{1.40, 1.40, 3.70}, {5.00, 5.00, 7.30}}},
      {"lamp_pole", {{0.26, 0.26, 3.15}, {2.30, 0.54, 6.65}}},
      {"bollard", {{0.14, 0.14, 0.71}, {0.37, 0.37, 1.11}}},
      {"sign_post", {{0.11, 0.45, 2.28}, {0.17, 0.77, 3.02}}}};
  for (const Sample& sample : samples()) {
    ASSERT_TRUE(ranges.contains(sample.name)) << sample.name << " has no range in this test";
    const SizeRange& range = ranges.at(sample.name);
    const Aabb box = bounds(sample.surface.mesh);
    EXPECT_TRUE((box.sizes().array() >= range.low.array()).all() &&
                (box.sizes().array() <= range.high.array()).all())
        << sample.name << " measures " << box.sizes().transpose();
    EXPECT_NEAR(box.min().z(), 0, 0.003) << sample.name << " does not stand on the floor";
    EXPECT_LE(footOf(sample.surface.mesh).center().head<2>().norm(), 0.12)
        << sample.name << " is off its origin";
  }
}

/// Random signs at a grid's corners: every ambiguous case occurs, next to every other.
class NoiseSdf final : public Sdf {
 public:
  explicit NoiseSdf(std::uint64_t seed) : seed_(seed) {}
  double value(const Vector3d& p) const override {
    const Eigen::Array3d cell = (p / kCell).array().round();
    const std::uint64_t hash = hashSeed(
        seed_,
        static_cast<std::uint64_t>((cell.x() + 50) * 1e6 + (cell.y() + 50) * 1e3 + cell.z() + 50));
    const double noise = (hash & 1) != 0 ? 0.01 : -0.01;
    const double outside = p.cwiseAbs().maxCoeff() - 0.8;
    return std::max(noise, outside);
  }
  Aabb bounds() const override { return {Vector3d::Constant(-1), Vector3d::Constant(1)}; }

 private:
  static constexpr double kCell = 0.1;
  std::uint64_t seed_;
};

TEST(ExtractSurface, IsAClosedManifoldForAnySigns) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const SurfaceMesh surface = extractSurface({{std::make_shared<NoiseSdf>(seed), {}}}, 0.1);
    ASSERT_GT(surface.mesh.faces.size(), 1000u);
    std::map<std::pair<int, int>, int> directed;
    for (const Eigen::Vector3i& face : surface.mesh.faces) {
      for (int k = 0; k < 3; ++k) ++directed[{face[k], face[(k + 1) % 3]}];
    }
    for (const auto& [edge, count] : directed) {
      ASSERT_EQ(count, 1);
      ASSERT_TRUE(directed.contains({edge.second, edge.first}));
    }
  }
}

TEST(ExtractSurface, MeasuresASphere) {
  const SurfaceMesh surface = extractSurface({{sphere({0.1, 0.2, 0.3}, 0.5), {}}}, 0.02);
  EXPECT_NEAR(signedVolume(surface.mesh), 4.0 / 3.0 * 3.14159265 * 0.125, 1e-3);
  for (const Vector3d& vertex : surface.mesh.vertices) {
    EXPECT_NEAR((vertex - Vector3d(0.1, 0.2, 0.3)).norm(), 0.5,
                2.1e-5);  // a thousandth of the pitch
  }
}

TEST(ExtractSurface, CutsFacesAlongTheBorderOfParts) {
  // Two half boxes of equal cross-section that meet at x = 0.0137, off the grid.
  const SurfaceMesh surface = extractSurface({{roundedBox({-0.4863, 0, 0}, {1, 0.5, 0.5}, 0.1), {}},
                                              {roundedBox({0.4137, 0, 0}, {1, 0.5, 0.5}, 0.1), {}}},
                                             0.05);
  for (std::size_t f = 0; f < surface.mesh.faces.size(); ++f) {
    Vector3d center = Vector3d::Zero();
    for (int id : surface.mesh.faces[f])
      center += surface.mesh.vertices[static_cast<std::size_t>(id)] / 3;
    if (std::abs(center.x() + 0.0363) < 0.002) continue;
    EXPECT_EQ(surface.face_part[f], center.x() < -0.0363 ? 0 : 1);
  }
}

TEST(SimplifySurface, NeedsFewFacesForABox) {
  const SurfaceMesh fine = extractSurface({{roundedBox({0, 0, 0}, {1, 0.8, 0.6}, 0.05), {}}}, 0.02);
  const SurfaceMesh coarse = simplifySurface(fine, 1e-3, 100000);
  EXPECT_LT(coarse.mesh.faces.size(), fine.mesh.faces.size() / 10);
  EXPECT_TRUE(analyzeTopology(coarse.mesh).watertight());
  EXPECT_NEAR(signedVolume(coarse.mesh), signedVolume(fine.mesh), 2e-3);
}

}  // namespace
}  // namespace hydrabench
