#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "berm/io/atomic_file.hpp"
#include "berm/io/cloud_writer.hpp"

namespace berm {

/// What the three formats share: a head, then a record a point.
class RecordCloudWriter : public CloudWriter {
 public:
  RecordCloudWriter(const std::filesystem::path& path, const CloudSummary& summary) : file_(path), summary_(summary) {}

  void add(std::span<const CloudPoint> points) final;
  void commit() final;

 protected:
  void write(const std::string& bytes) { file_.write(bytes); }
  [[nodiscard]] const CloudSummary& summary() const { return summary_; }

 private:
  virtual void append(std::string& bytes, const CloudPoint& point) const = 0;

  AtomicFile file_;
  CloudSummary summary_;
  std::uint64_t written_ = 0;
  std::string bytes_;
};

[[nodiscard]] std::unique_ptr<CloudWriter> make_ply_writer(const std::filesystem::path& path,
                                                           const CloudSummary& summary, const LabelColors& colors);
[[nodiscard]] std::unique_ptr<CloudWriter> make_las_writer(const std::filesystem::path& path,
                                                           const CloudSummary& summary, const LabelColors& colors);
[[nodiscard]] std::unique_ptr<CloudWriter> make_csv_writer(const std::filesystem::path& path,
                                                           const CloudSummary& summary);

}  // namespace berm
