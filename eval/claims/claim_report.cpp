// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/claims/claim_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hydrabench {
namespace {

std::string differenceText(const Finding& finding) {
  if (!finding.difference || !finding.interval) return "";
  return fmt::format("{:+.3g} [{:+.3g}, {:+.3g}]", *finding.difference, finding.interval->low,
                     finding.interval->high);
}

/// "results/table1, office", or nothing where nothing was found.
std::string place(const Finding& finding) {
  return finding.result.empty() ? "" : fmt::format("{}, {}", finding.result, finding.dataset);
}

std::string summary(const std::vector<JudgedClaim>& claims) {
  std::string text;
  for (const ClaimVerdict verdict : {ClaimVerdict::kHolds, ClaimVerdict::kFails,
                                     ClaimVerdict::kUndecided, ClaimVerdict::kNotRun}) {
    const auto count = std::count_if(claims.begin(), claims.end(), [&](const JudgedClaim& claim) {
      return claim.verdict == verdict;
    });
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name(verdict));
  }
  return text;
}

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return text;
}

}  // namespace

std::string claimsText(const std::vector<JudgedClaim>& claims) {
  std::string text;
  for (const JudgedClaim& judged : claims) {
    text +=
        fmt::format("{:<10} {}: {}{}\n", name(judged.verdict), judged.claim.name, judged.claim.says,
                    judged.claim.source.empty() ? "" : " (" + judged.claim.source + ")");
    for (const Finding& finding : judged.findings) {
      const std::string difference = differenceText(finding);
      text += fmt::format("           {:<9}  {}{}{}\n", name(finding.verdict),
                          finding.result.empty() ? "" : place(finding) + ": ", finding.what,
                          difference.empty() ? "" : "; " + difference);
    }
  }
  return text + summary(claims) + "\n";
}

std::string claimsMarkdown(const std::vector<JudgedClaim>& claims) {
  std::string text =
      "| claim | verdict | dataset | finding | difference, 95 % | |\n|---|---|---|---|---|---|\n";
  for (const JudgedClaim& judged : claims) {
    bool first = true;
    for (const Finding& finding : judged.findings) {
      const std::string says =
          judged.claim.says +
          (judged.claim.source.empty() ? "" : fmt::format(" ({})", judged.claim.source));
      text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", first ? cell(says) : "",
                          first ? fmt::format("**{}**", name(judged.verdict)) : "",
                          cell(place(finding)), cell(finding.what), differenceText(finding),
                          name(finding.verdict));
      first = false;
    }
  }
  return text + "\n" + summary(claims) + "\n";
}

std::string claimsJson(const std::vector<JudgedClaim>& claims) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const JudgedClaim& judged : claims) {
    nlohmann::ordered_json findings = nlohmann::ordered_json::array();
    for (const Finding& finding : judged.findings) {
      nlohmann::ordered_json json;
      json["verdict"] = name(finding.verdict);
      json["result"] = finding.result;
      json["dataset"] = finding.dataset;
      json["what"] = finding.what;
      if (finding.difference) json["difference"] = *finding.difference;
      if (finding.interval) json["ci95"] = {finding.interval->low, finding.interval->high};
      if (!finding.relation.empty()) {
        json["relation"] = finding.relation;
        json["bound"] = finding.bound;
      }
      findings.push_back(std::move(json));
    }
    all.push_back({{"name", judged.claim.name},
                   {"says", judged.claim.says},
                   {"source", judged.claim.source},
                   {"verdict", name(judged.verdict)},
                   {"findings", std::move(findings)}});
  }
  return all.dump(2) + "\n";
}

}  // namespace hydrabench
