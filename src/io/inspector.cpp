#include "inspector.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "berm/core/error.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/pose_log.hpp"
#include "sensor_guess.hpp"

namespace berm {
namespace {

/// Broken files that are named one by one; the rest is counted.
constexpr std::size_t kMaxNamed = 3;

/// Quantiles of values that are all there.
Spread spread_of(std::vector<double> values) {
  if (values.empty()) {
    return {};
  }
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {.min = values.front(), .median = at(0.5), .p95 = at(0.95), .max = values.back()};
}

std::vector<std::string> channels_of(const PointChannels& channels) {
  std::vector<std::string> names = {"xyz"};
  const auto add = [&](const auto& channel, const char* name) {
    if (!channel.empty()) {
      names.emplace_back(name);
    }
  };
  add(channels.intensity, "intensity");
  add(channels.time, "time");
  add(channels.ring, "ring");
  add(channels.label, "label");
  return names;
}

double length_m(const Trajectory& trajectory) {
  double length = 0.0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    length +=
        (trajectory.poses()[i].T_world_base.translation_m() - trajectory.poses()[i - 1].T_world_base.translation_m())
            .norm();
  }
  return length;
}

}  // namespace

std::string_view to_string(FiringOrder order) {
  switch (order) {
    case FiringOrder::column_wise:
      return "spinning, column by column";
    case FiringOrder::ring_wise:
      return "spinning, ring by ring";
    case FiringOrder::non_repeating:
      return "non-repeating pattern";
    case FiringOrder::unordered:
      return "unordered";
    case FiringOrder::unknown:
      break;
  }
  return "unknown";
}

Inspector::Inspector(const Recording& recording) : recording_(recording) {
  info_.path = recording.path().string();
  info_.layout = recording.layout();
  info_.scans = recording.size();
  info_.stamp_source = recording.stamp_source();
  info_.sheet = recording.sheet();
  info_.odd = recording.notes();
}

void Inspector::add(std::size_t index) {
  try {
    record_ = recording_.read_record(index, std::move(record_.channels));
  } catch (const FileError& error) {
    if (++info_.scans_failed <= kMaxNamed) {
      odd(error.what());
    }
    return;
  }
  ++info_.scans_read;
  add_record(index);
}

void Inspector::add_record(std::size_t index) {
  const ScanEntry entry = recording_.scan(index);
  std::error_code no_size;
  const std::uintmax_t bytes = std::filesystem::file_size(entry.file, no_size);
  info_.bytes += no_size ? 0 : bytes;
  if (info_.scans_read == 1) {
    info_.fields = record_.fields;
    info_.reading = record_.notes;
  }
  if (info_.channels.size() <= 1) {
    info_.channels = channels_of(record_.channels);
  }
  const bool file_knows = recording_.stamp_source() == StampSource::scan_files && record_.start_ns;
  const Stamp stamp_ns = file_knows ? *record_.start_ns : entry.stamp_ns;
  if (!stamps_ns_.empty() && stamp_ns <= stamps_ns_.back() && ++stamps_back_ <= kMaxNamed) {
    odd("scan " + entry.name + " does not start later than the one before");
  }
  stamps_ns_.push_back(stamp_ns);
  points_per_scan_.push_back(static_cast<double>(record_.channels.x.size()));
  add_labels(entry);

  const PointsView points = view();
  const PointCounts counts = count_points(points);
  add_counts(counts);
  const std::vector<Beam> beams = real_beams(points, counts.repeated);
  add_values(beams);
  add_time();
  add_sensor(entry.name, beams);
}

PointsView Inspector::view() const {
  const PointChannels& c = record_.channels;
  return {.x = c.x, .y = c.y, .z = c.z, .intensity = c.intensity, .time = c.time, .ring = c.ring, .label = c.label};
}

void Inspector::add_counts(const PointCounts& counts) {
  info_.points += counts.points;
  odd_counts_.empty_scans += counts.points == 0 ? 1U : 0U;
  counts_.no_return_zero += counts.no_return_zero;
  counts_.no_return_inf += counts.no_return_inf;
  counts_.nan += counts.nan;
  counts_.duplicates += counts.duplicates;
  if (counts.repeated) {
    repeated_points_ += static_cast<double>(counts.points) * counts.repeated->share;
    counts_.repeated = counts_.repeated ? counts_.repeated : counts.repeated;
  }
}

void Inspector::add_values(const std::vector<Beam>& beams) {
  const std::vector<float>& intensity = record_.channels.intensity;
  for (const Beam& beam : beams) {
    range_m_.add(static_cast<double>(beam.range_m));
    if (!intensity.empty() && std::isfinite(intensity[beam.index])) {
      intensity_.add(static_cast<double>(intensity[beam.index]));
    }
  }
}

void Inspector::add_time() {
  const std::vector<float>& time = record_.channels.time;
  const auto known = [](float t) { return !std::isnan(t); };
  auto last = std::find_if(time.begin(), time.end(), known);
  if (last == time.end()) {
    return;
  }
  float earliest = *last;
  float latest = *last;
  for (auto t = last + 1; t != time.end(); ++t) {
    if (!known(*t)) {
      continue;
    }
    ++odd_counts_.time_steps;
    odd_counts_.time_steps_back += *t < *last ? 1U : 0U;
    last = t;
    earliest = std::min(earliest, *t);
    latest = std::max(latest, *t);
  }
  time_spans_s_.push_back(static_cast<double>(latest - earliest));
}

