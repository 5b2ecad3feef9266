// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/crisp_manifest.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

TEST(CrispManifest, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  CrispManifest manifest;
  manifest.preset = "small";
  manifest.mode = "normalised";
  manifest.input_normalisation = "none";
  manifest.crop = "none";
  manifest.cube_half_side = 1.125;
  manifest.sdf_layers = 4;
  manifest.sdf_width = 128;
  manifest.weights = "small.safetensors";
  manifest.source = "trained on: \"generated\" rooms";
  manifest.licence = "MIT";
  writeText(folder / "manifest.yaml", toYaml(manifest));

  const CrispManifest read = readCrispManifest(folder / "manifest.yaml");
  EXPECT_EQ(read.weights, folder / "small.safetensors");
  EXPECT_EQ(read.source, manifest.source);
  EXPECT_FALSE(read.isMetric());
  CrispManifest moved = read;
  moved.weights = manifest.weights;
  EXPECT_EQ(toYaml(moved), toYaml(manifest));
}

TEST(CrispManifest, GuessesNothing) {
  const TemporaryFolder folder;
  writeText(folder / "manifest.yaml", "preset: full\nmode: metrical\nlayers: 5\n");
  const std::string message =
      messageOf<InputError>([&] { readCrispManifest(folder / "manifest.yaml"); });
  EXPECT_THAT(message, HasSubstr("manifest.yaml:2: mode: 'metrical' is unknown"));
  EXPECT_THAT(message, HasSubstr("cube_half_side: missing, must be given"));
  EXPECT_THAT(message, HasSubstr("input_normalisation: missing, must be given"));
  EXPECT_THAT(message, HasSubstr("layers"));
}

}  // namespace
}  // namespace hydrabench
