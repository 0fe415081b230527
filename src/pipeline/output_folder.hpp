#pragma once

#include <filesystem>

namespace berm {

/// The folder of a run, claimed for one writer. While the run lasts, and after one that did not end well, it holds the
/// marker `kMarker`; run.json appears last and only in a whole run.
class OutputFolder {
 public:
  static constexpr const char* kMarker = ".berm-unfinished";

  /// Creates `folder` and its labels/, and claims it. Throws FileError: `exists` if it holds anything and not `force`,
  /// or another run writes there now; with `force`, the results of an earlier run are removed and nothing else:
  /// labels/, trajectory.tum or run.json that no run of berm wrote are refused. The folder of the recording itself
  /// is refused always. write_failed if it cannot be created.
  OutputFolder(std::filesystem::path folder, bool force, const std::filesystem::path& recording);
  /// Gives the claim up; takes away again what was created if nothing was written.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  [[nodiscard]] std::filesystem::path run_file() const { return folder_ / "run.json"; }
  [[nodiscard]] std::filesystem::path trajectory_file() const { return folder_ / "trajectory.tum"; }
  [[nodiscard]] std::filesystem::path labels_folder() const { return folder_ / "labels"; }

  /// The run is whole: removes the marker.
  void finish();

 private:
  void create();
  void claim();
  void remove_old_results() const;

  std::filesystem::path folder_;
  bool created_ = false;
  bool marker_was_there_ = false;
  int lock_ = -1;
};

}  // namespace berm
