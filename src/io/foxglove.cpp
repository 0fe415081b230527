#include "berm/io/foxglove.hpp"

#include "proto_writer.hpp"

namespace berm {
namespace {

/// Protobuf's google.protobuf.Timestamp; nanoseconds count upwards also before the epoch.
ProtoWriter timestamp(Stamp stamp_ns) {
  constexpr Stamp kSecond_ns = 1'000'000'000;
  Stamp seconds = stamp_ns / kSecond_ns;
  Stamp rest_ns = stamp_ns % kSecond_ns;
  if (rest_ns < 0) {
    rest_ns += kSecond_ns;
    --seconds;
  }
  ProtoWriter message;
  message.add_integer(1, static_cast<std::uint64_t>(seconds));
  message.add_integer(2, static_cast<std::uint64_t>(rest_ns));
  return message;
}

ProtoWriter vector3(const Eigen::Vector3d& value) {
  ProtoWriter message;
  message.add_real(1, value.x());
  message.add_real(2, value.y());
  message.add_real(3, value.z());
  return message;
}

ProtoWriter quaternion(const Eigen::Quaterniond& value) {
  ProtoWriter message;
  message.add_real(1, value.x());
  message.add_real(2, value.y());
  message.add_real(3, value.z());
  message.add_real(4, value.w());
  return message;
}

ProtoWriter pose_message(const Pose& pose) {
  ProtoWriter message;
  message.add_message(1, vector3(pose.translation_m()));
  message.add_message(2, quaternion(pose.rotation()));
  return message;
}

/// Blue and orange stay apart for everybody (Okabe and Ito).
ProtoWriter edge_color(EdgeSide side, double confidence) {
  constexpr double kBlue[3] = {0.34, 0.71, 0.91};
  constexpr double kOrange[3] = {0.9, 0.62, 0.0};
  constexpr double kFaintest = 0.25;
  const double* color = side == EdgeSide::left ? kBlue : kOrange;
  ProtoWriter message;
  for (int channel = 0; channel < 3; ++channel) {
    message.add_real(channel + 1, color[channel]);
  }
  message.add_real(4, kFaintest + (1.0 - kFaintest) * confidence);
  return message;
}

ProtoWriter edge_line(const EdgeLine& line) {
  constexpr double kThickness_m = 0.15;
  ProtoWriter message;
  message.add_integer(1, 0);  // LINE_STRIP
  message.add_message(2, pose_message({}));
  message.add_real(3, kThickness_m);
  for (const EdgeLine::Vertex& vertex : line.vertices) {
    message.add_message(5, vector3(vertex.position_m));
  }
  for (const EdgeLine::Vertex& vertex : line.vertices) {
    message.add_message(7, edge_color(line.side, vertex.confidence));
  }
  return message;
}

}  // namespace

std::string encode_point_cloud(Stamp stamp_ns, std::string_view frame, std::uint32_t stride,
                               std::span<const PackedField> fields, std::string_view points) {
  ProtoWriter message;
  message.add_message(1, timestamp(stamp_ns));
  message.add_bytes(2, frame);
  message.add_message(3, pose_message({}));
  message.add_fixed32(4, stride);
  for (const PackedField& field : fields) {
    ProtoWriter packed;
    packed.add_bytes(1, field.name);
    packed.add_fixed32(2, field.offset);
    packed.add_integer(3, static_cast<std::uint64_t>(field.type));
    message.add_message(5, packed);
  }
  message.add_bytes(6, points);
  return message.bytes();
}

std::string encode_frame_transform(Stamp stamp_ns, std::string_view parent, std::string_view child,
                                   const Pose& T_parent_child) {
  ProtoWriter message;
  message.add_message(1, timestamp(stamp_ns));
  message.add_bytes(2, parent);
  message.add_bytes(3, child);
  message.add_message(4, vector3(T_parent_child.translation_m()));
  message.add_message(5, quaternion(T_parent_child.rotation()));
  return message.bytes();
}

std::string encode_pose(Stamp stamp_ns, std::string_view frame, const Pose& T_frame_object) {
  ProtoWriter message;
  message.add_message(1, timestamp(stamp_ns));
  message.add_bytes(2, frame);
  message.add_message(3, pose_message(T_frame_object));
  return message.bytes();
}

std::string encode_edge_scene(Stamp stamp_ns, std::string_view frame, std::span<const EdgeLine> lines) {
  ProtoWriter message;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ProtoWriter entity;
    entity.add_message(1, timestamp(stamp_ns));
    entity.add_bytes(2, frame);
    entity.add_bytes(3, "edge " + std::to_string(i));
    entity.add_message(11, edge_line(lines[i]));
    message.add_message(2, entity);
  }
  return message.bytes();
}

}  // namespace berm
