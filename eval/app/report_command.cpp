// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <unistd.h>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/report/comparison_table.h"
#include "eval/report/result_folder.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path result;
  std::filesystem::path out;
  std::string format = "terminal";
  std::string class_name = kAllMicro;
};

std::string render(const ComparisonTable& table, const std::string& format, bool color) {
  if (format == "md") return renderMarkdown(table);
  if (format == "tex") return renderLatex(table);
  if (format == "csv") return renderCsv(table);
  if (format == "json") return renderJson(table);
  return renderTerminal(table, color);
}

int report(const Options& options) {
  const std::filesystem::path scores = options.result / "scores.csv";
  if (std::filesystem::exists(options.result / kResultMarker) && !std::filesystem::exists(scores)) {
    throw InputError(fmt::format("{}: nothing was scored here: its datasets have no ground truth",
                                 options.result.string()));
  }
  const std::vector<ScoreRow> rows = readScoresCsv(scores);
  const ComparisonTable table =
      comparisonTable(rows, options.class_name, readNotes(options.result));
  if (table.blocks.empty()) {
    throw InputError(
        fmt::format("{}: no scores of class '{}'; --class takes a class of that file, {} or {}",
                    scores.string(), options.class_name, kAllMicro, kAllMacro));
  }
  const bool color = options.out.empty() && isatty(STDOUT_FILENO) == 1;
  const std::string text = render(table, options.format, color);
  if (options.out.empty()) {
    fmt::print("{}", text);
  } else {
    writeFileAtomic(options.out, text);
    fmt::print("wrote {}\n", options.out.string());
  }
  return kDone;
}

}  // namespace

Command addReport(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("result", options->result,
                 "result folder, as written by run, evaluate or selftest")
      ->required()
      ->type_name("RESULT");
  app.add_option("--format", options->format, "terminal, md, tex (booktabs), csv or json")
      ->check(CLI::IsMember({"terminal", "md", "tex", "csv", "json"}))
      ->capture_default_str();
  app.add_option("--class", options->class_name, "class to print, all_micro (pooled) or all_macro")
      ->capture_default_str();
  app.add_option("--out", options->out, "file to write instead of printing")->type_name("FILE");
  return [options] { return report(*options); };
}

}  // namespace hydrabench
