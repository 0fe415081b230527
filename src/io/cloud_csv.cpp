#include <iterator>

#include <fmt/format.h>

#include "cloud_files.hpp"

namespace berm {
namespace {

class CsvCloudWriter final : public RecordCloudWriter {
 public:
  CsvCloudWriter(const std::filesystem::path& path, const CloudSummary& summary) : RecordCloudWriter(path, summary) {
    write("x,y,z,intensity,label,time\n");
  }

 private:
  void append(std::string& bytes, const CloudPoint& point) const override {
    fmt::format_to(std::back_inserter(bytes), "{:.3f},{:.3f},{:.3f},{:.1f},{},{:.6f}\n", point.position_m.x(),
                   point.position_m.y(), point.position_m.z(), point.intensity, semantic_kitti_id(point.label),
                   point.time_s);
  }
};

}  // namespace

std::unique_ptr<CloudWriter> make_csv_writer(const std::filesystem::path& path, const CloudSummary& summary) {
  return std::make_unique<CsvCloudWriter>(path, summary);
}

}  // namespace berm
