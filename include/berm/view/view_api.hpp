#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "berm/view/access.hpp"
#include "berm/view/payload_cache.hpp"
#include "berm/view/shown_run.hpp"
#include "berm/view/site.hpp"
#include "berm/view/target.hpp"

namespace berm {

class MapLayer;

struct ViewRequest {
  bool reads = true;  ///< GET or HEAD
  std::string_view target;
  ViewCaller caller;
};

/// What is sent back. Headers that are the same for all are the server's.
struct ViewAnswer {
  unsigned status = 200;
  std::string_view content_type = "application/json";
  std::string_view cache_control = "no-store";
  Payload body;
};

/// Says what the piste method made of a scan as JSON, none if the run has no such method. May be called from several
/// threads at once.
using PisteSource = std::function<std::optional<std::string>(const ShownRun&, std::size_t scan)>;

struct ViewOptions {
  ViewAccess access;
  std::size_t cache_bytes = std::size_t{256} << 20U;
  PisteSource piste;  ///< may be empty
};

/// Answers requests about some runs: what `berm view` serves, without a network (docs/view_api.md). `answer` may be
/// called from several threads at once.
class ViewApi {
 public:
  ViewApi(std::vector<ShownRun> runs, Site site, ViewOptions options);

  /// Never throws but for want of memory: what goes wrong is an answer with the text of the error.
  [[nodiscard]] ViewAnswer answer(const ViewRequest& request);

  /// Ends long answers early, for good; they become errors.
  void stop() { stopping_ = true; }

  /// An error as the front end takes it.
  [[nodiscard]] static ViewAnswer refuse(unsigned status, std::string_view error, std::string_view hint);

  /// What positions in the world of a run are relative to.
  [[nodiscard]] const Eigen::Vector3d& origin_m(std::size_t run) const { return origins_m_[run]; }
  [[nodiscard]] const std::vector<ShownRun>& runs() const { return runs_; }

 private:
  [[nodiscard]] ViewAnswer answer_page(const ViewTarget& target) const;
  [[nodiscard]] ViewAnswer answer_api(const ViewTarget& target);
  [[nodiscard]] ViewAnswer describe_runs() const;
  [[nodiscard]] std::optional<std::string> make(const ViewTarget& target);
  [[nodiscard]] std::shared_ptr<const MapLayer> find_map(std::size_t run);
  [[nodiscard]] std::string make_scan(const ShownRun& run, std::size_t index);
  [[nodiscard]] std::unique_ptr<Scan> take_scratch();
  [[nodiscard]] std::optional<std::string> make_edges(const ViewTarget& target) const;

  std::vector<ShownRun> runs_;
  std::vector<Eigen::Vector3d> origins_m_;
  Site site_;
  ViewOptions options_;
  PayloadCache cache_;
  std::mutex scratch_mutex_;
  std::vector<std::unique_ptr<Scan>> scratch_;  ///< memory of scans, one for each thread that reads
  std::atomic<bool> stopping_ = false;
  std::mutex map_mutex_;
  std::vector<std::shared_ptr<const MapLayer>> maps_;  ///< by run, made when first asked for
};

}  // namespace berm
