#include "pcd_decoder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "berm/core/stamp.hpp"
#include "little_endian.hpp"
#include "pcd_time.hpp"
#include "to_float.hpp"

namespace berm {
namespace {

/// Calls `use` with a value of the type of `field`.
template <typename Use>
void with_type(const PcdField& field, Use&& use) {
  const bool is_signed = field.type == 'I';
  if (field.type == 'F') {
    field.size == 4 ? use(float{}) : use(double{});
  } else if (field.size == 1) {
    is_signed ? use(std::int8_t{}) : use(std::uint8_t{});
  } else if (field.size == 2) {
    is_signed ? use(std::int16_t{}) : use(std::uint16_t{});
  } else if (field.size == 4) {
    is_signed ? use(std::int32_t{}) : use(std::uint32_t{});
  } else {
    is_signed ? use(std::int64_t{}) : use(std::uint64_t{});
  }
}

/// `target[i] = convert(value of point i)`
template <typename Target, typename Convert>
void convert_column(const PcdField& field, const PcdColumn& column, Target* target, std::size_t count,
                    Convert&& convert) {
  with_type(field, [&](auto type) {
    using Source = decltype(type);
    const std::byte* source = column.first;
    for (std::size_t i = 0; i < count; ++i, source += column.stride_bytes) {
      target[i] = convert(load<Source>(source));
    }
  });
}

/// Nanoseconds as a stamp; kNoStamp for what does not fit.
template <typename Source>
std::int64_t stamp_from_nanoseconds(Source value) {
  if constexpr (std::is_floating_point_v<Source>) {
    return kNoStamp;  // the plan takes whole numbers only
  } else if constexpr (std::is_same_v<Source, std::uint64_t>) {
    return value > static_cast<std::uint64_t>(INT64_MAX) ? kNoStamp : static_cast<std::int64_t>(value);
  } else {
    return static_cast<std::int64_t>(value);
  }
}

std::optional<Label> label_from_id(double id) {
  for (const Label label : {Label::unlabeled, Label::falling_snow, Label::drivable, Label::terrain, Label::obstacle}) {
    if (id == semantic_kitti_id(label)) {
      return label;
    }
  }
  return std::nullopt;
}

}  // namespace

PcdDecoder::PcdDecoder(const PcdHeader& header, const PcdPlan& plan, const std::string& name, PointChannels reuse)
    : header_(header), plan_(plan), name_(name) {
  record_.channels = std::move(reuse);
  const auto size_of = [&](PcdChannel wanted) {
    const bool planned = std::any_of(plan.channels.begin(), plan.channels.end(),
                                     [&](const PcdPlannedChannel& entry) { return entry.channel == wanted; });
    return planned ? header.points : 0;
  };
  PointChannels& channels = record_.channels;
  channels.x.resize(header.points);
  channels.y.resize(header.points);
  channels.z.resize(header.points);
  channels.intensity.resize(size_of(PcdChannel::intensity));
  channels.time.resize(size_of(PcdChannel::time));
  channels.ring.resize(size_of(PcdChannel::ring));
  channels.label.resize(size_of(PcdChannel::label));
  if (is_absolute(plan.time_unit)) {
    stamps_ns_.resize(channels.time.size());
  }
  record_.fields.reserve(header.fields.size());
  for (const PcdField& field : header.fields) {
    record_.fields.push_back(field.name);
  }
  record_.notes = header.notes;
  record_.notes.insert(record_.notes.end(), plan.notes.begin(), plan.notes.end());
}

std::size_t PcdDecoder::bytes_per_point(const PcdPlan& plan) {
  std::size_t bytes = 0;
  for (const auto& [channel, field] : plan.channels) {
    switch (channel) {
      case PcdChannel::time:
        bytes += sizeof(float) + (is_absolute(plan.time_unit) ? sizeof(std::int64_t) : 0);
        break;
      case PcdChannel::ring:
        bytes += sizeof(std::uint16_t);
        break;
      case PcdChannel::label:
        bytes += sizeof(Label);
        break;
      default:
        bytes += sizeof(float);
    }
  }
  return bytes;
}

std::vector<float>* PcdDecoder::float_channel(PcdChannel channel) {
  switch (channel) {
    case PcdChannel::x:
      return &record_.channels.x;
    case PcdChannel::y:
      return &record_.channels.y;
    case PcdChannel::z:
      return &record_.channels.z;
    case PcdChannel::intensity:
      return &record_.channels.intensity;
    default:
      return nullptr;
  }
}

void PcdDecoder::decode(std::span<const PcdColumn> columns, std::size_t begin, std::size_t count) {
  for (std::size_t i = 0; i < plan_.channels.size(); ++i) {
    const PcdField& field = header_.fields[plan_.channels[i].field];
    const PcdChannel channel = plan_.channels[i].channel;
    if (std::vector<float>* target = float_channel(channel)) {
      convert_column(field, columns[i], target->data() + begin, count, [](auto value) { return to_float(value); });
    } else if (channel == PcdChannel::time) {
      decode_time(field, columns[i], begin, count);
    } else if (channel == PcdChannel::ring) {
      convert_column(field, columns[i], record_.channels.ring.data() + begin, count, [this](auto value) {
        const auto number = static_cast<double>(value);
        const bool fits = number >= 0.0 && number <= 65535.0 && number == std::floor(number);
        bad_rings_ += fits ? 0U : 1U;
        return fits ? static_cast<std::uint16_t>(number) : std::uint16_t{0};
      });
    } else {
      convert_column(field, columns[i], record_.channels.label.data() + begin, count, [this](auto value) {
        const std::optional<Label> label = label_from_id(static_cast<double>(value));
        other_labels_ += label ? 0U : 1U;
        return label.value_or(Label::unlabeled);
      });
    }
  }
}

void PcdDecoder::decode_time(const PcdField& field, const PcdColumn& column, std::size_t begin, std::size_t count) {
  float* const time = record_.channels.time.data() + begin;
  std::int64_t* const stamps = is_absolute(plan_.time_unit) ? stamps_ns_.data() + begin : nullptr;
  switch (plan_.time_unit) {
    case PcdTimeUnit::relative_s:
      convert_column(field, column, time, count, [](auto value) { return to_float(value); });
      break;
    case PcdTimeUnit::relative_ns:
      convert_column(field, column, time, count,
                     [](auto value) { return to_float(static_cast<double>(value) / kNanosecondsPerSecond); });
      break;
    case PcdTimeUnit::absolute_s:
      convert_column(field, column, stamps, count,
                     [this](auto value) { return stamp_from_seconds(static_cast<double>(value), seconds_were_ns_); });
      break;
    case PcdTimeUnit::absolute_ns:
      convert_column(field, column, stamps, count, [](auto value) { return stamp_from_nanoseconds(value); });
      break;
  }
}

void PcdDecoder::finish_whole_numbers() {
  if (bad_rings_ > 0) {
    record_.channels.ring.clear();
    record_.notes.push_back(
        fmt::format("the field of the ring was left out: {} points hold no whole number from 0 to 65535", bad_rings_));
  }
  if (other_labels_ > 0) {
    record_.notes.push_back(
        fmt::format("{} points have a label that berm does not write, taken as unlabeled", other_labels_));
  }
}

ScanRecord PcdDecoder::finish() {
  const bool has_time = !record_.channels.time.empty();
  if (has_time && is_absolute(plan_.time_unit)) {
    if (seconds_were_ns_) {
      record_.notes.emplace_back("times of type F8 were taken as ns: they are too large for seconds");
    }
    set_absolute_time(record_, stamps_ns_, name_);
  } else if (has_time) {
    check_relative_time(record_, name_);
  }
  finish_whole_numbers();
  return std::move(record_);
}

}  // namespace berm
