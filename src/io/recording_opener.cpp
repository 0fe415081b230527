#include "recording_opener.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "berm/core/error.hpp"
#include "berm/io/times_file.hpp"
#include "folder_listing.hpp"
#include "line_reader.hpp"
#include "scan_names.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr double kAssumedRate_hz = 10.0;
/// Broken files at the start of a recording that are passed over in search of a readable one.
constexpr std::size_t kMaxProbes = 16;

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

}  // namespace

RecordingOpener::RecordingOpener(fs::path path) : path_(std::move(path)) {}

Recording RecordingOpener::open() {
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  recording_.path_ = path_;
  switch (status.type()) {
    case fs::file_type::regular:
      open_file();
      break;
    case fs::file_type::directory:
      open_folder();
      break;
    case fs::file_type::not_found:
      throw FileError(ErrorCode::not_found, path_.string(), std::nullopt, "there is no such file or folder");
    default:
      throw FileError(ErrorCode::unreadable, path_.string(), std::nullopt,
                      error ? "cannot be looked at: " + error.message() : "neither a file nor a folder");
  }
  return std::move(recording_);
}

void RecordingOpener::open_file() {
  recording_.layout_ = RecordingLayout::single_file;
  recording_.scan_folder_ = path_.parent_path();
  recording_.extension_ = path_.extension().string();
  recording_.names_ = {path_.stem().string()};
  recording_.has_labels_ = {false};
  if (recording_.extension_ != kPcdExtension && recording_.extension_ != kBinExtension) {
    throw FileError(ErrorCode::unsupported, path_.string(), std::nullopt,
                    "expected a .pcd or KITTI .bin file, or a folder of them; other formats have to be converted");
  }
  recognise_intensity();
  if (!take_stamps_of_scans()) {
    recording_.stamps_ns_ = {0};
  }
}

void RecordingOpener::open_folder() {
  const fs::path scans = path_ / "scans";
  const fs::path velodyne = path_ / "velodyne";
  const bool found = (is_folder(scans) && take_scans(scans, kPcdExtension, RecordingLayout::sequence)) ||
                     (is_folder(velodyne) && take_scans(velodyne, kBinExtension, RecordingLayout::kitti)) ||
                     take_scans(path_, kPcdExtension, RecordingLayout::pcd_folder) ||
                     take_scans(path_, kBinExtension, RecordingLayout::bin_folder);
  if (!found) {
    throw_no_scans();
  }
  for (const auto& sentence : {describe_gaps(recording_.names_), describe_mixture(recording_.names_)}) {
    if (sentence) {
      note(*sentence);
    }
  }
  read_sheet();
  find_labels();
  recognise_intensity();
  find_stamps();
  find_poses();
}

bool RecordingOpener::take_scans(const fs::path& folder, std::string_view extension, RecordingLayout layout) {
  FolderListing listing = list_folder(folder, extension);
  if (listing.stems.empty()) {
    return false;
  }
  if (listing.special > 0) {
    note(std::to_string(listing.special) + " entries named *" + std::string(extension) +
         " are no files and were left out");
  }
  recording_.layout_ = layout;
  recording_.scan_folder_ = folder;
  recording_.extension_ = extension;
  recording_.names_ = std::move(listing.stems);
  const std::string_view other = extension == kPcdExtension ? kBinExtension : kPcdExtension;
  if (listing.other_endings.count(std::string(other)) > 0) {
    note("the folder holds *" + std::string(other) + " beside *" + std::string(extension) +
         ": only the latter are read");
  }
  return true;
}

void RecordingOpener::throw_no_scans() const {
  std::string found;
  for (const std::string& ending : list_folder(path_, kPcdExtension).other_endings) {
    found += (found.empty() ? "; it holds *" : ", *") + ending;
  }
  throw FileError(ErrorCode::not_found, path_.string(), std::nullopt,
                  "no scans: expected scans/*.pcd, velodyne/*.bin, *.pcd or *.bin in this folder" + found);
}

void RecordingOpener::find_labels() {
  recording_.has_labels_.assign(recording_.size(), false);
  const fs::path folder = path_ / "labels";
  if (!is_folder(folder)) {
    return;
  }
  // Both lists are in natural order, so that one walk finds the pairs.
  const std::vector<std::string> labels = list_folder(folder, ".label").stems;
  std::size_t used = 0;
  std::size_t scan = 0;
  for (const std::string& label : labels) {
    while (scan < recording_.size() && natural_less(recording_.names_[scan], label)) {
      ++scan;
    }
    if (scan < recording_.size() && recording_.names_[scan] == label) {
      recording_.has_labels_[scan] = true;
      ++used;
    }
  }
  if (used < labels.size()) {
    note(std::to_string(labels.size() - used) + " of " + std::to_string(labels.size()) +
         " files in labels/ have the name of no scan");
  }
  if (used > 0 && used < recording_.size()) {
    note("truth labels for " + std::to_string(used) + " of " + std::to_string(recording_.size()) + " scans");
  }
}

void RecordingOpener::read_sheet() {
  const auto file = sidecar("sequence.json");
  if (!file) {
    return;
  }
  recording_.sheet_ = read_sensor_sheet(*file);
  std::string keys;
  for (const std::string& key : recording_.sheet_.unknown_keys) {
    keys += (keys.empty() ? "" : ", ") + berm::quoted(key);
  }
  if (!keys.empty()) {
    note("sequence.json: not used: " + keys);
  }
}

