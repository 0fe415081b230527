#include "view_piste.hpp"

#include <cmath>
#include <cstdint>
#include <span>

#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "berm/view/points_payload.hpp"

namespace berm::app {
namespace {

using Json = nlohmann::ordered_json;

/// The machine of a run, from its run.json.
Machine read_run_machine(const std::filesystem::path& file) {
  constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20U;
  FileBuffer buffer;
  read_file(file, buffer, kMaxBytes);
  const Json report = Json::parse(buffer.text(), nullptr, false);
  if (!report.is_object() || !report.contains("machine")) {
    throw FileError(ErrorCode::malformed, file.string(), std::nullopt, "expected a JSON object with machine");
  }
  Machine machine;
  for (const auto& section : report["machine"].items()) {
    for (const auto& value : section.value().items()) {
      const std::string text = value.value().is_string() ? value.value().get<std::string>() : value.value().dump();
      set_value(machine, section.key() + "." + value.key() + "=" + text, file.string());
    }
  }
  return machine;
}

/// Millimetres; null for what is no number.
Json rounded(std::span<const float> values) {
  Json list = Json::array();
  for (const float value : values) {
    list.push_back(std::isfinite(value) ? Json(std::round(double{value} * 1e3) / 1e3) : Json());
  }
  return list;
}

/// Samples where `flags` is not 0.
Json places_of(std::span<const std::uint8_t> flags) {
  Json list = Json::array();
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i] != 0) {
      list.push_back(i);
    }
  }
  return list;
}

/// Index of each point among those of /scans/{i}, -1 where it is not among them.
Json shown_places(const PointsView& points) {
  Json list = Json::array();
  std::int64_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    list.push_back(is_in_payload(points.x[i], points.y[i], points.z[i]) ? next++ : -1);
  }
  return list;
}

}  // namespace

std::optional<std::string> describe_piste(const ShownRun& run, std::size_t scan_index) {
  Pipeline pipeline(read_run_machine(run.folder() / "run.json"));
  Scan scan;
  run.recording().read(run.recording_index(scan_index), scan);
  scan.T_base_sensor = run.T_base_sensor();
  const ScanResult result = pipeline.process(scan);
  const PointsView points = scan.cloud.view();
  const bool has_series = result.series.size() == points.size();
  Json petals = Json::array();
  for (const Envelope& envelope : result.piste.envelopes) {
    petals.push_back({envelope.first, envelope.last});
  }
  const Json piste = {{"points", points.size()},
                      {"method", run.piste_method()},
                      {"first", 0},
                      {"x", rounded(has_series ? result.series.x : points.x)},
                      {"z", rounded(has_series ? result.series.z : points.z)},
                      {"intensity", points.intensity.empty() ? Json() : rounded(points.intensity)},
                      {"interpolated", has_series ? Json(std::vector<std::uint8_t>(result.series.interpolated.begin(),
                                                                                   result.series.interpolated.end()))
                                                  : Json()},
                      {"steps", places_of(result.piste.steps)},
                      {"petals", std::move(petals)},
                      {"shown", shown_places(points)}};
  return piste.dump();
}

}  // namespace berm::app
