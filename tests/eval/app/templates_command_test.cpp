// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/geometry/mesh_io.h"
#include "core/geometry/mesh_topology.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

const std::string kNames[] = {"chair.ply",        "couch.ply", "plant.ply", "bin.ply",
                              "fire_hydrant.ply", "car.ply",   "bench.ply"};

TEST(Templates, TheOnesThatComeWithTheProgramAreWhatTheCommandMakes) {
  const TemporaryFolder folder;
  const std::string line = fmt::format("'{}' templates --out '{}' >/dev/null", HYDRABENCH_COMMAND,
                                       (folder / "made").string());
  ASSERT_EQ(std::system(line.c_str()), 0);
  const std::filesystem::path kept =
      std::filesystem::path(HYDRABENCH_SOURCE_DIR) / "configs/methods/templates";
  for (const std::string& name : kNames) {
    const Mesh made = readMesh(folder / "made" / name);
    const Mesh committed = readMesh(kept / name);
    EXPECT_EQ(made.faces, committed.faces) << name;
    ASSERT_EQ(made.vertices.size(), committed.vertices.size()) << name;
    for (std::size_t i = 0; i < made.vertices.size(); ++i) {
      // Mathematical libraries differ in the last bit.
      ASSERT_NEAR((made.vertices[i] - committed.vertices[i]).norm(), 0, 1e-6) << name;
    }
    EXPECT_LT(std::filesystem::file_size(kept / name), 150'000u) << name;
  }
}

TEST(Templates, AreClosedAndStandOnTheFloorAroundTheOrigin) {
  for (const std::string& name : kNames) {
    const Mesh mesh =
        readMesh(std::filesystem::path(HYDRABENCH_SOURCE_DIR) / "configs/methods/templates" / name);
    EXPECT_TRUE(analyzeTopology(mesh).watertight()) << name;
    EXPECT_NEAR(bounds(mesh).min().z(), 0, 0.01) << name;
    EXPECT_NEAR(bounds(mesh).center().head<2>().norm(), 0, 0.05) << name;
  }
}

}  // namespace
}  // namespace hydrabench
