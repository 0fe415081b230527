#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace berm {

/// Side of the road that an edge bounds, as seen by who drives it.
enum class EdgeSide : std::uint8_t { left, right };

/// What bounds the road.
enum class EdgeKind : std::uint8_t {
  rise,  ///< the toe of a berm, a bank, a wall, a kerb
  drop,  ///< no berm: the ground falls away
};

/// An edge of a road in the world frame, along the road; what lies between two lines is a gap.
struct EdgeLine {
  struct Vertex {
    Eigen::Vector3d position_m;
    double confidence = 1.0;                             ///< 0..1
    std::optional<double> berm_height_m = std::nullopt;  ///< above the road at its toe, 0 at a drop; none: not known
  };

  EdgeSide side = EdgeSide::left;
  std::vector<Vertex> vertices;
};

}  // namespace berm
