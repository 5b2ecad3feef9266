// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/app/remarks.h"

#include <fmt/format.h>

namespace hydrabench {

void printRemarks(const MethodEvaluation& method) {
  if (method.unscored_estimates > 0) {
    fmt::print(stderr,
               "{}: {} objects were left out: their class is not scored, or they stand for ground "
               "truth that does not count\n",
               method.method, method.unscored_estimates);
  }
  if (method.estimates_without_mesh > 0) {
    fmt::print(stderr,
               "{}: {} of {} objects have no mesh: they are found by their box, and have no shape "
               "to score\n",
               method.method, method.estimates_without_mesh, method.estimates.size());
  }
}

}  // namespace hydrabench
