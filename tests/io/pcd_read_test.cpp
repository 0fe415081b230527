#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/io/pcd.hpp"
#include "support/file_error.hpp"
#include "support/made_pcd.hpp"

namespace berm {
namespace {

using test::expect_file_error;
using test::made_xyz;
using test::MadeField;
using test::MadePcd;

ScanRecord parse(const std::string& bytes) {
  return parse_pcd(test::as_bytes(bytes), "scan.pcd");
}

bool has_note(const ScanRecord& record, const std::string& part) {
  return std::any_of(record.notes.begin(), record.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

class PcdEncodings : public testing::TestWithParam<const char*> {};

TEST_P(PcdEncodings, EveryTypeForEveryChannel) {
  const std::vector<std::pair<char, std::size_t>> types = {{'F', 4}, {'F', 8}, {'I', 1}, {'U', 1}, {'I', 2},
                                                           {'U', 2}, {'I', 4}, {'U', 4}, {'I', 8}, {'U', 8}};
  for (const auto& [type, size] : types) {
    MadePcd pcd{.fields = {{"x", type, size, 1, {1, 2, 3}},
                           {"y", type, size, 1, {4, 5, 6}},
                           {"z", type, size, 1, {type == 'U' ? 7.0L : -7.0L, 8, 127}},
                           {"intensity", type, size, 1, {9, 10, 0}},
                           {"ring", type, size, 1, {11, 0, 12}}},
                .points = 3};
    SCOPED_TRACE(pcd.fields[0].type + std::to_string(size));
    const ScanRecord record = parse(pcd.encoded(GetParam()));
    EXPECT_EQ(record.channels.x, (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(record.channels.y, (std::vector<float>{4, 5, 6}));
    EXPECT_EQ(record.channels.z, (std::vector<float>{type == 'U' ? 7.0F : -7.0F, 8, 127}));
    EXPECT_EQ(record.channels.intensity, (std::vector<float>{9, 10, 0}));
    EXPECT_EQ(record.channels.ring, (std::vector<std::uint16_t>{11, 0, 12}));
    EXPECT_EQ(has_note(record, "rounded"), type == 'F' && size == 8);
  }
}

TEST_P(PcdEncodings, AnyOrderWithPaddingBetween) {
  const MadePcd pcd{.fields = {{"_", 'U', 1, 3, {1, 1, 1, 1, 1, 1}},
                               {"ring", 'U', 1, 1, {5, 6}},
                               {"z", 'F', 8, 1, {0.5, 1.5}},
                               {"_", 'I', 2, 2, {-1, -1, -1, -1}},
                               {"x", 'F', 4, 1, {2.5, 3.5}},
                               {"normal", 'F', 4, 3, {9, 9, 9, 9, 9, 9}},
                               {"y", 'F', 4, 1, {4.5, 5.5}}},
                    .points = 2};
  const ScanRecord record = parse(pcd.encoded(GetParam()));
  EXPECT_EQ(record.channels.x, (std::vector<float>{2.5F, 3.5F}));
  EXPECT_EQ(record.channels.y, (std::vector<float>{4.5F, 5.5F}));
  EXPECT_EQ(record.channels.z, (std::vector<float>{0.5F, 1.5F}));
  EXPECT_EQ(record.channels.ring, (std::vector<std::uint16_t>{5, 6}));
  EXPECT_TRUE(record.channels.intensity.empty());
  EXPECT_EQ(record.fields, (std::vector<std::string>{"_", "ring", "z", "_", "x", "normal", "y"}));
}

TEST_P(PcdEncodings, MoreThanOneBlock) {
  const ScanRecord record = parse(made_xyz(5000).encoded(GetParam()));
  ASSERT_EQ(record.channels.z.size(), 5000U);
  for (std::size_t i = 0; i < 5000; ++i) {
    ASSERT_EQ(record.channels.y[i], static_cast<float>(i));
  }
}

TEST_P(PcdEncodings, NoPoints) {
  MadePcd pcd = made_xyz(0);
  EXPECT_TRUE(parse(pcd.encoded(GetParam())).channels.x.empty());
}

TEST_P(PcdEncodings, RingThatIsNoRingIsLeftOut) {
  for (const long double bad : {-1.0L, 65536.0L, 2.5L}) {
    MadePcd pcd = made_xyz(2);
    pcd.fields.push_back({"ring", 'F', 8, 1, {3, bad}});
    const ScanRecord record = parse(pcd.encoded(GetParam()));
    EXPECT_TRUE(record.channels.ring.empty());
    EXPECT_TRUE(has_note(record, "1 points hold no whole number"));
  }
  MadePcd pcd = made_xyz(2);
  pcd.fields.push_back({"ring", 'U', 4, 1, {0, 65535}});
  EXPECT_EQ(parse(pcd.encoded(GetParam())).channels.ring, (std::vector<std::uint16_t>{0, 65535}));
}

TEST_P(PcdEncodings, LabelsAreSemanticKittiIds) {
  MadePcd pcd = made_xyz(6);
  pcd.fields.push_back({"label", 'U', 4, 1, {0, 110, 40, 72, 99, 50}});
  const ScanRecord record = parse(pcd.encoded(GetParam()));
  EXPECT_EQ(record.channels.label, (std::vector<Label>{Label::unlabeled, Label::falling_snow, Label::drivable,
                                                       Label::terrain, Label::obstacle, Label::unlabeled}));
  EXPECT_TRUE(has_note(record, "1 points have a label"));
}

TEST_P(PcdEncodings, DoublesBeyondFloatBecomeInfinite) {
  MadePcd pcd = made_xyz(3);
  pcd.fields[0] = {"x", 'F', 8, 1, {1e300L, -1e300L, 1e-300L}};
  const ScanRecord record = parse(pcd.encoded(GetParam()));
  EXPECT_EQ(record.channels.x[0], std::numeric_limits<float>::infinity());
  EXPECT_EQ(record.channels.x[1], -std::numeric_limits<float>::infinity());
  EXPECT_EQ(record.channels.x[2], 0.0F);
}

INSTANTIATE_TEST_SUITE_P(All, PcdEncodings, testing::Values("ascii", "binary", "binary_compressed"),
                         [](const auto& test_info) { return std::string(test_info.param); });

TEST(PcdFields, PrefersCalibratedReflectivity) {
  MadePcd pcd = made_xyz(1);
  pcd.fields.push_back({"intensity", 'F', 4, 1, {4000}});
  pcd.fields.push_back({"Reflectivity", 'U', 2, 1, {17}});
  const ScanRecord record = parse(pcd.binary());
  EXPECT_EQ(record.channels.intensity, std::vector<float>{17});
  EXPECT_TRUE(has_note(record, "reflectivity"));
  MadePcd short_name = made_xyz(1);
  short_name.fields.push_back({"i", 'U', 1, 1, {200}});
  EXPECT_EQ(parse(short_name.binary()).channels.intensity, std::vector<float>{200});
}

TEST(PcdFields, RingGoesByItsOtherNames) {
  for (const char* name : {"line", "channel", "RING"}) {
    MadePcd pcd = made_xyz(1);
    pcd.fields.push_back({name, 'U', 1, 1, {3}});
    EXPECT_EQ(parse(pcd.binary()).channels.ring, std::vector<std::uint16_t>{3}) << name;
  }
}

TEST(PcdFields, OptionalFieldWithACountIsLeftOut) {
  MadePcd pcd = made_xyz(1);
  pcd.fields.push_back({"intensity", 'F', 4, 2, {3, 4}});
  const ScanRecord record = parse(pcd.binary());
  EXPECT_TRUE(record.channels.intensity.empty());
  EXPECT_TRUE(has_note(record, "field intensity (F4, COUNT 2) was left out"));
}

TEST(PcdFields, RefusesWhatHasNoCoordinates) {
  MadePcd pcd = made_xyz(1);
  pcd.fields.pop_back();
  expect_file_error(ErrorCode::unsupported, "no field z", [&] { (void)parse(pcd.binary()); });
  pcd.fields.push_back({"y", 'F', 4, 1, {1}});
  expect_file_error(ErrorCode::malformed, "two fields are called y", [&] { (void)parse(pcd.binary()); });
}

const std::string kSmall =
    "# a comment\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n";

void expect_small(const std::string& bytes) {
  const ScanRecord record = parse(bytes);
  EXPECT_EQ(record.channels.x, (std::vector<float>{1, 4}));
  EXPECT_EQ(record.channels.y, (std::vector<float>{2, 5}));
  EXPECT_EQ(record.channels.z, (std::vector<float>{3, 6}));
}

TEST(PcdHeader, TakesTheQuirksOfOtherPrograms) {
  expect_small(kSmall);
  expect_small(replaced(kSmall, "VERSION 0.7", "VERSION .7"));
  expect_small(replaced(kSmall, "VERSION 0.7", "VERSION v.7"));
  expect_small(replaced(kSmall, "VERSION 0.7\n", ""));
  expect_small(replaced(kSmall, "VIEWPOINT 0 0 0 1 0 0 0\n", ""));
  expect_small(replaced(kSmall, "COUNT 1 1 1\n", ""));
  expect_small(replaced(kSmall, "POINTS 2\n", ""));
  expect_small(replaced(kSmall, "WIDTH 2\nHEIGHT 1\n", ""));
  expect_small(replaced(kSmall, "FIELDS", "COLUMNS"));
  expect_small(replaced(kSmall, "FIELDS x y z", "\n# between\n  FIELDS\tx  y z  "));
  expect_small(replaced(kSmall, "1 2 3\n", "\n# one\n\t1  2\t3 \n\n"));
  std::string crlf;
  for (const char c : kSmall) {
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  expect_small(crlf);
}

TEST(PcdHeader, NotesWhatItIgnores) {
  EXPECT_TRUE(parse(kSmall).notes.empty());
  const std::string zero_width = replaced(kSmall, "WIDTH 2\nHEIGHT 1", "WIDTH 0\nHEIGHT 0");
  expect_small(zero_width);
  EXPECT_TRUE(has_note(parse(zero_width), "WIDTH 0 and HEIGHT 0 were ignored, POINTS says 2"));
  EXPECT_TRUE(has_note(parse(replaced(kSmall, "0 0 0 1", "5 0 0 1")), "VIEWPOINT was ignored"));
  EXPECT_TRUE(has_note(parse(kSmall + "7 8 9\n"), "after the 2 points of the header were ignored, from line 14"));
  EXPECT_TRUE(has_note(parse(kSmall.substr(0, kSmall.size() - 1)), "no line end"));
  EXPECT_TRUE(has_note(parse(made_xyz(2).binary() + "rest"), "4 bytes after the last point were ignored"));
  EXPECT_TRUE(has_note(parse(made_xyz(2).binary_compressed() + "rest"), "4 bytes after the last point"));
}

TEST(PcdHeader, SaysWhatContradictsWhat) {
  const auto refused = [&](ErrorCode code, const std::string& from, const std::string& to, const std::string& part) {
    SCOPED_TRACE(to);
    expect_file_error(code, part, [&] { (void)parse(replaced(kSmall, from, to)); });
  };
  refused(ErrorCode::malformed, "WIDTH 2", "WIDTH 3", "WIDTH 3 x HEIGHT 1 contradicts POINTS 2");
  refused(ErrorCode::malformed, "WIDTH 2\nHEIGHT 1", "WIDTH 281474976710655\nHEIGHT 281474976710655", "contradicts");
  refused(ErrorCode::malformed, "WIDTH 2\n", "WIDTH 2\nWIDTH 2\n", "at byte 79: PCD header: a second line WIDTH");
  refused(ErrorCode::malformed, "WIDTH 2", "WIDHT 2", "'WIDHT' is no key");
  refused(ErrorCode::malformed, "WIDTH 2", "WIDTH -2", "'-2' where a whole number");
  refused(ErrorCode::malformed, "SIZE 4 4 4", "SIZE 4 4", "SIZE has 2 values for 3 fields");
  refused(ErrorCode::malformed, "SIZE 4 4 4", "SIZE 4 3 4", "type 'F' and size 3");
  refused(ErrorCode::malformed, "TYPE F F F", "TYPE F f F", "type 'f'");
  refused(ErrorCode::malformed, "COUNT 1 1 1", "COUNT 1 0 1", "'0' where a whole number from 1");
  refused(ErrorCode::malformed, "COUNT 1 1 1", "COUNT 1 1 18446744073709551617", "where a whole number");
  refused(ErrorCode::malformed, "TYPE F F F\n", "", "TYPE is missing");
  refused(ErrorCode::malformed, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 0 0 0 1 0 0 q", "VIEWPOINT holds 'q'");
  refused(ErrorCode::malformed, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 0", "VIEWPOINT has 1 values");
  refused(ErrorCode::unsupported, "VERSION 0.7", "VERSION 0.8", "VERSION");
  refused(ErrorCode::unsupported, "DATA ascii", "DATA zip", "DATA is none of");
  refused(ErrorCode::truncated, "DATA ascii\n1 2 3\n4 5 6\n", "", "ends before a DATA line");
}

TEST(PcdAscii, SaysLineAndValue) {
  const auto refused = [&](ErrorCode code, const std::string& to, const std::string& part) {
    SCOPED_TRACE(to);
    expect_file_error(code, part, [&] { (void)parse(replaced(kSmall, "4 5 6\n", to)); });
  };
  refused(ErrorCode::truncated, "", "room for at most 1 of 2 points");
  refused(ErrorCode::truncated, "#5 67\n", "line 13: the file ends after 1 of 2 points");
  refused(ErrorCode::malformed, "4 5   \n", "line 13: ends before field 'z', expected 3 values");
  refused(ErrorCode::malformed, "4 5 6 7\n", "line 13: '7' follows the last of 3 values");
  refused(ErrorCode::malformed, "4 5 6,0\n", "line 13: '6,0' is no value of type F4 for field 'z'");
  refused(ErrorCode::malformed, "4 5 -\n", "'-' is no value");
}

TEST(PcdAscii, TakesEverySpellingOfNumbers) {
  const ScanRecord record = parse(replaced(kSmall, "1 2 3\n4 5 6\n", "nan -inf +1.5e1\n1e50 -1e-50 -.5\n"));
  EXPECT_TRUE(std::isnan(record.channels.x[0]));
  EXPECT_EQ(record.channels.y[0], -std::numeric_limits<float>::infinity());
  EXPECT_EQ(record.channels.z[0], 15.0F);
  EXPECT_EQ(record.channels.x[1], std::numeric_limits<float>::infinity());
  EXPECT_EQ(record.channels.y[1], 0.0F);
  EXPECT_EQ(record.channels.z[1], -0.5F);
}

TEST(PcdCounts, ThatLieAreRefusedBeforeMemoryIsTaken) {
  const auto huge = [](std::string bytes) {
    return replaced(replaced(std::move(bytes), "WIDTH 2", "WIDTH 200000000000"), "POINTS 2", "POINTS 200000000000");
  };
  expect_file_error(ErrorCode::truncated, "room for at most 2 of 200000000000 points",
                    [&] { (void)parse(huge(made_xyz(2).ascii())); });
  expect_file_error(ErrorCode::truncated, "2 of 200000000000 points of 12 bytes",
                    [&] { (void)parse(huge(made_xyz(2).binary())); });
  expect_file_error(ErrorCode::malformed, "200000000000 points of 12 bytes are expected",
                    [&] { (void)parse(huge(made_xyz(2).binary_compressed())); });
}

TEST(PcdCompressed, SizesThatLieAreRefused) {
  const std::string good = made_xyz(100).binary_compressed();
  const std::size_t body = good.find("DATA binary_compressed\n") + 23;
  const auto with = [&](std::size_t offset, std::uint32_t value) {
    std::string bytes = good;
    bytes.replace(body + offset, 4, reinterpret_cast<const char*>(&value), 4);
    return bytes;
  };
  expect_file_error(ErrorCode::truncated, "of 4000000000 bytes of compressed data",
                    [&] { (void)parse(with(0, 4'000'000'000)); });
  expect_file_error(ErrorCode::malformed, "announces 1201 bytes", [&] { (void)parse(with(4, 1201)); });
  expect_file_error(ErrorCode::malformed, "more than 0 compressed bytes can become", [&] { (void)parse(with(0, 0)); });
  expect_file_error(ErrorCode::malformed, "damaged (LZF)", [&] { (void)parse(with(0, 60)); });
  expect_file_error(ErrorCode::truncated, "two sizes", [&] { (void)parse(good.substr(0, body + 7)); });
}

TEST(PcdCompressed, BombIsRefusedBeforeMemoryIsTaken) {
  // 1.4 MB of zeros packed by hand would become 120 MB: possible for LZF, but beyond 4 times the file plus 64 MiB.
  constexpr std::size_t kPoints = 10'000'000;
  MadePcd pcd = made_xyz(0);
  pcd.points = kPoints;
  std::string bytes = pcd.header("binary_compressed");
  const std::uint32_t packed = 1'400'000;
  const std::uint32_t plain = 12 * kPoints;
  bytes.append(reinterpret_cast<const char*>(&packed), 4).append(reinterpret_cast<const char*>(&plain), 4);
  bytes.append(packed, '\0');
  expect_file_error(ErrorCode::unsupported, "more than the allowed 4 times the file plus 64 MiB",
                    [&] { (void)parse(bytes); });
}

}  // namespace
}  // namespace berm
