// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hydrabench {

struct HtmlReportOptions {
  std::filesystem::path claims;  ///< judged by the result (eval/claims/claim.h); empty: none
  double max_mb = 30;  ///< of the file, 10^6 bytes; scenes are coarsened and left out to keep it
  /// Called with every step that is done, for a progress display.
  std::function<void(std::size_t done, std::size_t total)> on_step;
};

struct HtmlReport {
  std::string page;                  ///< one HTML file that needs nothing else
  std::vector<std::string> remarks;  ///< what was coarsened or left out, and why; also in the page
};

/// A result folder of run, evaluate, selftest or sweep as a page to look at: tables, curves,
/// claims, objects, the scene of every world, times and how it was made. What the folder does not
/// have is left out with a sentence in its place; claims it says nothing to without one. Throws
/// InputError where it is no result folder, for broken files, and where the program was built
/// without the front end.
HtmlReport htmlReport(const std::filesystem::path& result, const HtmlReportOptions& options = {});

}  // namespace hydrabench
