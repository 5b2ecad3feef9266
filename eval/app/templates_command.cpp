// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/geometry/mesh_io.h"
#include "core/geometry/mesh_topology.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/simulation/shape_family.h"

namespace hydrabench {
namespace {

/// One family stands for its class: the one of which the offices have most (over the seeds 1 to
/// 20). There are as many small bins as large ones; a large one lies between these and water
/// dispensers. On campuses likewise; of hydrants there are as many of each kind, and a wet barrel
/// lies between a dry one and a pillar.
constexpr const char* kFamilies[] = {"table_chair", "couch_2_seats",      "plant_large",
                                     "bin_large",   "hydrant_wet_barrel", "car_estate",
                                     "bench_park"};
constexpr std::size_t kMaxFaces = 3000;
constexpr double kMaxError = 0.01;  // [m] far below what a template is wrong by

/// The nominal shape of a family, which is no instance of any world, in the colours of its parts.
Mesh templateMesh(const ShapeFamily& family) {
  const ShapeInstance instance = family.nominal();
  SurfaceMesh surface = meshInstance(instance);
  surface.mesh.colors.resize(surface.mesh.vertices.size());
  for (std::size_t f = 0; f < surface.mesh.faces.size(); ++f) {
    for (const int vertex : surface.mesh.faces[f]) {
      surface.mesh.colors[static_cast<std::size_t>(vertex)] =
          instance.parts[surface.face_part[f]].material.color;
    }
  }
  return decimated(surface.mesh, kMaxFaces, kMaxError);
}

int runTemplates(const std::filesystem::path& out) {
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) {
    throw OutputError(fmt::format("{}: cannot make the folder: {}", out.string(), error.message()));
  }
  for (const char* name : kFamilies) {
    const ShapeFamily& family = shapeFamily(name);
    const Mesh mesh = templateMesh(family);
    const std::filesystem::path path = out / (family.class_name + ".ply");
    writeMesh(path, mesh);
    const Eigen::Vector3d size = bounds(mesh).sizes();
    fmt::print("wrote {}: {}, {:.2f} x {:.2f} x {:.2f} m, {} faces, {}\n", path.string(), name,
               size.x(), size.y(), size.z(), mesh.faces.size(),
               analyzeTopology(mesh).watertight() ? "closed" : "open");
  }
  return kDone;
}

}  // namespace

Command addTemplates(CLI::App& app) {
  auto out = std::make_shared<std::filesystem::path>();
  app.add_option("--out", *out, "folder to write CLASS.ply to")->required()->type_name("DIR");
  app.footer(
      "The nominal shape of one family per class, decimated: configs/methods/templates/ was made "
      "so.");
  return [out] { return runTemplates(*out); };
}

}  // namespace hydrabench
