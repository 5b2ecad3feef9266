// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "eval/evaluation/csv.h"
#include "eval/report/comparison_table.h"

namespace hydrabench {
namespace {

std::string valueText(const TableCell& cell, const TableColumn& column) {
  return cell.value ? fmt::format("{:.{}f}", *cell.value, column.decimals) : "n/a";
}

std::string intervalText(const TableCell& cell, const TableColumn& column) {
  if (!cell.ci95_low || !cell.ci95_high) return "";
  return fmt::format("[{:.{}f}, {:.{}f}]", *cell.ci95_low, column.decimals, *cell.ci95_high,
                     column.decimals);
}

/// Columns of a terminal, not bytes: our titles hold arrows.
std::size_t displayWidth(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string space(width - std::min(width, displayWidth(text)), ' ');
  return left ? text + space : space + text;
}

bool hasSeveralDatasets(const ComparisonTable& table) {
  return !table.blocks.empty() && table.blocks.front().dataset != table.blocks.back().dataset;
}

std::string blockTitle(const ComparisonTable& table, const TableBlock& block) {
  return (hasSeveralDatasets(table) ? block.dataset + ", " : "") +
         fmt::format("tau_d = {:g} m, {}", block.threshold, block.matching);
}

std::string escapedLatex(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string("&%$#_{}").find(c) != std::string::npos) out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

std::string renderTerminal(const ComparisonTable& table, bool color) {
  // Bold, plain underline and dim mark the ranks on any background.
  static const char* const kMarks[] = {"", "\033[1;32m", "\033[32m", "\033[33m"};
  std::size_t label_width = 6;
  std::vector<std::size_t> widths;
  for (const TableColumn& column : table.columns) widths.push_back(displayWidth(column.title));
  for (const TableBlock& block : table.blocks) {
    for (const TableRow& row : block.rows) {
      label_width = std::max(label_width, displayWidth(row.label));
      for (std::size_t c = 0; c < row.cells.size(); ++c) {
        widths[c] = std::max({widths[c], valueText(row.cells[c], table.columns[c]).size(),
                              intervalText(row.cells[c], table.columns[c]).size()});
      }
    }
  }
  std::string text = table.title + "\n";
  for (const TableBlock& block : table.blocks) {
    text += "\n" + padded(blockTitle(table, block), label_width, true) + "\n";
    text += padded("method", label_width, true);
    for (std::size_t c = 0; c < widths.size(); ++c) {
      text += "  " + padded(table.columns[c].title, widths[c], false);
    }
    text += "\n";
    for (const TableRow& row : block.rows) {
      const auto line = [&](const std::string& label, const auto& cellText, bool marked) {
        std::string out = padded(label, label_width, true);
        for (std::size_t c = 0; c < row.cells.size(); ++c) {
          const std::string cell =
              padded(cellText(row.cells[c], table.columns[c]), widths[c], false);
          const bool mark = color && marked && row.cells[c].rank > 0;
          out += "  " + (mark ? kMarks[row.cells[c].rank] + cell + "\033[0m" : cell);
        }
        out.erase(out.find_last_not_of(' ') + 1);
        return out + "\n";
      };
      text += line(row.label, valueText, true);
      const bool has_intervals =
          std::any_of(row.cells.begin(), row.cells.end(),
                      [](const TableCell& cell) { return cell.ci95_low.has_value(); });
      if (has_intervals) text += line("", intervalText, false);
    }
  }
  text += "\n";
  for (const std::string& note : table.notes) text += note + "\n";
  return text;
}

std::string renderMarkdown(const ComparisonTable& table) {
  std::string text = "## " + table.title + "\n";
  for (const TableBlock& block : table.blocks) {
    text += fmt::format("\n### {}\n\n| method |", blockTitle(table, block));
    for (const TableColumn& column : table.columns) text += " " + column.title + " |";
    text += "\n|---|";
    for (std::size_t c = 0; c < table.columns.size(); ++c) text += "---:|";
    text += "\n";
    for (const TableRow& row : block.rows) {
      text += "| " + row.label + " |";
      for (std::size_t c = 0; c < row.cells.size(); ++c) {
        const std::string value = valueText(row.cells[c], table.columns[c]);
        const std::string interval = intervalText(row.cells[c], table.columns[c]);
        text += row.cells[c].rank == 1 ? " **" + value + "**" : " " + value;
        text += interval.empty() ? " |" : " <sub>" + interval + "</sub> |";
      }
      text += "\n";
    }
  }
  text += "\n";
  for (const std::string& note : table.notes) text += "- " + note + "\n";
  return text;
}

std::string renderLatex(const ComparisonTable& table) {
  static const char* const kShades[] = {"", R"(\cellcolor{hbfirst})", R"(\cellcolor{hbsecond})",
                                        R"(\cellcolor{hbthird})"};
  std::string text =
      "% Needs \\usepackage{booktabs,multirow,graphicx} and \\usepackage[table]{xcolor}.\n"
      "\\definecolor{hbfirst}{rgb}{0.753, 0.898, 0.804}\n"
      "\\definecolor{hbsecond}{rgb}{0.894, 0.933, 0.745}\n"
      "\\definecolor{hbthird}{rgb}{0.996, 0.972, 0.780}\n"
      "% Intervals and counts: --format csv.\n"
      "\\begin{table*}[t]\n  \\centering\n  \\scriptsize\n  \\setlength{\\tabcolsep}{4pt}\n";
  text += fmt::format("  \\caption{{{}. {}}}\n", escapedLatex(table.title),
                      "Best three values of each column are shaded");
  // What is compared; the rest would not fit on a page.
  std::vector<std::size_t> printed;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].ranked) printed.push_back(c);
  }
  text += fmt::format("  \\begin{{tabular}}{{l|l{}}}\n    \\toprule\n    & Method",
                      std::string(printed.size(), 'c'));
  for (const std::size_t c : printed) text += " & " + table.columns[c].latex_title;
  text += " \\\\\n";
  for (const TableBlock& block : table.blocks) {
    const std::string what =
        fmt::format("\\shortstack{{$\\tau_d = {:g}$\\,m\\\\{}{}}}", block.threshold,
                    escapedLatex(block.matching),
                    hasSeveralDatasets(table) ? "\\\\" + escapedLatex(block.dataset) : "");
    constexpr std::size_t kTallEnough = 5;  // rows, for a line of text on its side
    text += fmt::format("    \\midrule\n    \\multirow{{{}}}{{*}}{{{}}}\n", block.rows.size(),
                        block.rows.size() < kTallEnough
                            ? what
                            : fmt::format("\\rotatebox[origin=c]{{90}}{{{}}}", what));
    for (const TableRow& row : block.rows) {
      text += "    & " + escapedLatex(row.label);
      for (const std::size_t c : printed) {
        const TableCell& cell = row.cells[c];
        const std::string value = valueText(cell, table.columns[c]);
        text += fmt::format(" & {}{}", kShades[cell.rank],
                            cell.rank == 1 ? "\\textbf{" + value + "}" : value);
      }
      text += " \\\\\n";
    }
  }
  text += "    \\bottomrule\n  \\end{tabular}\n\\end{table*}\n";
  for (const std::string& note : table.notes) text += "% " + note + "\n";
  return text;
}

