#include "berm/io/label_file.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

TEST(LabelFile, RoundTripOfRawLabels) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("any u32 survives", [&](const std::vector<std::uint32_t>& raw) {
    write_labels(folder / "scan.label", raw);
    RC_ASSERT(read_labels(folder / "scan.label", raw.size()) == raw);
  }));
}

TEST(LabelFile, WritesSemanticKittiIdsInLittleEndian) {
  const test::TempFolder folder;
  const std::array<Label, 6> labels = {Label::unlabeled, Label::no_return, Label::falling_snow,
                                       Label::drivable,  Label::terrain,   Label::obstacle};
  write_labels(folder / "scan.label", labels);
  EXPECT_EQ(read_labels(folder / "scan.label", labels.size()), (std::vector<std::uint32_t>{0, 0, 110, 40, 72, 99}));
  EXPECT_EQ(test::slurp(folder / "scan.label").substr(8, 4), std::string("\x6e\0\0\0", 4));
}

TEST(LabelFile, SplitsClassAndInstance) {
  constexpr std::uint32_t kRaw = 0x0007'0028;
  static_assert(semantic_class(kRaw) == 40);
  static_assert(semantic_instance(kRaw) == 7);
}

TEST(LabelFile, RefusesAnotherNumberOfLabels) {
  const std::vector<std::byte> bytes(12);
  EXPECT_EQ(parse_labels(bytes, "scan.label", 3).size(), 3U);
  EXPECT_EQ(parse_labels(bytes, "scan.label", std::nullopt).size(), 3U);
  expect_file_error(ErrorCode::malformed, "scan.label: holds 3 labels for a scan of 4 points",
                    [&] { (void)parse_labels(bytes, "scan.label", 4); });
  expect_file_error(ErrorCode::malformed, "holds 0 labels for a scan of 1 points",
                    [&] { (void)parse_labels({}, "scan.label", 1); });
}

TEST(LabelFile, RefusesAPartOfALabel) {
  const std::vector<std::byte> bytes(14);
  expect_file_error(ErrorCode::truncated, "at byte 12: 2 bytes left",
                    [&] { (void)parse_labels(bytes, "scan.label", std::nullopt); });
}

}  // namespace
}  // namespace berm
