#include <algorithm>
#include <array>
#include <exception>
#include <optional>

#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/edge_lines_file.hpp"
#include "berm/io/foxglove.hpp"
#include "berm/io/mcap_writer.hpp"
#include "berm/view/export_run.hpp"
#include "berm/view/points_payload.hpp"
#include "byte_writer.hpp"
#include "label_colors.hpp"

namespace berm {
namespace {

constexpr const char* kWorld = "map";
constexpr const char* kBase = "base_link";

/// What a point is made of: Foxglove draws red, green, blue, alpha as they are.
constexpr std::array<PackedField, 10> kFields = {{{"x", 0, PackedType::float32},
                                                  {"y", 4, PackedType::float32},
                                                  {"z", 8, PackedType::float32},
                                                  {"red", 12, PackedType::uint8},
                                                  {"green", 13, PackedType::uint8},
                                                  {"blue", 14, PackedType::uint8},
                                                  {"alpha", 15, PackedType::uint8},
                                                  {"intensity", 16, PackedType::uint8},
                                                  {"label", 17, PackedType::uint8},
                                                  {"ring", 18, PackedType::uint16}}};
constexpr std::uint32_t kStride = 20;

class FoxgloveExport {
 public:
  FoxgloveExport(const ShownRun& run, const std::filesystem::path& file) : run_(run), file_(file) {
    const std::string schemas = foxglove_schemas();
    const auto channel = [&](const char* schema, const char* topic) {
      return file_.add_channel(file_.add_schema(schema, "protobuf", schemas), topic, "protobuf");
    };
    points_ = channel(kFoxglovePointCloud, "/points");
    transforms_ = channel(kFoxgloveFrameTransform, "/tf");
    poses_ = channel(kFoxglovePoseInFrame, "/pose");
    edges_ = channel(kFoxgloveSceneUpdate, "/edges");
  }

  /// Throws FileError.
  void write_scan(std::size_t index, ExportSummary& summary) {
    run_.read(index, scan_);
    write_edges();
    if (const std::optional<Pose> T_world_base = run_.trajectory().at(scan_.stamp_ns)) {
      put(transforms_, encode_frame_transform(scan_.stamp_ns, kWorld, kBase, *T_world_base));
      put(poses_, encode_pose(scan_.stamp_ns, kWorld, *T_world_base));
    }
    const std::string points = pack();
    put(points_, encode_point_cloud(scan_.stamp_ns, kBase, kStride, kFields, points));
    summary.points += points.size() / kStride;
    ++summary.scans;
  }

  void commit() { file_.commit(); }

 private:
  /// MCAP knows no time before the epoch.
  void put(std::uint16_t channel, const std::string& message) {
    file_.write(channel, static_cast<std::uint64_t>(std::max<Stamp>(scan_.stamp_ns, 0)), message);
  }

  /// Once, at the time of the first scan: lines stay until others take their place.
  void write_edges() {
    const auto file = run_.is_run() && !edges_written_ ? run_.find_file("edges.csv") : std::nullopt;
    edges_written_ = true;
    if (file) {
      put(edges_, encode_edge_scene(scan_.stamp_ns, kWorld, read_edge_lines(*file)));
    }
  }

  [[nodiscard]] std::string pack() const {
    const PointsView points = scan_.cloud.view();
    const Eigen::Matrix3f R = scan_.T_base_sensor.rotation().toRotationMatrix().cast<float>();
    const Eigen::Vector3f t_m = scan_.T_base_sensor.translation_m().cast<float>();
    std::string packed;
    packed.reserve(points.size() * kStride);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_in_payload(points.x[i], points.y[i], points.z[i])) {
        continue;
      }
      const Eigen::Vector3f p_m = R * Eigen::Vector3f(points.x[i], points.y[i], points.z[i]) + t_m;
      append_array<float>(packed, {p_m.data(), 3});
      const Label label = points.label.empty() ? Label::unlabeled : points.label[i];
      append_array<std::uint8_t>(packed, colors_[static_cast<std::size_t>(label)]);
      append_bytes(packed, std::uint8_t{255});
      const float intensity = points.intensity.empty() ? 0.0F : std::clamp(points.intensity[i], 0.0F, 255.0F);
      append_bytes(packed, static_cast<std::uint8_t>(intensity));
      append_bytes(packed, static_cast<std::uint8_t>(label));
      append_bytes(packed, points.ring.empty() ? std::uint16_t{0} : points.ring[i]);
    }
    return packed;
  }

  const ShownRun& run_;
  McapWriter file_;
  LabelColors colors_ = dark_label_colors();
  std::uint16_t points_ = 0;
  std::uint16_t transforms_ = 0;
  std::uint16_t poses_ = 0;
  std::uint16_t edges_ = 0;
  bool edges_written_ = false;
  Scan scan_;
};

}  // namespace

ExportSummary export_foxglove(const ShownRun& run, const std::filesystem::path& file, const ExportOptions& options) {
  FoxgloveExport mcap(run, file);
  ExportSummary summary;
  std::exception_ptr first_error;
  for (std::size_t i = 0; i < run.size(); i += options.every) {
    try {
      mcap.write_scan(i, summary);
    } catch (const FileError& error) {
      if (error.code() == ErrorCode::write_failed) {
        throw;
      }
      first_error = first_error ? first_error : std::current_exception();
      ++summary.skipped;
    }
    if (options.on_progress) {
      options.on_progress(i + 1, run.size());
    }
    if (options.should_stop && options.should_stop()) {
      summary.interrupted = true;
      return summary;
    }
  }
  if (summary.scans == 0 && first_error) {
    std::rethrow_exception(first_error);
  }
  mcap.commit();
  return summary;
}

std::string foxglove_layout() {
  using LayoutJson = nlohmann::ordered_json;
  const LayoutJson points = {{"visible", true}, {"colorMode", "rgba-fields"}, {"colorField", "red"}, {"pointSize", 3}};
  const LayoutJson view = {
      {"followTf", kBase},
      {"followMode", "follow-pose"},
      {"topics", {{"/points", points}, {"/pose", {{"visible", true}}}, {"/edges", {{"visible", true}}}}},
      {"layers", {{"grid", {{"layerId", "foxglove.Grid"}, {"visible", true}, {"size", 100}}}}}};
  const LayoutJson layout = {{"configById", {{"3D!berm", view}}},
                             {"globalVariables", LayoutJson::object()},
                             {"userNodes", LayoutJson::object()},
                             {"playbackConfig", {{"speed", 1}}},
                             {"layout", "3D!berm"}};
  return layout.dump(2) + "\n";
}

}  // namespace berm
