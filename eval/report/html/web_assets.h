// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace hydrabench {

/// The front end of the report, bundled and embedded when the program was built (web_assets.cmake).
struct WebAssets {
  std::string_view page;      ///< web/page.html
  std::string_view style;     ///< web/style.css and that of the libraries
  std::string_view script;    ///< web/main.js with all it imports, libraries included
  std::string_view licenses;  ///< of the libraries in there
};

/// Throws InputError saying what was missing when the program was built and what to do.
WebAssets webAssets();

}  // namespace hydrabench
