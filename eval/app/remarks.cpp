// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/app/remarks.h"

#include <fmt/format.h>

namespace hydrabench {

namespace {

std::string objects(std::size_t count) {
  return fmt::format("{} object{}", count, count == 1 ? "" : "s");
}

}  // namespace

void printRemarks(const MethodEvaluation& method) {
  if (method.unscored_estimates > 0) {
    fmt::print(stderr,
               "{}: {} left out: of a class that is not scored, or standing for ground truth that "
               "does not count\n",
               method.method, objects(method.unscored_estimates));
  }
  if (method.estimates_without_mesh > 0) {
    fmt::print(stderr, "{}: {} of {} without a mesh: found by the box, no shape to score\n",
               method.method, method.estimates_without_mesh, objects(method.estimates.size()));
  }
  if (method.estimates.empty()) {
    fmt::print(stderr, "{}: no object at all to score on {}\n", method.method, method.dataset);
  }
}

}  // namespace hydrabench
