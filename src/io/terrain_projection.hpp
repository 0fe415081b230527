#pragma once

#include <functional>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "berm/io/datum.hpp"

namespace berm {

/// From a place on the earth to the coordinates of a model; none where they have none.
using ToModel = std::function<std::optional<Eigen::Vector2d>(const Geodetic&)>;

/// Throws FileError(unsupported) naming `file` for a `crs` (WKT) that GDAL does not know, or without GDAL.
[[nodiscard]] ToModel projection_to(const std::string& crs, const std::string& file);

}  // namespace berm
