#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <ogrsf_frmts.h>

#include "berm/io/edge_export.hpp"
#include "io/made_edges.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::made_datum;
using test::made_edges;

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;
using Feature = std::unique_ptr<OGRFeature>;

class EdgeExportGdalTest : public testing::Test {
 protected:
  Dataset exported(const std::string& name, EdgeFormat format, const std::vector<EdgeLine>& lines = made_edges()) {
    GDALAllRegister();
    export_edges(folder_ / name, format, lines, made_datum());
    return Dataset(
        GDALDataset::Open((folder_ / name).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  }

  /// Expects the lines of made_edges, in places on the earth.
  static void expect_geographic(OGRLayer& layer) {
    ASSERT_NE(layer.GetSpatialRef(), nullptr);
    EXPECT_STREQ(layer.GetSpatialRef()->GetAuthorityCode(nullptr), "4326");
    EXPECT_EQ(layer.GetFeatureCount(), 2);
    const LocalFrame frame(made_datum());
    const auto lines = made_edges();
    layer.ResetReading();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Feature feature(layer.GetNextFeature());
      ASSERT_NE(feature, nullptr);
      EXPECT_EQ(feature->GetFieldAsInteger64("line"), static_cast<GIntBig>(i));
      EXPECT_STREQ(feature->GetFieldAsString("side"), i == 0 ? "left" : "right");
      const OGRLineString& geometry = *feature->GetGeometryRef()->toLineString();
      ASSERT_EQ(geometry.getNumPoints(), static_cast<int>(lines[i].vertices.size()));
      for (int k = 0; k < geometry.getNumPoints(); ++k) {
        const Eigen::Vector3d local_m = frame.to_local_m({geometry.getY(k), geometry.getX(k), geometry.getZ(k)});
        EXPECT_LT((local_m - lines[i].vertices[static_cast<std::size_t>(k)].position_m).norm(), 0.01);
      }
    }
  }

  test::TempFolder folder_;
};

TEST_F(EdgeExportGdalTest, GeoPackageReadsBack) {
  const Dataset dataset = exported("edges.gpkg", EdgeFormat::gpkg);
  ASSERT_NE(dataset, nullptr);
  EXPECT_STREQ(dataset->GetDriver()->GetDescription(), "GPKG");
  OGRLayer* layer = dataset->GetLayerByName("road_edges");
  ASSERT_NE(layer, nullptr);
  expect_geographic(*layer);
  layer->ResetReading();
  const Feature feature(layer->GetNextFeature());
  EXPECT_EQ(nlohmann::json::parse(feature->GetFieldAsString("confidence")), (nlohmann::json{1.0, 0.75, 0.125}));
  EXPECT_EQ(feature->GetFieldAsDouble("min_confidence"), 0.125);
  EXPECT_EQ(nlohmann::json::parse(feature->GetFieldAsString("berm_height_m")), (nlohmann::json{1.25, 0.5, nullptr}));
  EXPECT_EQ(feature->GetFieldAsDouble("min_berm_height_m"), 0.5);
  const Feature unknown(layer->GetNextFeature());
  EXPECT_FALSE(unknown->IsFieldSetAndNotNull(unknown->GetFieldIndex("min_berm_height_m")));
}

TEST_F(EdgeExportGdalTest, GeoJsonReadsBack) {
  const Dataset dataset = exported("edges.geojson", EdgeFormat::geojson);
  ASSERT_NE(dataset, nullptr);
  OGRLayer& layer = *dataset->GetLayer(0);
  const Feature feature(layer.GetFeature(0));
  int count = 0;
  const double* confidence = feature->GetFieldAsDoubleList("confidence", &count);
  ASSERT_EQ(count, 3);
  EXPECT_EQ(confidence[1], 0.75);
  EXPECT_EQ(layer.GetFeatureCount(), 2);
}

TEST_F(EdgeExportGdalTest, DxfHoldsMetresOnALayerPerSide) {
  const Dataset dataset = exported("edges.dxf", EdgeFormat::dxf);
  ASSERT_NE(dataset, nullptr);
  OGRLayer& layer = *dataset->GetLayer(0);
  const auto lines = made_edges();
  ASSERT_EQ(layer.GetFeatureCount(), 2);
  layer.ResetReading();
  for (const EdgeLine& line : lines) {
    const Feature feature(layer.GetNextFeature());
    EXPECT_STREQ(feature->GetFieldAsString("Layer"),
                 line.side == EdgeSide::left ? "road_edge_left" : "road_edge_right");
    const OGRLineString& geometry = *feature->GetGeometryRef()->toLineString();
    ASSERT_EQ(geometry.getNumPoints(), static_cast<int>(line.vertices.size()));
    for (int k = 0; k < geometry.getNumPoints(); ++k) {
      const Eigen::Vector3d point_m(geometry.getX(k), geometry.getY(k), geometry.getZ(k));
      EXPECT_LT((point_m - line.vertices[static_cast<std::size_t>(k)].position_m).norm(), 1e-9);
    }
  }
}

TEST_F(EdgeExportGdalTest, NoLinesAreAFileToo) {
  EXPECT_EQ(exported("none.gpkg", EdgeFormat::gpkg, {})->GetLayerByName("road_edges")->GetFeatureCount(), 0);
  EXPECT_NE(exported("none.dxf", EdgeFormat::dxf, {}), nullptr);
}

TEST_F(EdgeExportGdalTest, ThreadsDoNotMeet) {
  const auto write = [&](const std::string& name) {
    for (int i = 0; i < 5; ++i) {
      export_edges(folder_ / (name + ".gpkg"), EdgeFormat::gpkg, made_edges(), made_datum());
      export_edges(folder_ / (name + ".dxf"), EdgeFormat::dxf, made_edges(), made_datum());
    }
  };
  std::thread other(write, "a");
  write("b");
  other.join();
  EXPECT_EQ(test::slurp(folder_ / "a.gpkg"), test::slurp(folder_ / "b.gpkg"));
  EXPECT_EQ(test::slurp(folder_ / "a.dxf"), test::slurp(folder_ / "b.dxf"));
}

TEST_F(EdgeExportGdalTest, OgrinfoOpensAll) {
  if (std::system("ogrinfo --version >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "needs ogrinfo (Debian: gdal-bin)";
  }
  const auto said = [&](const std::string& name) {
    const std::string command = "ogrinfo -al -so '" + (folder_ / name).string() + "' 2>&1";
    std::string text;
    FILE* pipe = ::popen(command.c_str(), "r");
    char part[512];
    while (pipe != nullptr && std::fgets(part, sizeof part, pipe) != nullptr) {
      text += part;
    }
    const int status = pipe == nullptr ? -1 : ::pclose(pipe);
    EXPECT_EQ(status, 0) << text;
    EXPECT_EQ(text.find("Warning"), std::string::npos) << text;
    return text;
  };
  (void)exported("edges.gpkg", EdgeFormat::gpkg);
  (void)exported("edges.geojson", EdgeFormat::geojson);
  (void)exported("edges.dxf", EdgeFormat::dxf);
  (void)exported("edges.osm", EdgeFormat::osm);
  for (const char* name : {"edges.gpkg", "edges.geojson", "edges.dxf"}) {
    EXPECT_NE(said(name).find("Feature Count: 2"), std::string::npos) << said(name);
  }
  EXPECT_NE(said("edges.gpkg").find("3D Line String"), std::string::npos);
  EXPECT_NE(said("edges.osm").find("Layer name: lines"), std::string::npos);
}

}  // namespace
}  // namespace berm
