#include <functional>
#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/io/edges_file.hpp"
#include "berm/io/height_raster.hpp"
#include "berm/io/sensor_sheet.hpp"
#include "berm/io/times_file.hpp"
#include "berm/io/trajectory_file.hpp"

// Small text files, cut at every length and with every bit flipped: what comes out is a value or one clear error.

namespace berm {
namespace {

using Parser = std::function<void(const std::string&)>;

struct TextFormat {
  std::string name;
  std::string good;
  Parser parse;
};

std::vector<TextFormat> text_formats() {
  return {
      {"times.txt", "# s\n0.000000\n0.103700\r\n2.074e-01\n",
       [](const std::string& text) {
         std::istringstream input(text);
         (void)read_times(input, "times.txt", std::numeric_limits<std::size_t>::max());
       }},
      {"path.tum", "# t x y z qx qy qz qw\n0.0 1.5 -2 3e1 0 0 0 1\n0.1 1 2 3 0.6 0 0 0.8\n",
       [](const std::string& text) {
         std::istringstream input(text);
         (void)read_tum(input, "path.tum");
       }},
      {"poses.txt", "1 0 0 0.5 0 1 0 0 0 0 1 -2\n0 -1 0 1e-3 1 0 0 0 0 0 1 0\n",
       [](const std::string& text) {
         std::istringstream input(text);
         (void)read_kitti_poses(input, "poses.txt");
       }},
      {"calib.txt", "P0: 7 0 6 0 0 7 1 0 0 0 1 0\nTr: 0 -1 0 0.1 0 0 -1 0.2 1 0 0 0.3\n",
       [](const std::string& text) {
         std::istringstream input(text);
         (void)read_kitti_calibration(input, "calib.txt");
       }},
      {"edges.csv", "side,x,y,z\nleft,0.5,1,-2\nleft,1,1,2\n\nright,0,-1,2\nright,1,-1,2\n",
       [](const std::string& text) {
         std::istringstream input(text);
         (void)read_edges(input, "edges.csv");
       }},
      {"model.asc", "ncols 2\nnrows 2\nxllcorner 1.5\nyllcorner -3\ncellsize 5\nNODATA_value -9\n1 2.5\n-9 4\n",
       [](const std::string& text) { (void)parse_ascii_grid(text, "model.asc"); }},
      {"sequence.json", R"({"scan_hz": 10, "sensor": "Mid-70", "sensor_height_m": 2.3, "x": [1, {"y": null}]})",
       [](const std::string& text) { (void)parse_sensor_sheet(text, "sequence.json"); }},
  };
}

/// Whether `text` was refused; anything but a FileError that names the file fails the test.
bool is_refused(const TextFormat& format, const std::string& text) {
  try {
    format.parse(text);
    return false;
  } catch (const FileError& error) {
    EXPECT_EQ(error.file(), format.name);
    EXPECT_GT(std::string(error.what()).size(), format.name.size() + 10) << "an error that says nothing";
    return true;
  }
}

TEST(TextFaults, GoodFilesAreRead) {
  for (const TextFormat& format : text_formats()) {
    EXPECT_FALSE(is_refused(format, format.good)) << format.name;
  }
}

TEST(TextFaults, TruncationAtEveryLength) {
  for (const TextFormat& format : text_formats()) {
    std::size_t refused = 0;
    for (std::size_t length = 0; length < format.good.size(); ++length) {
      refused += is_refused(format, format.good.substr(0, length)) ? 1U : 0U;
    }
    // A times.txt that lost digits still holds numbers; the other formats notice nearly every cut.
    EXPECT_GT(refused, format.name == "times.txt" ? 2U : format.good.size() / 3) << format.name;
  }
}

TEST(TextFaults, EverySingleBitFlipped) {
  for (const TextFormat& format : text_formats()) {
    std::size_t refused = 0;
    for (std::size_t bit = 0; bit < 8 * format.good.size(); ++bit) {
      std::string text = format.good;
      text[bit / 8] = static_cast<char>(static_cast<unsigned char>(text[bit / 8]) ^ (1U << (bit % 8)));
      refused += is_refused(format, text) ? 1U : 0U;
    }
    EXPECT_GT(refused, format.good.size()) << format.name;
  }
}

TEST(TextFaults, EveryByteReplacedByAwkwardOnes) {
  for (const TextFormat& format : text_formats()) {
    for (std::size_t place = 0; place < format.good.size(); ++place) {
      for (const char awkward : {'\0', '\n', '\r', ' ', '-', '.', 'e', '9', '#', '"', '[', '{', '\x7f', '\xff'}) {
        std::string text = format.good;
        text[place] = awkward;
        (void)is_refused(format, text);
      }
    }
  }
}

TEST(TextFaults, NumbersAtTheEndsOfDouble) {
  for (const char* number :
       {"1e308", "-1e308", "1.7976931348623157e308", "5e-324", "1e-400", "-0", "1e400", "NaN", "-nan", "Infinity",
        "00000000000000000000000000000001", "0.000000000000000000000000000000000001"}) {
    for (const TextFormat& format : text_formats()) {
      for (std::size_t place = format.good.find_first_of("0123456789"); place != std::string::npos;
           place = format.good.find_first_of("0123456789", place + 1)) {
        std::string text = format.good;
        text.replace(place, 1, number);
        (void)is_refused(format, text);
      }
    }
  }
}

TEST(TextFaults, NoLineEndsAndManyLineEnds) {
  for (const TextFormat& format : text_formats()) {
    (void)is_refused(format, std::string(1'000'000, '\n'));
    EXPECT_TRUE(format.name == "sequence.json" || is_refused(format, std::string(1'000'000, '1'))) << format.name;
    (void)is_refused(format, std::string(1'000'000, '#'));
  }
}

}  // namespace
}  // namespace berm
