// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "eval/app/app.h"
#include "eval/audit/audit.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path table;
  std::filesystem::path out;
  std::string format = "text";
  std::size_t max_objects = 250;
};

int run(const Options& options) {
  const Audit result = audit(readPublishedTable(options.table), options.max_objects);
  const std::string text = options.format == "csv" ? auditCsv(result) : auditText(result);
  if (options.out.empty()) {
    fmt::print("{}", text);
  } else {
    writeFileAtomic(options.out, text);
    fmt::print("wrote {}\n", options.out.string());
  }
  return result.impossible() > 0 ? kGateFailed : kDone;
}

}  // namespace

Command addAudit(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("table", options->table, "published table: CSV with a header, or LaTeX (.tex)")
      ->required()
      ->type_name("TABLE");
  app.add_option("--max-objects", options->max_objects,
                 "numbers of ground-truth objects and of estimates to try")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--format", options->format, "text or csv")
      ->check(CLI::IsMember({"text", "csv"}))
      ->capture_default_str();
  app.add_option("--out", options->out, "file to write instead of printing")->type_name("FILE");
  app.footer(
      "Finds the whole numbers behind printed precision, recall and F1: how many objects there "
      "were,\n"
      "how many estimates, and whether one-to-one matching can have given them. Needs columns\n"
      "method, P, R and F1; rows of several thresholds help. Example:\n"
      "  hydrabench audit configs/tables/hydra_plus_plus_table1.csv\n"
      "Exit code 1: a row is impossible.");
  return [options] { return run(*options); };
}

}  // namespace hydrabench
