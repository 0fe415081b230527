#include "berm/io/edge_export.hpp"

#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>
#include <sys/resource.h>

#include "berm/core/error.hpp"
#include "berm/io/edge_lines_file.hpp"
#include "io/made_edges.hpp"
#include "support/child_process.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using nlohmann::json;
using test::made_datum;
using test::made_edges;

/// A long line, so that files of every format are larger than 100 kB.
std::vector<EdgeLine> long_edge() {
  EdgeLine line;
  for (int i = 0; i < 5000; ++i) {
    line.vertices.push_back({{0.5 * i + 0.123, 20.0 * std::sin(0.01 * i), 0.01 * i}, 0.9});
  }
  return {line};
}

bool can_write(EdgeFormat format) {
  return !find_export_problem(format, true);
}

constexpr EdgeFormat kFormats[] = {EdgeFormat::csv, EdgeFormat::geojson, EdgeFormat::gpkg, EdgeFormat::dxf,
                                   EdgeFormat::osm};

/// RFC 7946, sections 3.1.1, 3.1.4, 3.2, 3.3, 4.
void expect_rfc_7946(const json& document) {
  ASSERT_TRUE(document.is_object());
  EXPECT_EQ(document.at("type"), "FeatureCollection");
  EXPECT_FALSE(document.contains("crs"));
  for (const char* key : {"geometry", "properties", "coordinates", "geometries"}) {
    EXPECT_FALSE(document.contains(key)) << key;
  }
  for (const json& feature : document.at("features")) {
    EXPECT_EQ(feature.at("type"), "Feature");
    ASSERT_TRUE(feature.at("properties").is_object());
    EXPECT_FALSE(feature.contains("coordinates"));
    const json& geometry = feature.at("geometry");
    EXPECT_EQ(geometry.at("type"), "LineString");
    EXPECT_FALSE(geometry.contains("properties"));
    ASSERT_GE(geometry.at("coordinates").size(), 2U);
    for (const json& position : geometry.at("coordinates")) {
      ASSERT_EQ(position.size(), 3U);
      EXPECT_LE(std::abs(position[0].get<double>()), 180.0);
      EXPECT_LE(std::abs(position[1].get<double>()), 90.0);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::string text = position[axis].dump();
        EXPECT_LE(text.size() - std::min(text.find('.') + 1, text.size()), 7U) << text;
      }
    }
    EXPECT_EQ(feature.at("properties").at("confidence").size(), geometry.at("coordinates").size());
    EXPECT_EQ(feature.at("properties").at("berm_height_m").size(), geometry.at("coordinates").size());
  }
}

json exported_geojson(const std::vector<EdgeLine>& lines, const Geodetic& datum) {
  const test::TempFolder folder;
  export_edges(folder / "edges.geojson", EdgeFormat::geojson, lines, datum);
  return json::parse(test::slurp(folder / "edges.geojson"));
}

TEST(GeoJson, IsThatOfTheRfcAndComesBackToTheMetre) {
  const json document = exported_geojson(made_edges(), made_datum());
  expect_rfc_7946(document);
  ASSERT_EQ(document.at("features").size(), 2U);
  const LocalFrame frame(made_datum());
  const auto lines = made_edges();
  for (std::size_t i = 0; i < 2; ++i) {
    const json& feature = document.at("features")[i];
    EXPECT_EQ(feature.at("properties").at("line"), i);
    EXPECT_EQ(feature.at("properties").at("side"), i == 0 ? "left" : "right");
    ASSERT_EQ(feature.at("geometry").at("coordinates").size(), lines[i].vertices.size());
    for (std::size_t k = 0; k < lines[i].vertices.size(); ++k) {
      const json& p = feature.at("geometry").at("coordinates")[k];
      const Eigen::Vector3d local_m = frame.to_local_m({p[1].get<double>(), p[0].get<double>(), p[2].get<double>()});
      EXPECT_LT((local_m - lines[i].vertices[k].position_m).norm(), 0.01);
      EXPECT_EQ(feature.at("properties").at("confidence")[k], lines[i].vertices[k].confidence);
    }
    EXPECT_EQ(feature.at("properties").at("berm_height_m"),
              i == 0 ? (json{1.25, 0.5, nullptr}) : (json{nullptr, nullptr}));
  }
  expect_rfc_7946(exported_geojson({}, made_datum()));
}