void RecordingOpener::find_poses() {
  recording_.truth_poses_file_ = sidecar("truth.tum");
  recording_.calibration_file_ = sidecar("calib.txt");
  std::vector<std::string> found;
  for (const char* name : {"gnss.tum", "gnss.csv", "gnss.nmea", "poses.txt"}) {
    if (sidecar(name)) {
      found.emplace_back(name);
    }
  }
  if (found.empty()) {
    return;
  }
  if (found.size() > 1) {
    note(found[0] + " and " + found[1] + " are both there: " + found[0] + " is used");
  }
  const fs::path file = path_ / found[0];
  if (found[0] == "gnss.tum") {
    recording_.gnss_file_ = file;
  } else if (found[0] != "poses.txt") {
    recording_.pose_log_file_ = file;
  } else if (recording_.calibration_file_) {
    recording_.camera_poses_file_ = file;
  } else {
    note(
        "poses.txt is not used: it is in the frame of the left camera, and no calib.txt leads from there to the LiDAR");
  }
}

void RecordingOpener::find_stamps() {
  if (!take_stamps_of_times_file() && !take_stamps_of_scans()) {
    assume_rate();
  }
}

bool RecordingOpener::take_stamps_of_times_file() {
  const auto file = sidecar("times.txt");
  if (!file) {
    return false;
  }
  const auto numbers = numbers_of(recording_.names_);
  const std::size_t highest = numbers ? static_cast<std::size_t>(numbers->back()) : 0;
  const TimesFile times = read_times(*file, std::max(recording_.size(), highest + 1));
  const auto lines = match_lines(recording_.names_, times.lines);
  if (!lines) {
    throw FileError(ErrorCode::malformed, file->string(), std::nullopt,
                    describe_line_mismatch(recording_.names_, times.lines, "stamps"));
  }
  for (const std::size_t line : *lines) {
    recording_.stamps_ns_.push_back(times.stamps[line]);
  }
  if (times.lines != recording_.size()) {
    note("times.txt has a line for every number up to " + recording_.names_.back() + ": stamps taken by number");
  }
  recording_.stamp_source_ = StampSource::times_file;
  return true;
}

bool RecordingOpener::take_stamps_of_scans() {
  if (recording_.extension_ != kPcdExtension) {
    return false;
  }
  const std::optional<Stamp> first = first_start(true);
  if (!first) {
    return false;
  }
  const std::size_t count = recording_.size();
  const std::optional<Stamp> last = count > 1 ? first_start(false) : first;
  if (!last || (count > 1 && *last <= *first)) {
    note("the absolute times in the scan files do not rise from the first to the last: not used");
    return false;
  }
  const double step_ns = count > 1 ? static_cast<double>(*last - *first) / static_cast<double>(count - 1) : 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    recording_.stamps_ns_.push_back(*first + static_cast<Stamp>(step_ns * static_cast<double>(i)));
  }
  recording_.stamp_source_ = StampSource::scan_files;
  return true;
}

void RecordingOpener::assume_rate() {
  const std::optional<double> given = recording_.sheet_.scan_hz;
  const double rate_hz = given.value_or(kAssumedRate_hz);
  for (std::size_t i = 0; i < recording_.size(); ++i) {
    recording_.stamps_ns_.push_back(from_seconds(static_cast<double>(i) / rate_hz));
  }
  if (recording_.size() > 1) {
    note(given ? "no times.txt: stamps follow from scan_hz of sequence.json" : "no times.txt: 10 Hz assumed");
  }
  recording_.stamp_source_ = StampSource::assumed_rate;
}

void RecordingOpener::recognise_intensity() {
  if (recording_.extension_ != kBinExtension) {
    return;
  }
  recording_.intensity_scale_ = IntensityScale::byte;
  std::optional<IntensityScale> scale;
  probe(true, [&](const ScanRecord& record) {
    scale = recognise_intensity_scale(record.channels.intensity);
    return scale.has_value();
  });
  recording_.intensity_scale_ = scale.value_or(IntensityScale::byte);
  if (!scale) {
    note("intensities say nothing about their unit (only 0 and 1): taken as 0..255");
  } else if (*scale == IntensityScale::unit) {
    note("intensities are 0..1: multiplied by 255");
  }
}

void RecordingOpener::probe(bool forward, const std::function<bool(const ScanRecord&)>& enough) const {
  const std::size_t probes = std::min(kMaxProbes, recording_.size());
  std::exception_ptr first_error;
  bool any = false;
  ScanRecord record;
  for (std::size_t i = 0; i < probes; ++i) {
    try {
      record = recording_.read_record(forward ? i : recording_.size() - 1 - i, std::move(record.channels));
      any = true;
    } catch (const FileError&) {
      first_error = first_error ? first_error : std::current_exception();
      continue;
    }
    if (enough(record)) {
      return;
    }
  }
  if (!any && first_error) {
    std::rethrow_exception(first_error);
  }
}

std::optional<Stamp> RecordingOpener::first_start(bool forward) const {
  std::optional<Stamp> start;
  probe(forward, [&](const ScanRecord& record) {
    start = record.start_ns;
    return !record.channels.x.empty();
  });
  return start;
}

std::optional<fs::path> RecordingOpener::sidecar(std::string_view name) const {
  const fs::path file = path_ / name;
  return is_there(file) ? std::optional(file) : std::nullopt;
}

void RecordingOpener::note(std::string sentence) {
  recording_.notes_.push_back(std::move(sentence));
}

}  // namespace berm
