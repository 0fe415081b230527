#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "berm/core/config.hpp"

namespace GeographicLib {  // NOLINT(readability-identifier-naming): the library's name
class LocalCartesian;
}

namespace berm {

/// A place on the earth: WGS 84, height above the ellipsoid.
struct Geodetic {
  double lat_deg = 0.0;
  double lon_deg = 0.0;
  double h_m = 0.0;
};

/// The name of the world of a datum, as an edge map carries it: one line of ASCII that `datum_of` brings back to the
/// last bit; empty without a datum. Throws Error(invalid_argument) for what is no place, as LocalFrame.
[[nodiscard]] std::string world_name(const std::optional<Geodetic>& datum);

/// The datum that a world is named after; none where the name is of another kind.
[[nodiscard]] std::optional<Geodetic> datum_of(std::string_view world_name);

/// Where the world frame lies on the earth.
struct DatumConfig {
  std::string origin = "first_fix";
  double lat_deg = 0.0;
  double lon_deg = 0.0;
  double h_m = 0.0;

  static void fields(auto&& field) {
    field("origin", &DatumConfig::origin, Choices{{"none", "first_fix", "given"}},
          "of the world frame: unknown, the first fix of the pose log, or the place given here");
    field("lat_deg", &DatumConfig::lat_deg, Range{-90.0, 90.0}, "latitude where origin is given, WGS 84");
    field("lon_deg", &DatumConfig::lon_deg, Range{-180.0, 180.0}, "longitude where origin is given, WGS 84");
    field("h_m", &DatumConfig::h_m, Range{-1000.0, 10000.0}, "height above the ellipsoid where origin is given");
  }
  void check() const { check_fields(*this, "datum"); }

  /// The place, where origin is given.
  [[nodiscard]] std::optional<Geodetic> given() const;
};

/// The world frame of a datum: x east, y north, z up at the datum, which is its origin; a plane that touches the earth
/// there. Conversions are exact to 1 um within 100 km.
class LocalFrame {
 public:
  /// Points farther than this from the datum are no points of a local frame.
  static constexpr double kMaxDistance_m = 100'000.0;

  /// Throws Error(invalid_argument) for what is no place: not finite, a latitude beyond +-90 deg, a longitude beyond
  /// +-360 deg, a height beyond +-100 km.
  explicit LocalFrame(const Geodetic& datum);

  [[nodiscard]] const Geodetic& datum() const { return datum_; }
  [[nodiscard]] Eigen::Vector3d to_local_m(const Geodetic& place) const;
  /// Longitude in [-180, 180].
  [[nodiscard]] Geodetic to_geodetic(const Eigen::Vector3d& local_m) const;
  /// Takes directions from east, north, up at `place` to the frame: meridians converge, and the plumb line turns.
  [[nodiscard]] Eigen::Matrix3d R_local_enu(const Geodetic& place) const;

 private:
  Geodetic datum_;
  std::shared_ptr<const GeographicLib::LocalCartesian> frame_;
};

}  // namespace berm
