#include "berm/view/view_api.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/trajectory_file.hpp"
#include "berm/view/points_payload.hpp"
#include "layers.hpp"
#include "map_layer.hpp"

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMapFolder = "map";
constexpr const char* kMapIndex = "map/tiles.json";
constexpr const char* kGlobalTrajectory = "trajectory_global.tum";

/// Numbers of Label; see docs/view_api.md.
constexpr std::array<const char*, 6> kLabelNames = {"unlabeled", "no_return", "falling_snow",
                                                    "drivable",  "terrain",   "obstacle"};

std::string dump(const Json& json) {
  // Names of files may hold any bytes; what is no UTF-8 is replaced.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// One origin for all runs whose worlds are near each other, so that they can be laid over each other.
std::vector<Eigen::Vector3d> choose_origins(const std::vector<ShownRun>& runs) {
  constexpr double kNear_m = 10'000.0;  // a float has steps of 1 mm there
  std::vector<Eigen::Vector3d> origins_m;
  std::vector<Eigen::Vector3d> known_m = {Eigen::Vector3d::Zero()};
  for (const ShownRun& run : runs) {
    Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
    if (!run.trajectory().empty()) {
      start_m = run.trajectory().poses().front().T_world_base.translation_m();
    }
    auto near = std::find_if(known_m.begin(), known_m.end(),
                             [&](const Eigen::Vector3d& known) { return (known - start_m).norm() < kNear_m; });
    if (near == known_m.end()) {
      known_m.emplace_back(start_m.array().round());
      near = std::prev(known_m.end());
    }
    origins_m.push_back(*near);
  }
  return origins_m;
}

std::string label_names() {
  Json labels = Json::array();
  for (std::size_t id = 0; id < kLabelNames.size(); ++id) {
    labels.push_back({{"id", id}, {"name", kLabelNames[id]}});
  }
  return dump(labels);
}

bool is_json(ViewTargetKind kind) {
  return kind == ViewTargetKind::labels || kind == ViewTargetKind::edges || kind == ViewTargetKind::map ||
         kind == ViewTargetKind::piste;
}

}  // namespace

ViewApi::ViewApi(std::vector<ShownRun> runs, Site site, ViewOptions options)
    : runs_(std::move(runs)),
      origins_m_(choose_origins(runs_)),
      site_(std::move(site)),
      options_(std::move(options)),
      cache_(options_.cache_bytes),
      maps_(runs_.size()) {}

ViewAnswer ViewApi::refuse(unsigned status, std::string_view error, std::string_view hint) {
  return {
      .status = status,
      .body = std::make_shared<const std::string>(dump({{"error", std::string(error)}, {"hint", std::string(hint)}}))};
}

ViewAnswer ViewApi::answer(const ViewRequest& request) {
  const auto target = parse_view_target(request.target);
  const bool is_api = !target || target->kind != ViewTargetKind::page;
  if (const auto refusal = find_view_refusal(request.caller, options_.access, is_api)) {
    return refuse(403, *refusal, "open the address that berm view printed; --host says where else it may be reached");
  }
  if (!request.reads) {
    return refuse(405, "only GET and HEAD are answered", "nothing can be changed here");
  }
  if (!target) {
    return refuse(400, "there can be no such target", "docs/view_api.md lists all of them");
  }
  return is_api ? answer_api(*target) : answer_page(*target);
}

ViewAnswer ViewApi::answer_page(const ViewTarget& target) const {
  const Site::File* file = site_.find(target.page);
  if (file == nullptr) {
    return refuse(404, "there is no such page", "start from /");
  }
  return {.status = 200, .content_type = file->content_type, .cache_control = "no-cache", .body = file->content};
}

ViewAnswer ViewApi::answer_api(const ViewTarget& target) {
  if (target.kind == ViewTargetKind::runs) {
    return describe_runs();
  }
  if (target.run >= runs_.size()) {
    return refuse(404, "there is no such run", "/api/runs lists them");
  }
  const PayloadKey key{static_cast<std::uint8_t>(target.kind), target.run, target.item};
  Payload body = cache_.find(key);
  if (!body) {
    try {
      if (auto made = make(target)) {
        body = std::make_shared<const std::string>(*std::move(made));
        cache_.keep(key, body);
      }
    } catch (const Error& error) {
      return refuse(500, error.what(), "the file is broken or was removed meanwhile");
    }
  }
  if (!body) {
    return refuse(404, "the run has no such thing", "/api/runs says which layers it has");
  }
  return {.content_type = is_json(target.kind) ? "application/json" : "application/octet-stream", .body = body};
}

