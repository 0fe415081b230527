#include <initializer_list>

#include "berm/io/foxglove.hpp"
#include "proto_writer.hpp"

namespace berm {
namespace {

/// Numbers of FieldDescriptorProto.Type.
enum class Kind : std::uint8_t {
  real = 1,
  int64 = 3,
  int32 = 5,
  fixed32 = 7,
  flag = 8,
  text = 9,
  message = 11,
  bytes = 12,
  choice = 14,
};

struct Field {
  const char* name = nullptr;
  int number = 0;
  Kind kind = Kind::text;
  const char* type = nullptr;  ///< full name of a message or enum
  bool repeated = false;
};

ProtoWriter field_descriptor(const Field& field) {
  constexpr std::uint64_t kOptional = 1;
  constexpr std::uint64_t kRepeated = 3;
  ProtoWriter descriptor;
  descriptor.add_bytes(1, field.name);
  descriptor.add_integer(3, static_cast<std::uint64_t>(field.number));
  descriptor.add_integer(4, field.repeated ? kRepeated : kOptional);
  descriptor.add_integer(5, static_cast<std::uint64_t>(field.kind));
  if (field.type != nullptr) {
    descriptor.add_bytes(6, field.type);
  }
  return descriptor;
}

ProtoWriter message_descriptor(const char* name, std::initializer_list<Field> fields) {
  ProtoWriter descriptor;
  descriptor.add_bytes(1, name);
  for (const Field& field : fields) {
    descriptor.add_message(2, field_descriptor(field));
  }
  return descriptor;
}

/// An enum inside of a message; its values count from 0.
ProtoWriter enum_descriptor(const char* name, std::initializer_list<const char*> values) {
  ProtoWriter descriptor;
  descriptor.add_bytes(1, name);
  std::uint64_t number = 0;
  for (const char* value : values) {
    ProtoWriter entry;
    entry.add_bytes(1, value);
    entry.add_integer(2, number++);
    descriptor.add_message(2, entry);
  }
  return descriptor;
}

ProtoWriter file_descriptor(const char* name, const char* package, std::initializer_list<const char*> imports) {
  ProtoWriter descriptor;
  descriptor.add_bytes(1, name);
  descriptor.add_bytes(2, package);
  for (const char* import : imports) {
    descriptor.add_bytes(3, import);
  }
  return descriptor;
}

constexpr const char* kTimestamp = ".google.protobuf.Timestamp";
constexpr const char* kDuration = ".google.protobuf.Duration";
constexpr const char* kVector3 = ".foxglove.Vector3";
constexpr const char* kQuaternion = ".foxglove.Quaternion";
constexpr const char* kPose = ".foxglove.Pose";
constexpr const char* kColor = ".foxglove.Color";

ProtoWriter google_file(const char* file, const char* name) {
  ProtoWriter descriptor = file_descriptor(file, "google.protobuf", {});
  descriptor.add_message(4, message_descriptor(name, {{"seconds", 1, Kind::int64}, {"nanos", 2, Kind::int32}}));
  descriptor.add_bytes(12, "proto3");
  return descriptor;
}

void add_geometry(ProtoWriter& file) {
  for (const char* name : {"Vector3", "Point3"}) {
    file.add_message(4, message_descriptor(name, {{"x", 1, Kind::real}, {"y", 2, Kind::real}, {"z", 3, Kind::real}}));
  }
  file.add_message(
      4, message_descriptor("Quaternion",
                            {{"x", 1, Kind::real}, {"y", 2, Kind::real}, {"z", 3, Kind::real}, {"w", 4, Kind::real}}));
  file.add_message(
      4, message_descriptor("Color",
                            {{"r", 1, Kind::real}, {"g", 2, Kind::real}, {"b", 3, Kind::real}, {"a", 4, Kind::real}}));
  file.add_message(4, message_descriptor("Pose", {{"position", 1, Kind::message, kVector3},
                                                  {"orientation", 2, Kind::message, kQuaternion}}));
}

void add_poses(ProtoWriter& file) {
  file.add_message(4, message_descriptor("PoseInFrame", {{"timestamp", 1, Kind::message, kTimestamp},
                                                         {"frame_id", 2, Kind::text},
                                                         {"pose", 3, Kind::message, kPose}}));
  file.add_message(4, message_descriptor("FrameTransform", {{"timestamp", 1, Kind::message, kTimestamp},
                                                            {"parent_frame_id", 2, Kind::text},
                                                            {"child_frame_id", 3, Kind::text},
                                                            {"translation", 4, Kind::message, kVector3},
                                                            {"rotation", 5, Kind::message, kQuaternion}}));
}

void add_cloud(ProtoWriter& file) {
  ProtoWriter packed =
      message_descriptor("PackedElementField", {{"name", 1, Kind::text},
                                                {"offset", 2, Kind::fixed32},
                                                {"type", 3, Kind::choice, ".foxglove.PackedElementField.NumericType"}});
  packed.add_message(4, enum_descriptor("NumericType", {"UNKNOWN", "UINT8", "INT8", "UINT16", "INT16", "UINT32",
                                                        "INT32", "FLOAT32", "FLOAT64"}));
  file.add_message(4, packed);
  file.add_message(4,
                   message_descriptor("PointCloud", {{"timestamp", 1, Kind::message, kTimestamp},
                                                     {"frame_id", 2, Kind::text},
                                                     {"pose", 3, Kind::message, kPose},
                                                     {"point_stride", 4, Kind::fixed32},
                                                     {"fields", 5, Kind::message, ".foxglove.PackedElementField", true},
                                                     {"data", 6, Kind::bytes}}));
}

void add_scene(ProtoWriter& file) {
  for (const char* name : {"ArrowPrimitive", "CubePrimitive", "SpherePrimitive", "CylinderPrimitive",
                           "TriangleListPrimitive", "TextPrimitive", "ModelPrimitive"}) {
    file.add_message(4, message_descriptor(name, {}));
  }
  file.add_message(4, message_descriptor("KeyValuePair", {{"key", 1, Kind::text}, {"value", 2, Kind::text}}));
  ProtoWriter line = message_descriptor("LinePrimitive", {{"type", 1, Kind::choice, ".foxglove.LinePrimitive.Type"},
                                                          {"pose", 2, Kind::message, kPose},
                                                          {"thickness", 3, Kind::real},
                                                          {"scale_invariant", 4, Kind::flag},
                                                          {"points", 5, Kind::message, ".foxglove.Point3", true},
                                                          {"color", 6, Kind::message, kColor},
                                                          {"colors", 7, Kind::message, kColor, true},
                                                          {"indices", 8, Kind::fixed32, nullptr, true}});
  line.add_message(4, enum_descriptor("Type", {"LINE_STRIP", "LINE_LOOP", "LINE_LIST"}));
  file.add_message(4, line);
  file.add_message(
      4, message_descriptor("SceneEntity", {{"timestamp", 1, Kind::message, kTimestamp},
                                            {"frame_id", 2, Kind::text},
                                            {"id", 3, Kind::text},
                                            {"lifetime", 4, Kind::message, kDuration},
                                            {"frame_locked", 5, Kind::flag},
                                            {"metadata", 6, Kind::message, ".foxglove.KeyValuePair", true},
                                            {"arrows", 7, Kind::message, ".foxglove.ArrowPrimitive", true},
                                            {"cubes", 8, Kind::message, ".foxglove.CubePrimitive", true},
                                            {"spheres", 9, Kind::message, ".foxglove.SpherePrimitive", true},
                                            {"cylinders", 10, Kind::message, ".foxglove.CylinderPrimitive", true},
                                            {"lines", 11, Kind::message, ".foxglove.LinePrimitive", true},
                                            {"triangles", 12, Kind::message, ".foxglove.TriangleListPrimitive", true},
                                            {"texts", 13, Kind::message, ".foxglove.TextPrimitive", true},
                                            {"models", 14, Kind::message, ".foxglove.ModelPrimitive", true}}));
  ProtoWriter deletion =
      message_descriptor("SceneEntityDeletion", {{"timestamp", 1, Kind::message, kTimestamp},
                                                 {"type", 2, Kind::choice, ".foxglove.SceneEntityDeletion.Type"},
                                                 {"id", 3, Kind::text}});
  deletion.add_message(4, enum_descriptor("Type", {"MATCHING_ID", "ALL"}));
  file.add_message(4, deletion);
  file.add_message(
      4, message_descriptor("SceneUpdate", {{"deletions", 1, Kind::message, ".foxglove.SceneEntityDeletion", true},
                                            {"entities", 2, Kind::message, ".foxglove.SceneEntity", true}}));
}

}  // namespace

std::string foxglove_schemas() {
  constexpr const char* kTimestampFile = "google/protobuf/timestamp.proto";
  constexpr const char* kDurationFile = "google/protobuf/duration.proto";
  ProtoWriter file = file_descriptor("foxglove/berm.proto", "foxglove", {kTimestampFile, kDurationFile});
  add_geometry(file);
  add_poses(file);
  add_cloud(file);
  add_scene(file);
  file.add_bytes(12, "proto3");
  ProtoWriter set;
  set.add_message(1, google_file(kTimestampFile, "Timestamp"));
  set.add_message(1, google_file(kDurationFile, "Duration"));
  set.add_message(1, file);
  return set.bytes();
}

}  // namespace berm