void Inspector::add_sensor(const std::string& scan, const std::vector<Beam>& beams) {
  const std::optional<BeamMotion> motion = measure_motion(beams);
  const std::optional<FieldOfView> view = field_of_view(beams);
  if (!motion || !view) {
    return;
  }
  const FiringOrder order = classify(*motion);
  const auto rings = count_rings(record_.channels.ring, beams, order, *motion);
  const SensorGuess guess = guess_sensor(order, rings, *view, *motion);
  SensorVote& vote = votes_[guess.name];
  if (vote.scans++ == 0) {
    vote.first_scan = scan;
    vote.order = order;
    vote.lines = order == FiringOrder::non_repeating ? motion->best_lag : 1;
    vote.turns = std::abs(motion->net_turns);
    vote.rings = rings;
    vote.view = *view;
    vote.guess = guess;
  }
}

void Inspector::add_labels(const ScanEntry& entry) {
  if (!entry.truth_labels) {
    return;
  }
  try {
    for (const std::uint32_t raw : read_labels(*entry.truth_labels, record_.channels.x.size())) {
      ++classes_[semantic_class(raw)];
    }
    ++info_.labelled_scans;
  } catch (const FileError& error) {
    if (++odd_counts_.failed_labels <= kMaxNamed) {
      odd(error.what());
    }
  }
}

void Inspector::finish_stamps() {
  if (stamps_ns_.size() < 2) {
    return;
  }
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < stamps_ns_.size(); ++i) {
    steps_s.push_back(to_seconds(stamps_ns_[i] - stamps_ns_[i - 1]));
  }
  const Spread step_s = spread_of(std::move(steps_s));
  info_.duration_s = to_seconds(stamps_ns_.back() - stamps_ns_.front());
  info_.longest_step_s = step_s.max;
  if (step_s.median > 0.0) {
    info_.rate_hz = 1.0 / step_s.median;
  }
}

void Inspector::finish_shares() {
  const auto points = static_cast<double>(std::max<std::uint64_t>(1, info_.points));
  info_.no_return_zero_share = static_cast<double>(counts_.no_return_zero) / points;
  info_.no_return_inf_share = static_cast<double>(counts_.no_return_inf) / points;
  info_.nan_share = static_cast<double>(counts_.nan) / points;
  info_.duplicate_share = static_cast<double>(counts_.duplicates) / points;
  info_.repeated_point = counts_.repeated;
  if (info_.repeated_point) {
    info_.repeated_point->share = repeated_points_ / points;
  }
}

void Inspector::finish_sensor() {
  const SensorVote* winner = nullptr;
  for (const auto& [name, vote] : votes_) {
    if (winner == nullptr || vote.scans > winner->scans) {
      winner = &vote;
    }
  }
  if (winner == nullptr) {
    return;
  }
  info_.order = winner->order;
  info_.interleaved_lines = winner->lines;
  info_.turns_per_scan = winner->turns;
  info_.rings = winner->rings;
  info_.field_of_view = winner->view;
  info_.sensor = winner->guess;
  for (const auto& [name, vote] : votes_) {
    if (&vote != winner) {
      odd(std::to_string(vote.scans) + " of " + std::to_string(info_.scans_read) + " scans look like another sensor (" +
          name + "), first " + vote.first_scan);
    }
  }
}

void Inspector::finish_poses() {
  try {
    if (recording_.pose_log()) {
      // Which positions are good enough is for the machine to say: here all count.
      const PoseLog log = read_pose_log(*recording_.pose_log(), {.fix = "any"}, {}, {});
      info_.given_poses = PosesInfo{.file = recording_.pose_log()->filename().string(),
                                    .of = PoseOf::base,
                                    .count = log.trajectory.size(),
                                    .length_m = length_m(log.trajectory)};
    } else if (const auto given = recording_.read_given_poses()) {
      info_.given_poses = PosesInfo{.file = given->file.filename().string(),
                                    .of = given->of,
                                    .count = given->trajectory.size(),
                                    .length_m = length_m(given->trajectory)};
    }
  } catch (const FileError& error) {
    odd(error.what());
  }
  try {
    if (const auto truth = recording_.read_truth_poses()) {
      info_.truth_poses =
          PosesInfo{.file = "truth.tum", .of = PoseOf::base, .count = truth->size(), .length_m = length_m(*truth)};
    }
  } catch (const FileError& error) {
    odd(error.what());
  }
}

RecordingInfo Inspector::finish() {
  info_.points_per_scan = spread_of(points_per_scan_);
  info_.range_m = range_m_.spread();
  info_.intensity = intensity_.spread();
  if (!time_spans_s_.empty()) {
    info_.time_span_s = spread_of(time_spans_s_).median;
  }
  for (const auto& [id, points] : classes_) {
    info_.truth_classes.push_back({.id = id, .points = points});
  }
  finish_stamps();
  finish_shares();
  finish_sensor();
  finish_poses();
  find_oddities(odd_counts_, info_);
  return std::move(info_);
}

void Inspector::odd(std::string sentence) {
  info_.odd.push_back(std::move(sentence));
}

RecordingInfo inspect(const Recording& recording, const InspectOptions& options) {
  if (options.first >= recording.size()) {
    throw Error(ErrorCode::invalid_argument, "there is no scan " + std::to_string(options.first) + ", " +
                                                 recording.path().string() + " has " +
                                                 std::to_string(recording.size()));
  }
  const std::size_t all = std::min(options.count.value_or(recording.size()), recording.size() - options.first);
  Inspector inspector(recording);
  for (std::size_t done = 0; done < all; ++done) {
    inspector.add(options.first + done);
    if (options.progress) {
      options.progress(done + 1, all);
    }
  }
  return inspector.finish();
}

}  // namespace berm
