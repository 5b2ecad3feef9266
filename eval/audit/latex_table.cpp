// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/audit/latex_table.h"

#include <cctype>
#include <map>
#include <string_view>

namespace hydrabench {
namespace {

/// Commands whose first arguments are not text, and how many.
const std::map<std::string, int, std::less<>> kSkippedArguments = {
    {"multirow", 2}, {"multicolumn", 2}, {"parbox", 1},       {"rotatebox", 1}, {"cmidrule", 1},
    {"cline", 1},    {"color", 1},       {"textcolor", 1},    {"cellcolor", 1}, {"rowcolor", 1},
    {"vspace", 1},   {"hspace", 1},      {"addlinespace", 0}, {"cite", 1},      {"label", 1},
    {"citep", 1},    {"citet", 1},       {"resizebox", 2},    {"scalebox", 1}};
/// Commands of which nothing is left.
const char* const kSilent[] = {"toprule",    "midrule",      "bottomrule", "hline",     "textbf",
                               "textit",     "emph",         "underline",  "mathbf",    "boldmath",
                               "text",       "mathrm",       "uparrow",    "downarrow", "small",
                               "scriptsize", "footnotesize", "bfseries",   "centering", "texttt",
                               "textsc",     "quad",         "left",       "right"};

bool isSilent(std::string_view command) {
  for (const char* name : kSilent) {
    if (command == name) return true;
  }
  return kSkippedArguments.contains(command);
}

std::string withoutComments(const std::string& source) {
  std::string result;
  bool comment = false;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source[i] == '\n') comment = false;
    if (source[i] == '%' && (i == 0 || source[i - 1] != '\\')) comment = true;
    if (!comment) result += source[i];
  }
  return result;
}

/// Position after the bracket that closes the one at `position`.
std::size_t afterGroup(const std::string& text, std::size_t position, char open, char close) {
  int depth = 0;
  for (; position < text.size(); ++position) {
    if (text[position] == '\\') {
      ++position;
    } else if (text[position] == open) {
      ++depth;
    } else if (text[position] == close && --depth == 0) {
      return position + 1;
    }
  }
  return text.size();
}

std::size_t afterSpace(const std::string& text, std::size_t position) {
  while (position < text.size() && std::isspace(static_cast<unsigned char>(text[position])) != 0) {
    ++position;
  }
  return position;
}

/// Position after the arguments of a command that are not text.
std::size_t afterArguments(const std::string& text, std::size_t position, int count) {
  for (;;) {
    const std::size_t next = afterSpace(text, position);
    if (next < text.size() && text[next] == '[') {
      position = afterGroup(text, next, '[', ']');
    } else if (next < text.size() && text[next] == '(') {
      position = afterGroup(text, next, '(', ')');
    } else if (count > 0 && next < text.size() && text[next] == '{') {
      position = afterGroup(text, next, '{', '}');
      --count;
    } else if (count > 0 && next < text.size() && text[next] == '*') {
      position = next + 1;  // \multirow{5}*{...}
      --count;
    } else {
      return position;
    }
  }
}

std::string plainText(const std::string& cell) {
  std::string result;
  std::size_t i = 0;
  while (i < cell.size()) {
    const char c = cell[i];
    if (c == '{' || c == '}' || c == '$') {
      ++i;
    } else if (c == '~') {
      result += ' ';
      ++i;
    } else if (c != '\\') {
      result += std::isspace(static_cast<unsigned char>(c)) != 0 ? ' ' : c;
      ++i;
    } else {
      std::size_t end = i + 1;
      while (end < cell.size() && std::isalpha(static_cast<unsigned char>(cell[end])) != 0) ++end;
      const std::string command = cell.substr(i + 1, end - i - 1);
      if (command.empty()) {  // \, \% \_ and the like
        if (end < cell.size()) {
          result +=
              std::string_view(",;:! ").find(cell[end]) == std::string_view::npos ? cell[end] : ' ';
        }
        i = end + 1;
        continue;
      }
      i = end;
      if (const auto found = kSkippedArguments.find(command); found != kSkippedArguments.end()) {
        i = afterArguments(cell, i, found->second);
      }
      if (!isSilent(command)) result += command;
    }
  }
  return result;
}

/// Cells of a tabular's body: split at & and \\ that stand in no group.
std::vector<std::vector<std::string>> cellsOf(const std::string& body) {
  std::vector<std::vector<std::string>> rows(1, {""});
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (body[i] == '\\' && i + 1 < body.size()) {
      if (body[i + 1] == '\\') {
        rows.push_back({""});
      } else {
        rows.back().back() += body.substr(i, 2);
      }
      ++i;
    } else if (body[i] == '{') {
      const std::size_t end = afterGroup(body, i, '{', '}');
      rows.back().back() += body.substr(i, end - i);
      i = end - 1;
    } else if (body[i] == '&') {
      rows.back().emplace_back();
    } else {
      rows.back().back() += body[i];
    }
  }
  for (std::vector<std::string>& row : rows) {
    for (std::string& cell : row) cell = plainText(cell);
  }
  return rows;
}

}  // namespace

std::vector<std::vector<std::vector<std::string>>> latexTables(const std::string& source) {
  const std::string text = withoutComments(source);
  std::vector<std::vector<std::vector<std::string>>> tables;
  static constexpr std::string_view kBegin = "\\begin{tabular";
  static constexpr std::string_view kEnd = "\\end{tabular";
  for (std::size_t at = text.find(kBegin); at != std::string::npos; at = text.find(kBegin, at)) {
    at = text.find('}', at) + 1;  // tabular, tabular*, tabularx
    const bool sized = text.compare(at - 2, 2, "*}") == 0 || text.compare(at - 2, 2, "x}") == 0;
    at = afterArguments(text, at, sized ? 2 : 1);
    const std::size_t end = text.find(kEnd, at);
    tables.push_back(cellsOf(text.substr(at, end - at)));
  }
  if (tables.empty()) tables.push_back(cellsOf(text));
  return tables;
}

}  // namespace hydrabench