ViewAnswer ViewApi::describe_runs() const {
  Json list = Json::array();
  for (std::size_t id = 0; id < runs_.size(); ++id) {
    const ShownRun& run = runs_[id];
    const Recording& recording = run.recording();
    const bool any = run.size() > 0;
    const auto has = [&run](const char* file) { return run.is_run() && run.find_file(file).has_value(); };
    const Stamp start_ns = any ? recording.scan(run.recording_index(0)).stamp_ns : 0;
    const Stamp end_ns = any ? recording.scan(run.recording_index(run.size() - 1)).stamp_ns : 0;
    const bool has_truth = any && recording.scan(run.recording_index(0)).truth_labels.has_value();
    list.push_back({{"id", id},
                    {"name", run.name()},
                    {"is_run", run.is_run()},
                    {"scans", run.size()},
                    {"machine", run.machine()},
                    {"sensor", run.sensor()},
                    {"origin", {origins_m_[id].x(), origins_m_[id].y(), origins_m_[id].z()}},
                    {"start_ns", start_ns},
                    {"end_ns", end_ns},
                    {"layers",
                     {{"labels", run.is_run() ? has("labels") : has_truth},
                      {"edges", run.find_file("edges.csv").has_value()},
                      {"map", has(kMapIndex)},
                      {"octree", has("edges.ot")},
                      {"trajectory", !run.trajectory().empty()},
                      {"global_trajectory", has(kGlobalTrajectory)},
                      {"piste", run.piste_method() != "none" && static_cast<bool>(options_.piste)}}}});
  }
  return {.body = std::make_shared<const std::string>(dump(list))};
}

/// One thread reads a map, the others wait for it.
std::shared_ptr<const MapLayer> ViewApi::find_map(std::size_t run) {
  const std::lock_guard lock(map_mutex_);
  if (!maps_[run] && runs_[run].is_run() && runs_[run].find_file(kMapIndex)) {
    maps_[run] = std::make_shared<const MapLayer>(runs_[run].folder() / kMapFolder, origins_m_[run], stopping_);
  }
  return maps_[run];
}

std::optional<std::string> ViewApi::make(const ViewTarget& target) {
  const ShownRun& run = runs_[target.run];
  const Eigen::Vector3d& origin_m = origins_m_[target.run];
  switch (target.kind) {
    case ViewTargetKind::scans:
      return make_scan_table(run.list_scans(), run.trajectory(), origin_m);
    case ViewTargetKind::scan: {
      if (target.item >= run.size()) {
        return std::nullopt;
      }
      return make_scan(run, target.item);
    }
    case ViewTargetKind::labels:
      return label_names();
    case ViewTargetKind::trajectory:
      return run.trajectory().empty() ? std::nullopt : std::optional(make_pose_table(run.trajectory(), origin_m));
    case ViewTargetKind::global: {
      const auto file = run.is_run() ? run.find_file(kGlobalTrajectory) : std::nullopt;
      return file ? std::optional(make_pose_table(read_tum(*file), origin_m)) : std::nullopt;
    }
    case ViewTargetKind::edges:
      return make_edges(target);
    case ViewTargetKind::octree: {
      const auto file = run.is_run() ? run.find_file("edges.ot") : std::nullopt;
      return file ? std::optional(make_octree_payload(*file, origin_m)) : std::nullopt;
    }
    case ViewTargetKind::map: {
      const auto map = find_map(target.run);
      return map ? std::optional(map->describe()) : std::nullopt;
    }
    case ViewTargetKind::tile: {
      const auto map = find_map(target.run);
      return map ? map->read(target.item) : std::nullopt;
    }
    case ViewTargetKind::piste:
      return options_.piste && run.piste_method() != "none" && target.item < run.size()
                 ? options_.piste(run, target.item)
                 : std::nullopt;
    default:
      return std::nullopt;
  }
}

std::string ViewApi::make_scan(const ShownRun& run, std::size_t index) {
  std::unique_ptr<Scan> scan = take_scratch();
  run.read(index, *scan);
  std::string payload = make_points_payload(scan->cloud.view(), scan->T_base_sensor);
  const std::lock_guard lock(scratch_mutex_);
  scratch_.push_back(std::move(scan));
  return payload;
}

std::unique_ptr<Scan> ViewApi::take_scratch() {
  const std::lock_guard lock(scratch_mutex_);
  if (scratch_.empty()) {
    return std::make_unique<Scan>();
  }
  std::unique_ptr<Scan> scan = std::move(scratch_.back());
  scratch_.pop_back();
  return scan;
}

std::optional<std::string> ViewApi::make_edges(const ViewTarget& target) const {
  const ShownRun& run = runs_[target.run];
  const auto file = run.find_file("edges.csv");
  return file ? std::optional(make_edges_json(*file, !run.is_run(), origins_m_[target.run])) : std::nullopt;
}

}  // namespace berm
