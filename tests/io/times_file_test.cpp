#include "berm/io/times_file.hpp"

#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

std::vector<Stamp> parse_times(const std::string& text) {
  std::istringstream input(text);
  return read_times(input, "times.txt", kAll).stamps;
}

void expect_no_times(const std::string& text, const std::string& part) {
  SCOPED_TRACE(text);
  expect_file_error(ErrorCode::malformed, part, [&] { (void)parse_times(text); });
}

TEST(TimesFile, ReadsPlainAndScientificNumbers) {
  EXPECT_EQ(parse_times("0\n0.1\n2.5e-01\n1.036224e+00\n.5e1\n6.\n"),
            (std::vector<Stamp>{0, 100'000'000, 250'000'000, 1'036'224'000, 5'000'000'000, 6'000'000'000}));
}

TEST(TimesFile, KeepsEveryNanosecondOfAnEpoch) {
  EXPECT_EQ(parse_times("1635236489.369081856\n1635236489.369081857\n"),
            (std::vector<Stamp>{1'635'236'489'369'081'856, 1'635'236'489'369'081'857}));
}

TEST(TimesFile, RoundsDigitsBelowTheNanosecond) {
  EXPECT_EQ(parse_times("0.0000000004\n0.0000000005\n0.0000000015999\n"), (std::vector<Stamp>{0, 1, 2}));
  EXPECT_EQ(parse_times("-0.0000000016\n-4e-10\n12345678901234567890123e-20\n"),
            (std::vector<Stamp>{-2, 0, 123'456'789'012}));
}

TEST(TimesFile, AcceptsEverySaneEndOfLine) {
  const std::vector<Stamp> expected = {1'000'000'000, 2'000'000'000};
  for (const char* text : {"1\n2\n", "1\n2", "1\r\n2\r\n", "1\r\n2", "\n1\n\n2\n\n", "# start\n1\n  2\t\n#end"}) {
    EXPECT_EQ(parse_times(text), expected) << text;
  }
  EXPECT_TRUE(parse_times("").empty());
}

TEST(TimesFile, SurvivesARoundTrip) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("any increasing stamps survive", [&](const std::set<Stamp>& stamps) {
    std::vector<Stamp> written(stamps.begin(), stamps.end());
    // The smallest has no positive counterpart and is refused: 292 years are enough.
    std::erase(written, std::numeric_limits<Stamp>::min());
    write_times(folder / "times.txt", written);
    RC_ASSERT(read_times(folder / "times.txt", kAll).stamps == written);
  }));
  write_times(folder / "times.txt", std::vector<Stamp>{-1'500'000'000, 0, 103'700'000});
  EXPECT_EQ(test::slurp(folder / "times.txt"), "-1.500000000\n0.000000000\n0.103700000\n");
}

TEST(TimesFile, CountsBeyondWhatItKeeps) {
  std::istringstream input("1\n2\n3\n4\n");
  const TimesFile times = read_times(input, "times.txt", 2);
  EXPECT_EQ(times.lines, 4U);
  EXPECT_EQ(times.stamps.size(), 2U);
}

TEST(TimesFile, RefusesTimeThatStandsStillOrRunsBackwards) {
  expect_no_times("0\n0.1\n0.1\n", "times.txt: line 3: the stamp '0.1' is not later");
  expect_no_times("# seconds\n\n5\n4\n", "line 4");
  // Beyond what is kept, too.
  std::istringstream input("1\n2\n1\n");
  expect_file_error(ErrorCode::malformed, "line 3", [&] { (void)read_times(input, "times.txt", 1); });
}

TEST(TimesFile, RefusesWhatIsNoNumber) {
  for (const char* text : {"nan\n", "inf\n", "-inf\n", "0x10\n", "1,5\n", "1.5s\n", "1 2\n", "1e\n", "e5\n", ".\n",
                           "-\n", "--1\n", "+1\n", "1e99999999999\n", "1.2.3\n",
                           "\xef\xbb\xbf"
                           "1\n"}) {
    expect_no_times(text, "line 1: expected one number");
  }
}

TEST(TimesFile, RefusesTimesBeyond292Years) {
  expect_no_times("1e30\n", "line 1");
  expect_no_times("9300000000\n", "line 1");
  expect_no_times("-9300000000\n", "line 1");
  expect_no_times("9223372036.8547758075\n", "line 1");
  EXPECT_EQ(parse_times("9223372036.854775807\n").front(), std::numeric_limits<Stamp>::max());
}

TEST(TimesFile, RefusesBytesThatAreNoText) {
  expect_no_times(std::string("1\n\0\n", 4), "line 2: expected text, found a NUL byte");
  expect_no_times("1\n" + std::string(5000, '7'), "line 2: longer than 4096 bytes");
}

TEST(TimesFile, SaysWhatIsWrongWithThePath) {
  const test::TempFolder folder;
  expect_file_error(ErrorCode::not_found, "times.txt", [&] { (void)read_times(folder / "times.txt", kAll); });
  expect_file_error(ErrorCode::unreadable, "expected a text file", [&] { (void)read_times(folder.path(), kAll); });
}

}  // namespace
}  // namespace berm
