#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "berm/io/atomic_file.hpp"

namespace berm {

/// Writes an MCAP file (https://mcap.dev/spec), version 0, chunks without compression, with all checksums, indices and
/// statistics. Same calls, same bytes.
class McapWriter {
 public:
  /// Begins the file; it appears with `commit`. Throws FileError(write_failed) as AtomicFile, as do all below.
  explicit McapWriter(const std::filesystem::path& path);

  /// A schema that messages follow: its number.
  [[nodiscard]] std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view data);
  /// A channel for messages of one schema: its number.
  [[nodiscard]] std::uint16_t add_channel(std::uint16_t schema, std::string_view topic, std::string_view encoding);
  /// Appends a message. Readers seek by time: an order other than that of time only makes them slower.
  void write(std::uint16_t channel, std::uint64_t time_ns, std::string_view message);
  /// Ends the file and publishes it.
  void commit();

 private:
  struct Chunk {
    std::string records;
    std::uint64_t first_ns = 0;
    std::uint64_t last_ns = 0;
    bool any = false;
    /// Times and places of the messages of each channel.
    std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> index;
  };

  void put(std::string_view bytes);
  void end_chunk();
  [[nodiscard]] std::string statistics() const;
  void write_summary();

  AtomicFile file_;
  std::uint64_t offset_ = 0;
  std::uint32_t crc_ = 0;
  Chunk chunk_;
  std::vector<std::string> schemas_;   ///< whole records
  std::vector<std::string> channels_;  ///< whole records
  std::vector<std::string> chunk_indices_;
  std::map<std::uint16_t, std::uint64_t> counts_;
  std::uint64_t messages_ = 0;
  std::uint64_t first_ns_ = 0;
  std::uint64_t last_ns_ = 0;
};

}  // namespace berm
