// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/claims/claim.h"
#include "eval/claims/evidence.h"
#include "metrics/bootstrap.h"

namespace hydrabench {

enum class ClaimVerdict {
  kHolds,      ///< sure at 95 %
  kFails,      ///< the contrary is sure at 95 %
  kUndecided,  ///< the sample is too small to say
  kNotRun,     ///< the results lack what it takes
};
const char* name(ClaimVerdict verdict);  ///< "holds", "fails", "undecided", "not run"

/// One comparison behind a verdict.
struct Finding {
  ClaimVerdict verdict = ClaimVerdict::kNotRun;
  std::string result;
  std::string dataset;
  std::string what;  ///< "F1 at 0.2 m, exists: Hydra++ 0.927, Hydra 0.715"
  /// Of the difference that the predicate is about, in favour of `method` where positive; for
  /// real_time the least and the largest multiple of real time over worlds.
  std::optional<double> difference;
  std::optional<Interval> interval;
  /// "holds" where all of the interval is above, at least or below the bound: ">", ">=", "<"; empty
  /// where nothing was compared.
  std::string relation;
  double bound = 0;
};

struct JudgedClaim {
  Claim claim;
  ClaimVerdict verdict = ClaimVerdict::kNotRun;
  std::vector<Finding> findings;
};

/// A claim fails where one finding fails; else it was not run where one could not be made; else it
/// is undecided where one is; else it holds. A claim over several others needs them all, so no
/// correction for many tests is due to "holds" (intersection-union test; Berger, Technometrics
/// 1982). "Fails" is not corrected for the number of comparisons.
///
/// Differences are bootstrapped over objects in pairs, as in metrics/bootstrap.h; those of scene
/// scores come from the intervals of both and are wider than need be. kKappa looks at 40
/// thresholds; those where both methods score the same on every draw say nothing. Means over what
/// was found are undecided where a method found fewer than 8 objects.
std::vector<JudgedClaim> judge(const std::vector<Claim>& claims,
                               const std::vector<Evidence>& evidence,
                               const BootstrapConfig& config = {});

}  // namespace hydrabench
