// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "eval/claims/verdict.h"

namespace hydrabench {

std::string claimsText(const std::vector<JudgedClaim>& claims);      ///< for the terminal
std::string claimsMarkdown(const std::vector<JudgedClaim>& claims);  ///< a row per finding
std::string claimsJson(const std::vector<JudgedClaim>& claims);

}  // namespace hydrabench
