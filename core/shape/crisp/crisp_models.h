// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/shape/crisp/crisp_manifest.h"
#include "core/shape/crisp/crisp_model.h"

namespace hydrabench {

// One per preset of a manifest. Throws InputError where weights are missing or do not fit.

/// The published network: colours in, depth for the pose only.
std::unique_ptr<const CrispModel> loadFullCrisp(const CrispManifest& manifest,
                                                const std::string& device);
/// The network of this project: geometry in, see point_network.h.
std::unique_ptr<const CrispModel> loadSmallCrisp(const CrispManifest& manifest,
                                                 const std::string& device);
/// The published network at its full size with weights drawn at random, for measuring time: says
/// nothing of use.
std::unique_ptr<const CrispModel> randomFullCrisp(std::uint64_t seed);

}  // namespace hydrabench
