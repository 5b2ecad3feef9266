// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "eval/report/html/score_data.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr WebAssets kAssets = {
    "<title>{{title}}</title><style>{{style}}</style>{{data}}<script>{{script}}</script>", "body{}",
    "run()", "licence"};

TEST(Page, NoNameInTheDataCanEndItsElement) {
  const std::string name = "</script><script>alert(1)</script><!--";
  const std::string json = methodsJson({name});
  const std::string page = assemblePage(kAssets, "t", {{"methods", PageData::Kind::kJson, json}});
  EXPECT_THAT(page, Not(HasSubstr("alert(1)</script>")));
  EXPECT_THAT(page, Not(HasSubstr("<!--")));
  // What is read back is the name.
  EXPECT_EQ(nlohmann::json::parse(escapedForScript(json))[0]["name"], name);
}

TEST(Page, TheTitleIsText) {
  EXPECT_THAT(assemblePage(kAssets, "<b>'\"&", {}),
              HasSubstr("<title>&lt;b&gt;&#39;&quot;&amp;</title>"));
}

TEST(Page, DataThatLooksLikeASlotStaysAsItIs) {
  const std::string page =
      assemblePage(kAssets, "t", {{"a", PageData::Kind::kJson, R"(["{{script}}"])"}});
  EXPECT_THAT(page, HasSubstr(R"(id="a">["{{script}}"]</script>)"));
  EXPECT_THAT(page, HasSubstr("<script>run()</script>"));
}

TEST(Page, BytesAreNotJson) {
  EXPECT_THAT(assemblePage(kAssets, "t", {{"b.gz", PageData::Kind::kBinary, "Zm9v"}}),
              HasSubstr(R"(<script type="text/base64" id="b.gz">Zm9v</script>)"));
}

}  // namespace
}  // namespace hydrabench
