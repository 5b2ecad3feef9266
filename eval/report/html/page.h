// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "eval/report/html/web_assets.h"

namespace hydrabench {

/// A piece of data in the page: an element <script id="..."> that the browser does not run.
struct PageData {
  enum class Kind {
    kJson,    ///< text is JSON
    kBinary,  ///< text is base64 of bytes; of gzipped bytes where the id ends in ".gz"
  };
  std::string id;  ///< letters, digits, '-' and '.'
  Kind kind = Kind::kJson;
  std::string text;
};

/// JSON that can stand inside <script>: no name in it can end the element or start a comment.
std::string escapedForScript(const std::string& json);
std::string escapedForHtml(const std::string& text);

/// The whole file: style, script and data inside, nothing to be fetched.
std::string assemblePage(const WebAssets& assets, const std::string& title,
                         const std::vector<PageData>& data);

}  // namespace hydrabench