std::string renderCsv(const ComparisonTable& table) {
  std::vector<std::string> header = {"dataset", "threshold_m", "matching", "method"};
  for (const TableColumn& column : table.columns) {
    header.push_back(column.metric);
    header.push_back(column.metric + "_ci95_low");
    header.push_back(column.metric + "_ci95_high");
  }
  std::string text = csvLine(header);
  for (const TableBlock& block : table.blocks) {
    for (const TableRow& row : block.rows) {
      std::vector<std::string> cells = {block.dataset, csvNumber(block.threshold), block.matching,
                                        row.method};
      for (const TableCell& cell : row.cells) {
        cells.push_back(csvNumber(cell.value));
        cells.push_back(csvNumber(cell.ci95_low));
        cells.push_back(csvNumber(cell.ci95_high));
      }
      text += csvLine(cells);
    }
  }
  return text;
}

std::string renderJson(const ComparisonTable& table) {
  const auto number = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  };
  nlohmann::ordered_json json;
  json["title"] = table.title;
  json["notes"] = table.notes;
  json["blocks"] = nlohmann::ordered_json::array();
  for (const TableBlock& block : table.blocks) {
    nlohmann::ordered_json block_json = {
        {"dataset", block.dataset}, {"threshold_m", block.threshold}, {"matching", block.matching}};
    block_json["rows"] = nlohmann::ordered_json::array();
    for (const TableRow& row : block.rows) {
      nlohmann::ordered_json row_json = {{"method", row.method}};
      for (std::size_t c = 0; c < row.cells.size(); ++c) {
        row_json[table.columns[c].metric] = {{"value", number(row.cells[c].value)},
                                             {"ci95_low", number(row.cells[c].ci95_low)},
                                             {"ci95_high", number(row.cells[c].ci95_high)},
                                             {"rank", row.cells[c].rank}};
      }
      block_json["rows"].push_back(std::move(row_json));
    }
    json["blocks"].push_back(std::move(block_json));
  }
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace hydrabench
