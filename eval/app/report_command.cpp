// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <unistd.h>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/app/progress.h"
#include "eval/claims/claim.h"
#include "eval/report/comparison_table.h"
#include "eval/report/html/html_report.h"
#include "eval/report/result_folder.h"
#include "eval/report/variant_table.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path result;
  std::filesystem::path out;
  std::string format = "terminal";
  std::string class_name = kAllMicro;
  bool variants = false;
  std::string against;
  double max_mb = HtmlReportOptions().max_mb;
  std::filesystem::path claims;
};

std::string render(const ComparisonTable& table, const std::string& format, bool color) {
  if (format == "md") return renderMarkdown(table);
  if (format == "tex") return renderLatex(table);
  if (format == "csv") return renderCsv(table);
  if (format == "json") return renderJson(table);
  return renderTerminal(table, color);
}

void deliver(const std::string& text, const Options& options) {
  if (options.out.empty()) {
    fmt::print("{}", text);
  } else {
    writeFileAtomic(options.out, text);
    fmt::print("wrote {}\n", options.out.string());
  }
}

int reportVariants(const Options& options) {
  const std::filesystem::path path = options.result / "variants.csv";
  std::vector<VariantRow> rows = readVariantsCsv(path);
  if (options.class_name != kAllMicro) {
    std::erase_if(rows,
                  [&](const VariantRow& row) { return row.class_name != options.class_name; });
  }
  if (rows.empty()) {
    throw InputError(fmt::format(
        "{}: no variants{}: this dataset does not name them", path.string(),
        options.class_name == kAllMicro ? "" : " of class '" + options.class_name + "'"));
  }
  deliver(options.format == "csv" ? renderVariantsCsv(rows) : renderVariantsMarkdown(rows),
          options);
  return kDone;
}

/// One file to look at, beside the result unless told otherwise.
int reportHtml(const Options& options) {
  std::optional<Progress> progress;
  HtmlReportOptions html;
  html.max_mb = options.max_mb;
  html.claims = options.claims;
  if (html.claims.empty() && std::filesystem::exists(kDefaultClaims)) html.claims = kDefaultClaims;
  html.on_step = [&](std::size_t, std::size_t total) {
    if (!progress) progress.emplace("report", total);
    progress->advance();
  };
  const HtmlReport report = htmlReport(options.result, html);
  progress.reset();
  for (const std::string& remark : report.remarks) fmt::print(stderr, "{}\n", remark);
  const std::filesystem::path out =
      options.out.empty() ? options.result / "report.html" : options.out;
  writeFileAtomic(out, report.page);
  fmt::print("wrote {} ({:.1f} MB)\n", out.string(), static_cast<double>(report.page.size()) / 1e6);
  return kDone;
}

int report(const Options& options) {
  if (options.format == "html") return reportHtml(options);
  const std::filesystem::path scores = options.result / "scores.csv";
  if (std::filesystem::exists(options.result / kResultMarker) && !std::filesystem::exists(scores)) {
    throw InputError(fmt::format("{}: nothing was scored here: its datasets have no ground truth",
                                 options.result.string()));
  }
  if (options.variants) return reportVariants(options);
  const std::vector<ScoreRow> rows = readScoresCsv(scores);
  ComparisonTable table = comparisonTable(rows, options.class_name, readNotes(options.result));
  if (table.blocks.empty()) {
    throw InputError(
        fmt::format("{}: no scores of class '{}'; --class takes a class of that file, {} or {}",
                    scores.string(), options.class_name, kAllMicro, kAllMacro));
  }
  if (!options.against.empty()) table = differencesTo(table, options.against);
  const bool color = options.out.empty() && isatty(STDOUT_FILENO) == 1;
  const std::string text = render(table, options.format, color);
  deliver(text, options);
  return kDone;
}

}  // namespace

Command addReport(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("result", options->result,
                 "result folder, as written by run, evaluate or selftest")
      ->required()
      ->type_name("RESULT");
  app.add_option(
         "--format", options->format,
         "terminal, md, tex (booktabs), csv, json, or html: one file with all there is to look at")
      ->check(CLI::IsMember({"terminal", "md", "tex", "csv", "json", "html"}))
      ->capture_default_str();
  app.add_option("--class", options->class_name, "class to print, all_micro (pooled) or all_macro")
      ->capture_default_str();
  app.add_flag("--variants", options->variants,
               "a row for every shape variant and method instead; md or csv");
  app.add_option("--against", options->against,
                 "print every value less that of this method: what a change gains or costs")
      ->type_name("METHOD");
  app.add_option("--out", options->out,
                 "file to write instead of printing; html: instead of RESULT/report.html")
      ->type_name("FILE");
  app.add_option("--max-mb", options->max_mb,
                 "html: size to keep below [10^6 bytes], by coarser scenes")
      ->check(CLI::Range(1.0, 2000.0))
      ->capture_default_str();
  app.add_option("--claims", options->claims,
                 fmt::format("html: claims to judge; {} where it is there", kDefaultClaims))
      ->type_name("FILE");
  return [options] { return report(*options); };
}

}  // namespace hydrabench