TEST(GeoJson, ALineAcrossTheDateLineIsCutThere) {
  EdgeLine line;
  line.vertices = {
      {{-100.0, 0.0, 0.0}, 1.0}, {{-10.0, 0.0, 0.0}, 0.5}, {{10.0, 20.0, 4.0}, 0.0}, {{50.0, 20.0, 4.0}, 0.0}};
  const json document = exported_geojson({line}, {-17.0, 180.0, 10.0});
  expect_rfc_7946(document);
  ASSERT_EQ(document.at("features").size(), 2U);
  const json& west = document.at("features")[0].at("geometry").at("coordinates");
  const json& east = document.at("features")[1].at("geometry").at("coordinates");
  ASSERT_EQ(west.size(), 3U);
  ASSERT_EQ(east.size(), 3U);
  EXPECT_EQ(west[2][0], 180.0);
  EXPECT_EQ(east[0][0], -180.0);
  EXPECT_EQ(west[2][1], east[0][1]);
  EXPECT_NEAR(west[2][2].get<double>(), 12.0, 0.01);
  EXPECT_GT(west[1][0].get<double>(), 179.0);
  EXPECT_LT(east[1][0].get<double>(), -179.0);
  EXPECT_NEAR(document.at("features")[0].at("properties").at("confidence")[2].get<double>(), 0.25, 0.001);
  EXPECT_EQ(document.at("features")[1].at("properties").at("line"), 0);
}

TEST(LaneletOsm, HoldsRoadBordersWithNumbersOfTheirOwn) {
  const test::TempFolder folder;
  export_edges(folder / "edges.osm", EdgeFormat::osm, made_edges(), made_datum());
  const std::string text = test::slurp(folder / "edges.osm");
  const auto count = [&](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("<node "), 5U);
  EXPECT_EQ(count("<tag k=\"ele\" v=\"5"), 5U);
  EXPECT_EQ(count("<way "), 2U);
  EXPECT_EQ(count("<tag k=\"type\" v=\"road_border\"/>"), 2U);
  EXPECT_EQ(count("<tag k=\"side\" v=\"left\"/>"), 1U);
  EXPECT_EQ(count("<tag k=\"berm_height\" v=\""), 2U);
  EXPECT_EQ(count("<nd ref="), 5U);
  EXPECT_NE(text.find("<way id=\"6\" visible=\"true\" version=\"1\">\n    <nd ref=\"1\"/>\n    <nd ref=\"2\"/>"),
            std::string::npos);
  EXPECT_NE(text.find("<way id=\"7\" visible=\"true\" version=\"1\">\n    <nd ref=\"4\"/>"), std::string::npos);
  // 5.125 m north of 48 deg, at 592 m: 5.125 / (6,371,300 m) in radians.
  const std::size_t lat = text.find("lat=\"") + 5;
  EXPECT_NEAR(std::stod(text.substr(lat)), 48.0 + 5.125 / 6'371'300.0 * 180.0 / 3.14159265358979, 3e-9);
}

TEST(LaneletOsm, PassesTheSchema) {
  if (std::system("xmllint --version >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "needs xmllint (Debian: libxml2-utils)";
  }
  const test::TempFolder folder;
  const auto passes = [&](const std::string& file) {
    const std::string command =
        "xmllint --noout --nonet --schema '" BERM_OSM_SCHEMA "' '" + (folder / file).string() + "' >/dev/null 2>&1";
    return std::system(command.c_str()) == 0;
  };
  export_edges(folder / "edges.osm", EdgeFormat::osm, made_edges(), made_datum());
  EXPECT_TRUE(passes("edges.osm"));
  export_edges(folder / "none.osm", EdgeFormat::osm, {}, made_datum());
  EXPECT_TRUE(passes("none.osm"));
  std::string spoilt = test::slurp(folder / "edges.osm");
  spoilt.replace(spoilt.find("<nd ref=\"1\"/>"), 13, "<nd ref=\"99\"/>");
  test::spill(folder / "spoilt.osm", spoilt);
  EXPECT_FALSE(passes("spoilt.osm"));
}

TEST(EdgeExport, WithoutADatumThereIsNoGeographicFile) {
  const test::TempFolder folder;
  for (const EdgeFormat format : {EdgeFormat::geojson, EdgeFormat::gpkg, EdgeFormat::osm}) {
    try {
      export_edges(folder / "edges", format, made_edges(), std::nullopt);
      ADD_FAILURE() << "was written";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::unsupported);
      EXPECT_NE(std::string(error.what()).find("datum.origin: given"), std::string::npos) << error.what();
    }
  }
  EXPECT_TRUE(folder.names().empty());
  export_edges(folder / "edges.csv", EdgeFormat::csv, made_edges(), std::nullopt);
  EXPECT_EQ(read_edge_lines(folder / "edges.csv").size(), 2U);
  EXPECT_FALSE(find_export_problem(EdgeFormat::csv, false));
  EXPECT_FALSE(find_export_problem(EdgeFormat::geojson, true));
}

