// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp and its tests only.
#pragma once

#include <memory>
#include <string>

#include "core/shape/crisp/crisp_model.h"
#include "core/shape/crisp/crisp_network.h"

namespace hydrabench {

/// A published network of any size, with the weights it has.
std::unique_ptr<const CrispModel> makeFullCrisp(CrispNetwork network, const CrispManifest& manifest,
                                                const std::string& device);

}  // namespace hydrabench
