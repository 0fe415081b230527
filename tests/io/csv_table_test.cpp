#include "berm/io/csv_table.hpp"

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

std::vector<std::vector<std::string>> parse(const std::string& text) {
  std::istringstream input(text);
  CsvTable table(input, "scans.csv");
  std::vector<std::vector<std::string>> rows = {table.columns()};
  while (table.next()) {
    std::vector<std::string>& row = rows.emplace_back();
    for (std::size_t i = 0; i < table.columns().size(); ++i) {
      row.emplace_back(table.text(i));
    }
  }
  return rows;
}

void expect_refused(const std::string& text, const std::string& part) {
  SCOPED_TRACE(text);
  test::expect_file_error(ErrorCode::malformed, part, [&] { (void)parse(text); });
}

TEST(CsvTable, GivesNamesAndFields) {
  using Rows = std::vector<std::vector<std::string>>;
  EXPECT_EQ(parse("scan,slope_deg,degraded\na,1.5,\nb,,no_time\n"),
            (Rows{{"scan", "slope_deg", "degraded"}, {"a", "1.5", ""}, {"b", "", "no_time"}}));
  EXPECT_EQ(parse("a\r\n1\r\n2"), (Rows{{"a"}, {"1"}, {"2"}}));
  EXPECT_EQ(parse("a,b\n\"x,\"\"y\"\"\",\"\"\n"), (Rows{{"a", "b"}, {"x,\"y\"", ""}}));
}

TEST(CsvTable, ReadsNumbersAndFindsColumns) {
  std::istringstream input("scan,slope_deg\na,-1.5\nb,\nc,steep\n");
  CsvTable table(input, "scans.csv");
  EXPECT_EQ(table.column("slope_deg"), 1U);
  EXPECT_FALSE(table.column("slope"));
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.number(1), -1.5);
  ASSERT_TRUE(table.next());
  EXPECT_TRUE(std::isnan(table.number(1)));
  ASSERT_TRUE(table.next());
  test::expect_file_error(ErrorCode::malformed, "slope_deg", [&] { (void)table.number(1); });
}

TEST(CsvTable, RefusesWhatIsNoTable) {
  expect_refused("", "empty");
  expect_refused("a,,b\n", "names of columns");
  expect_refused("a,b,a\n", "each once");
  expect_refused("a,b\n1\n", "1 fields where the header has 2");
  expect_refused("a,b\n1,2,3\n", "3 fields where the header has 2");
  expect_refused("a\n\"1\n", "quote");
  expect_refused("a\n\"1\"2\n", "quote");
  test::expect_file_error(ErrorCode::not_found, "nowhere.csv", [] { CsvTable table("nowhere.csv"); });
}

TEST(CsvTable, WhatIsQuotedComesBack) {
  EXPECT_TRUE(rc::check("a field in quotes comes back", [](const std::vector<char>& given) {
    std::string field;
    std::string written = "name,other\n\"";
    for (const char c : given) {
      if (c == '\n' || c == '\r' || c == '\0') {
        continue;
      }
      field += c;
      written += c == '"' ? "\"\"" : std::string(1, c);
    }
    RC_ASSERT(parse(written + "\",1\n").at(1) == (std::vector<std::string>{field, "1"}));
  }));
}

}  // namespace
}  // namespace berm
