// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace hydrabench {

/// What an independent implementation in Python says. Debian's interpreter, because its packages
/// (python3-scipy, python3-open3d) are not those of another python3 on the PATH; HYDRABENCH_PYTHON
/// names a different one.
struct OracleAnswer {
  std::optional<std::string> output;  ///< standard output of the script
  std::string warnings;               ///< standard error of the script
  std::string reason;                 ///< why there is no output: a module is absent
};

/// Runs `script` with `input` on its standard input, in an empty folder. A script that fails
/// although all modules are there fails the test.
inline OracleAnswer askPython(std::initializer_list<std::string_view> modules,
                              std::string_view script, std::string_view input) {
  const char* chosen = std::getenv("HYDRABENCH_PYTHON");
  const std::string python = chosen ? chosen : "/usr/bin/python3";
  for (const std::string_view module : modules) {
    const std::string probe = fmt::format("'{}' -c 'import {}' >/dev/null 2>&1", python, module);
    if (std::system(probe.c_str()) != 0) {
      return {std::nullopt, "", fmt::format("{} cannot import {}", python, module)};
    }
  }
  std::string name = (std::filesystem::temp_directory_path() / "hydrabench_oracle_XXXXXX").string();
  if (!::mkdtemp(name.data())) return {std::nullopt, "", "there is no temporary folder"};
  const std::filesystem::path folder = name;
  writeText(folder / "script.py", script);
  writeText(folder / "input.txt", input);
  const std::string command =
      fmt::format("cd '{}' && '{}' script.py <input.txt >output.txt 2>warnings.txt", name, python);
  const int status = std::system(command.c_str());
  OracleAnswer answer{readText(folder / "output.txt"), readText(folder / "warnings.txt"), ""};
  std::filesystem::remove_all(folder);
  if (status != 0) ADD_FAILURE() << "the oracle script fails: " << answer.warnings;
  return answer;
}

}  // namespace hydrabench
