// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/page.h"

#include <functional>
#include <map>

namespace hydrabench {
namespace {

std::string dataElement(const PageData& data) {
  const bool is_json = data.kind == PageData::Kind::kJson;
  return std::string("<script type=\"") + (is_json ? "application/json" : "text/base64") +
         "\" id=\"" + data.id + "\">" + (is_json ? escapedForScript(data.text) : data.text) +
         "</script>\n";
}

}  // namespace

std::string escapedForScript(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";  // '<' stands within strings only
    } else {
      out += c;
    }
  }
  return out;
}

std::string escapedForHtml(const std::string& text) {
  static const std::map<char, std::string> kEntities = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string out;
  for (const char c : text) {
    const auto entity = kEntities.find(c);
    out += entity == kEntities.end() ? std::string(1, c) : entity->second;
  }
  return out;
}

std::string assemblePage(const WebAssets& assets, const std::string& title,
                         const std::vector<PageData>& data) {
  const std::map<std::string_view, std::function<void(std::string&)>> kSlots = {
      {"title", [&](std::string& out) { out += escapedForHtml(title); }},
      {"style", [&](std::string& out) { out += assets.style; }},
      {"script", [&](std::string& out) { out += assets.script; }},
      {"data",
       [&](std::string& out) {
         for (const PageData& piece : data) out += dataElement(piece);
       }},
  };
  std::string out;
  std::string_view rest = assets.page;
  // What is put in is never looked at again: data may say {{title}}.
  for (std::size_t open = rest.find("{{"); open != std::string_view::npos; open = rest.find("{{")) {
    const std::size_t close = rest.find("}}", open);
    const auto slot = kSlots.find(rest.substr(open + 2, close - open - 2));
    out += rest.substr(0, open);
    if (slot != kSlots.end()) slot->second(out);
    rest.remove_prefix(close + 2);
  }
  return out += rest;
}

}  // namespace hydrabench
