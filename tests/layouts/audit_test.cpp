// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/audit.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "strainwave/present/json.hpp"

namespace strainwave {
namespace {

TEST(AuditReport, BehaviourAllFormsCarryAllRows) {
  const std::vector<AuditRow> rows = audit();
  const nlohmann::json json = nlohmann::json::parse(json_of(rows));
  ASSERT_EQ(json.size(), rows.size());
  const std::string text = audit_text(rows);
  const std::string markdown = audit_markdown(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(json[i].at("id"), rows[i].id);
    EXPECT_EQ(json[i].at("verdict"), enum_name(rows[i].verdict));
    EXPECT_NE(text.find("\n  " + rows[i].id + " "), std::string::npos) << rows[i].id;
    EXPECT_NE(markdown.find("\n| " + rows[i].id + " |"), std::string::npos) << rows[i].id;
  }
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    EXPECT_LE(end - begin, 116U) << text.substr(begin, end - begin);
}

}  // namespace
}  // namespace strainwave