TEST(EdgeExport, WithoutGdalTheRestIsWritten) {
  const auto problem = find_export_problem(EdgeFormat::dxf, false);
#ifdef BERM_WITH_GDAL
  EXPECT_FALSE(problem);
#else
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("libgdal-dev"), std::string::npos);
  const test::TempFolder folder;
  EXPECT_THROW(export_edges(folder / "edges.dxf", EdgeFormat::dxf, made_edges(), std::nullopt), Error);
  EXPECT_TRUE(folder.names().empty());
#endif
}

TEST(EdgeExport, ProjectedCoordinatesAreNoLocalFrame) {
  std::vector<EdgeLine> lines = made_edges();
  lines[1].vertices[1].position_m = {691'607.0, 5'334'760.0, 520.0};
  const test::TempFolder folder;
  try {
    export_edges(folder / "edges.geojson", EdgeFormat::geojson, lines, made_datum());
    ADD_FAILURE() << "was written";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("line 1 lies 5379 km from the datum"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(EdgeExport, TheNameTellsTheFormat) {
  EXPECT_EQ(edge_format_of("a/edges.GeoJSON"), EdgeFormat::geojson);
  EXPECT_EQ(edge_format_of("edges.json"), EdgeFormat::geojson);
  EXPECT_EQ(edge_format_of("edges.gpkg"), EdgeFormat::gpkg);
  EXPECT_EQ(edge_format_of("edges.dxf"), EdgeFormat::dxf);
  EXPECT_EQ(edge_format_of("edges.osm"), EdgeFormat::osm);
  EXPECT_EQ(edge_format_of("edges.csv"), EdgeFormat::csv);
  EXPECT_FALSE(edge_format_of("edges.shp"));
  EXPECT_FALSE(edge_format_of("edges"));
}

TEST(EdgeExport, SameLinesAreTheSameBytes) {
  const test::TempFolder folder;
  for (const EdgeFormat format : kFormats) {
    if (!can_write(format)) {
      continue;
    }
    export_edges(folder / "one", format, made_edges(), made_datum());
    export_edges(folder / "two", format, made_edges(), made_datum());
    EXPECT_EQ(test::slurp(folder / "one"), test::slurp(folder / "two")) << static_cast<int>(format);
    EXPECT_GT(test::slurp(folder / "one").size(), 100U);
    EXPECT_EQ(folder.names().size(), 2U);
  }
}

TEST(EdgeExport, AFullDiskLeavesTheOldFile) {
  const test::TempFolder folder;
  for (const EdgeFormat format : kFormats) {
    if (!can_write(format)) {
      continue;
    }
    SCOPED_TRACE(static_cast<int>(format));
    test::expect_file_error(ErrorCode::write_failed, "free some space",
                            [&] { export_edges("/dev/full", format, made_edges(), made_datum()); });
    test::spill(folder / "edges", "old");
    const int result = test::run_in_child([&] {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{50'000, 50'000};
      if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) {
        return 1;
      }
      try {
        export_edges(folder / "edges", format, long_edge(), made_datum());
      } catch (const FileError& error) {
        return error.code() == ErrorCode::write_failed ? 0 : 2;
      }
      return 3;
    });
    EXPECT_EQ(result, 0);
    EXPECT_EQ(test::slurp(folder / "edges"), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"edges"});
  }
}

}  // namespace
}  // namespace berm
