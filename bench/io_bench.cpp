#include <filesystem>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "berm/io/kitti_bin.hpp"
#include "berm/io/pcd.hpp"
#include "scans.hpp"

/// Reading a scan from a file that the system holds in memory.
namespace berm::bench {
namespace {

namespace fs = std::filesystem;

/// A file that is gone at the end.
class TempFile {
 public:
  explicit TempFile(const std::string& name)
      : path_(fs::temp_directory_path() / ("berm_bench_" + std::to_string(::getpid()) + name)) {}
  TempFile(const TempFile&) = delete;
  TempFile& operator=(const TempFile&) = delete;
  ~TempFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

template <typename Read>
void measure_reading(benchmark::State& state, const fs::path& path, const Read& read) {
  PointChannels channels;
  for (auto _ : state) {
    ScanRecord record = read(path, std::move(channels));
    benchmark::DoNotOptimize(record.channels.x.data());
    channels = std::move(record.channels);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(fs::file_size(path)));
}

void read_pcd_file(benchmark::State& state, const BenchScan& measured, PcdEncoding encoding) {
  const TempFile file(".pcd");
  write_pcd(file.path(), measured.cloud.view(), encoding);
  measure_reading(state, file.path(),
                  [](const fs::path& path, PointChannels reuse) { return read_pcd(path, std::move(reuse)); });
}

void read_bin_file(benchmark::State& state, const BenchScan& measured) {
  const TempFile file(".bin");
  write_kitti_bin(file.path(), measured.cloud.view(), IntensityScale::byte);
  measure_reading(state, file.path(), [](const fs::path& path, PointChannels reuse) {
    return read_kitti_bin(path, IntensityScale::byte, std::move(reuse));
  });
}

const bool kRegistered = [] {
  const std::pair<const char*, PcdEncoding> encodings[] = {{"read_pcd_binary", PcdEncoding::binary},
                                                           {"read_pcd_compressed", PcdEncoding::binary_compressed},
                                                           {"read_pcd_ascii", PcdEncoding::ascii}};
  for (const std::string& name : made_scans()) {
    benchmark::RegisterBenchmark(("read_kitti_bin/" + name).c_str(), [name](benchmark::State& state) {
      read_bin_file(state, scan(name));
    })->Unit(benchmark::kMicrosecond);
    for (const auto& [reader, encoding] : encodings) {
      benchmark::RegisterBenchmark((std::string(reader) + "/" + name).c_str(), [name, encoding = encoding](
                                                                                   benchmark::State& state) {
        read_pcd_file(state, scan(name), encoding);
      })->Unit(benchmark::kMicrosecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace berm::bench
