#include "berm/io/datum.hpp"

#include <cmath>
#include <vector>

#include <GeographicLib/LocalCartesian.hpp>
#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "line_reader.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr double kMaxDatumHeight_m = 100'000.0;

bool is_place(const Geodetic& place) {
  return std::abs(place.lat_deg) <= 90.0 && std::abs(place.lon_deg) <= 360.0 &&
         std::abs(place.h_m) <= kMaxDatumHeight_m;
}

void check_place(const Geodetic& place) {
  if (!is_place(place)) {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("datum: latitude {} deg, longitude {} deg, height {} m is no place on the earth",
                            place.lat_deg, place.lon_deg, place.h_m));
  }
}

/// Takes `key` and the number behind it off `rest`.
std::optional<double> take_value(std::string_view& rest, std::string_view key) {
  return take_word(rest) == key ? parse_number(take_word(rest)) : std::nullopt;
}

}  // namespace

std::string world_name(const std::optional<Geodetic>& datum) {
  if (!datum) {
    return {};
  }
  check_place(*datum);
  std::string name = "WGS84";
  const auto append = [&](std::string_view key, double value) {
    name += key;
    append_shortest(name, value + 0.0);  // -0 is the same place as 0
  };
  append(" lat ", datum->lat_deg);
  append(" lon ", datum->lon_deg);
  append(" h ", datum->h_m);
  return name;
}

std::optional<Geodetic> datum_of(std::string_view world_name) {
  std::string_view rest = world_name;
  if (take_word(rest) != "WGS84") {
    return std::nullopt;
  }
  const auto lat_deg = take_value(rest, "lat");
  const auto lon_deg = take_value(rest, "lon");
  const auto h_m = take_value(rest, "h");
  if (!lat_deg || !lon_deg || !h_m || !take_word(rest).empty()) {
    return std::nullopt;
  }
  const Geodetic datum{*lat_deg, *lon_deg, *h_m};
  return is_place(datum) ? std::optional(datum) : std::nullopt;
}

std::optional<Geodetic> DatumConfig::given() const {
  return origin == "given" ? std::optional(Geodetic{lat_deg, lon_deg, h_m}) : std::nullopt;
}

LocalFrame::LocalFrame(const Geodetic& datum) : datum_(datum) {
  check_place(datum);
  frame_ = std::make_shared<const GeographicLib::LocalCartesian>(datum.lat_deg, datum.lon_deg, datum.h_m);
}

Eigen::Vector3d LocalFrame::to_local_m(const Geodetic& place) const {
  Eigen::Vector3d local_m;
  frame_->Forward(place.lat_deg, place.lon_deg, place.h_m, local_m.x(), local_m.y(), local_m.z());
  return local_m;
}

Geodetic LocalFrame::to_geodetic(const Eigen::Vector3d& local_m) const {
  Geodetic place;
  frame_->Reverse(local_m.x(), local_m.y(), local_m.z(), place.lat_deg, place.lon_deg, place.h_m);
  return place;
}

Eigen::Matrix3d LocalFrame::R_local_enu(const Geodetic& place) const {
  Eigen::Vector3d unused;
  std::vector<double> rows(9);
  frame_->Forward(place.lat_deg, place.lon_deg, place.h_m, unused.x(), unused.y(), unused.z(), rows);
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.data());
}

}  // namespace berm
