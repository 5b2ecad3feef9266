// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/graph/candidate_io.h"

#include <filesystem>
#include <numbers>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spark_dsg_json.h"
#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

/// With numbers that have no short text.
ShapeCandidate accepted() {
  ShapeCandidate candidate;
  candidate.track = 12;
  candidate.label = 5;
  candidate.first_observed_ns = 1'000'000'000'123'456'789;
  candidate.last_observed_ns = 1'000'000'009'123'456'789;
  candidate.observations = 34;
  candidate.view_stamp_ns = 1'000'000'004'000'000'001;
  candidate.camera = {720, 480, 415.7, 1e2 / 3, 360, 240.1};
  candidate.T_world_camera.linear() =
      Eigen::AngleAxisd(std::numbers::pi / 7, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  candidate.T_world_camera.translation() = Eigen::Vector3d(1.0 / 3, -2.0 / 7, 1e-17);
  candidate.view_volume_m3 = 0.1 + 0.2;
  candidate.mask_u = 100;
  candidate.mask_v = 50;
  candidate.mask = Image<std::uint8_t>(5, 3);
  for (const std::size_t i : {0u, 1u, 4u, 7u, 14u}) candidate.mask.data()[i] = 1;
  candidate.T_world_object = candidate.T_world_camera.inverse();
  candidate.scale = std::numbers::e;
  candidate.mesh = sphereMesh({1, 2, 3}, 0.1 * std::numbers::pi, 1);
  roundToFloat(candidate.mesh);
  candidate.box = bounds(candidate.mesh);
  candidate.inlier_ratio = 2.0 / 3;
  candidate.overlap = 0.21000000000000002;
  candidate.coverage = 5.0 / 7;
  candidate.depth_residual_m = 1.0 / 30;
  candidate.accepted = true;
  candidate.object = objectNodeId(3);
  return candidate;
}

ShapeCandidate failed() {
  ShapeCandidate candidate;
  candidate.track = 13;
  candidate.failure = "too few points";
  candidate.reason = "failure: too few points";
  candidate.partial_mesh = boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0.5, 0.25)));
  candidate.partial_mesh.colors.assign(8, Rgb{1, 2, 3});
  return candidate;
}

void expectEqual(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.colors, b.colors);
}

void expectEqual(const ShapeCandidate& a, const ShapeCandidate& b) {
  EXPECT_EQ(a.track, b.track);
  EXPECT_EQ(a.label, b.label);
  EXPECT_EQ(a.first_observed_ns, b.first_observed_ns);
  EXPECT_EQ(a.last_observed_ns, b.last_observed_ns);
  EXPECT_EQ(a.observations, b.observations);
  EXPECT_EQ(a.view_stamp_ns, b.view_stamp_ns);
  EXPECT_EQ(a.camera, b.camera);
  EXPECT_EQ(a.T_world_camera.matrix(), b.T_world_camera.matrix());
  EXPECT_EQ(a.view_volume_m3, b.view_volume_m3);
  EXPECT_EQ(a.mask_u, b.mask_u);
  EXPECT_EQ(a.mask_v, b.mask_v);
  EXPECT_EQ(a.mask, b.mask);
  EXPECT_EQ(a.failure, b.failure);
  EXPECT_EQ(a.T_world_object.matrix(), b.T_world_object.matrix());
  EXPECT_EQ(a.scale, b.scale);
  expectEqual(a.mesh, b.mesh);
  EXPECT_EQ(a.box.min(), b.box.min());
  EXPECT_EQ(a.box.max(), b.box.max());
  EXPECT_EQ(a.inlier_ratio, b.inlier_ratio);
  EXPECT_EQ(a.overlap, b.overlap);
  EXPECT_EQ(a.coverage, b.coverage);
  EXPECT_EQ(a.depth_residual_m, b.depth_residual_m);
  expectEqual(a.partial_mesh, b.partial_mesh);
  EXPECT_EQ(a.accepted, b.accepted);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.object, b.object);
}

TEST(Candidates, ReadBackBitForBit) {
  const TemporaryFolder folder;
  writeCandidates(folder.path(), {accepted(), failed()});
  const auto read = readCandidates(folder.path());
  ASSERT_EQ(read.size(), 2u);
  expectEqual(read[0], accepted());
  expectEqual(read[1], failed());
}

TEST(Candidates, ArePartOfAPrediction) {
  const TemporaryFolder folder;
  Prediction prediction;
  prediction.method = "hydra_plus_plus";
  writePrediction(folder / "none", prediction);
  EXPECT_FALSE(std::filesystem::exists(folder / "none/candidates.jsonl"));
  EXPECT_TRUE(readPrediction(folder / "none").candidates.empty());
  prediction.candidates = {accepted(), failed()};
  writePrediction(folder / "two", prediction);
  const Prediction read = readPrediction(folder / "two");
  ASSERT_EQ(read.candidates.size(), 2u);
  expectEqual(read.candidates[0], accepted());
}

TEST(Candidates, MasksOfAnyPatternReadBack) {
  const TemporaryFolder folder;
  for (int pattern = 0; pattern < 64; ++pattern) {
    ShapeCandidate candidate = failed();
    candidate.camera = {720, 480, 1, 1, 0, 0};
    candidate.mask = Image<std::uint8_t>(3, 2);
    for (int i = 0; i < 6; ++i) {
      candidate.mask.data()[i] = static_cast<std::uint8_t>(pattern >> i & 1);
    }
    writeCandidates(folder.path(), {candidate});
    EXPECT_EQ(readCandidates(folder.path())[0].mask, candidate.mask) << pattern;
  }
}

TEST(Candidates, FaultsAreNamedByLineAndField) {
  const TemporaryFolder folder;
  writeCandidates(folder.path(), {failed(), accepted()});
  const std::string good = readText(folder / "candidates.jsonl");
  const auto message = [&](const std::string& from, const std::string& to) {
    writeText(folder / "candidates.jsonl", std::regex_replace(good, std::regex(from), to));
    return messageOf<InputError>([&] { readCandidates(folder.path()); });
  };
  EXPECT_THAT(message("\"track\":12", "\"track\":-1"),
              HasSubstr("candidates.jsonl:2: track: expected an integer from 0 on, found -1"));
  EXPECT_THAT(message("\"overlap\":[0-9.]*,", ""),
              HasSubstr("candidates.jsonl:2: overlap: missing"));
  EXPECT_THAT(message("\"u\":100", "\"u\":716"),
              HasSubstr("candidates.jsonl:2: mask: reaches beyond the camera's image"));
  EXPECT_THAT(message("\"runs\":\\[0,2", "\"runs\":[0,3"),
              HasSubstr("mask.runs: the runs do not add up to the mask's pixels"));
  EXPECT_THAT(message("track_000012", "track_000099"), HasSubstr("track_000099.ply"));
  EXPECT_THAT(message("\\{\"track\":12", "{track:12"),
              HasSubstr("candidates.jsonl:2: is not JSON, expected one object per line"));
}

}  // namespace
}  // namespace hydrabench
