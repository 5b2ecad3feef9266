// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp, of the trainers and of tests only.
#pragma once

#include <memory>
#include <string>

#include "core/shape/crisp/crisp_manifest.h"
#include "core/shape/crisp/crisp_model.h"
#include "core/shape/crisp/point_network.h"

namespace hydrabench {

/// The network of a small model with its weights. Throws InputError naming the file.
PointNetwork loadPointNetwork(const CrispManifest& manifest);

/// A small network with the weights it has.
std::unique_ptr<const CrispModel> makeSmallCrisp(PointNetwork network,
                                                 const CrispManifest& manifest,
                                                 const std::string& device);

}  // namespace hydrabench
