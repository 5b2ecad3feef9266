// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hydrabench {

/// The path of a program, looked up in PATH as a shell does; empty where there is none.
std::string findProgram(const std::string& name);

}  // namespace hydrabench
