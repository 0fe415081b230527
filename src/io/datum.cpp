#include "berm/io/datum.hpp"

#include <cmath>
#include <vector>

#include <GeographicLib/LocalCartesian.hpp>
#include <fmt/format.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

constexpr double kMaxDatumHeight_m = 100'000.0;

bool is_place(const Geodetic& place) {
  return std::abs(place.lat_deg) <= 90.0 && std::abs(place.lon_deg) <= 360.0 &&
         std::abs(place.h_m) <= kMaxDatumHeight_m;
}

}  // namespace

std::optional<Geodetic> DatumConfig::given() const {
  return origin == "given" ? std::optional(Geodetic{lat_deg, lon_deg, h_m}) : std::nullopt;
}

LocalFrame::LocalFrame(const Geodetic& datum) : datum_(datum) {
  if (!is_place(datum)) {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("datum: latitude {} deg, longitude {} deg, height {} m is no place on the earth",
                            datum.lat_deg, datum.lon_deg, datum.h_m));
  }
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
