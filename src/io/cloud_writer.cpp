#include "berm/io/cloud_writer.hpp"

#include "berm/core/error.hpp"
#include "cloud_files.hpp"

namespace berm {

void CloudSummary::add(const Eigen::Vector3d& position_m) {
  min_m = points == 0 ? position_m : Eigen::Vector3d(min_m.cwiseMin(position_m));
  max_m = points == 0 ? position_m : Eigen::Vector3d(max_m.cwiseMax(position_m));
  ++points;
}

void RecordCloudWriter::add(std::span<const CloudPoint> points) {
  bytes_.clear();
  for (const CloudPoint& point : points) {
    append(bytes_, point);
  }
  file_.write(bytes_);
  written_ += points.size();
}

void RecordCloudWriter::commit() {
  if (written_ != summary_.points) {
    throw Error(ErrorCode::invalid_argument, file_.target().string() + ": " + std::to_string(written_) +
                                                 " points were written where the head says " +
                                                 std::to_string(summary_.points));
  }
  file_.commit();
}

std::unique_ptr<CloudWriter> make_cloud_writer(CloudFormat format, const std::filesystem::path& path,
                                               const CloudSummary& summary, const LabelColors& colors) {
  switch (format) {
    case CloudFormat::ply:
      return make_ply_writer(path, summary, colors);
    case CloudFormat::las:
      return make_las_writer(path, summary, colors);
    case CloudFormat::csv:
      break;
  }
  return make_csv_writer(path, summary);
}

}  // namespace berm
