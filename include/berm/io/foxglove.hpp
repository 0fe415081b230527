#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "berm/core/edge.hpp"
#include "berm/core/pose.hpp"
#include "berm/core/stamp.hpp"

namespace berm {

/// Messages with Foxglove's well-known schemas, as protobuf. Its program draws them without being told how.

inline constexpr const char* kFoxglovePointCloud = "foxglove.PointCloud";
inline constexpr const char* kFoxgloveFrameTransform = "foxglove.FrameTransform";
inline constexpr const char* kFoxglovePoseInFrame = "foxglove.PoseInFrame";
inline constexpr const char* kFoxgloveSceneUpdate = "foxglove.SceneUpdate";

/// The schemas of all messages below as a FileDescriptorSet: what the schema record of an MCAP file holds. Parts of a
/// scene that berm never draws are there by name and without fields, since readers expect their lists.
[[nodiscard]] std::string foxglove_schemas();

/// Kinds of numbers in a point; the values are Foxglove's.
enum class PackedType : std::uint8_t { uint8 = 1, uint16 = 3, uint32 = 5, float32 = 7, float64 = 8 };

struct PackedField {
  std::string_view name;
  std::uint32_t offset = 0;  ///< bytes
  PackedType type = PackedType::float32;
};

/// Points of `stride` bytes each, in `frame`.
[[nodiscard]] std::string encode_point_cloud(Stamp stamp_ns, std::string_view frame, std::uint32_t stride,
                                             std::span<const PackedField> fields, std::string_view points);

[[nodiscard]] std::string encode_frame_transform(Stamp stamp_ns, std::string_view parent, std::string_view child,
                                                 const Pose& T_parent_child);

[[nodiscard]] std::string encode_pose(Stamp stamp_ns, std::string_view frame, const Pose& T_frame_object);

/// Every line as an entity of its own, "edge 0" and so on: blue left, orange right, the fainter the less certain.
[[nodiscard]] std::string encode_edge_scene(Stamp stamp_ns, std::string_view frame, std::span<const EdgeLine> lines);

}  // namespace berm
