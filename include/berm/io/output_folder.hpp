#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace berm {

/// What a command writes into its folder, so that the results of an earlier call can be told from other files.
struct OutputResults {
  struct Folder {
    std::string name;        ///< "labels"
    std::string extension;   ///< of the results in it: ".label"
    bool on_demand = false;  ///< made by who writes into it, where there is something to write
  };

  std::string work;       ///< what fills the folder, for messages: "run"
  std::string last_file;  ///< written last, so that it stands for a whole folder: "run.json"
  std::string mark;       ///< in the first 4096 bytes of `last_file` if it was written by berm
  std::vector<std::string> files;
  std::vector<Folder> folders;
};

/// A folder of results, claimed for one writer. While the work lasts, and after one that did not end well, it holds the
/// marker `kMarker`; the last file appears only when the work is whole.
class OutputFolder {
 public:
  static constexpr const char* kMarker = ".berm-unfinished";

  /// Creates `folder` and the folders in it, and claims it. Throws FileError: `exists` if it holds anything and not
  /// `force`, or another writer is at work there now; with `force`, the results of earlier work are removed and nothing
  /// else: results that berm did not write are refused. The folder of the `recording` that is worked on is refused
  /// always. write_failed if it cannot be created.
  OutputFolder(std::filesystem::path folder, bool force, OutputResults results,
               const std::filesystem::path& recording = {});
  /// Gives the claim up; takes away again what was created if nothing was written into the folders.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Path of a result.
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

  /// The work is whole: removes the marker.
  void finish();

 private:
  void create();
  void claim();
  void remove_old_results() const;
  void create_folders() const;
  [[nodiscard]] bool is_of_berm() const;

  std::filesystem::path folder_;
  OutputResults results_;
  bool created_ = false;
  bool marker_was_there_ = false;
  int lock_ = -1;
};

}  // namespace berm
