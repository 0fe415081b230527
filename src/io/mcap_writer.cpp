#include "berm/io/mcap_writer.hpp"

#include <algorithm>

#include "crc32.hpp"
#include "record_bytes.hpp"

namespace berm {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
/// What readers hold in memory at a time.
constexpr std::size_t kChunkBytes = std::size_t{4} << 20U;

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

void append_text(std::string& bytes, std::string_view text) {
  append_number(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.append(text);
}

std::string make_record(Opcode opcode, std::string_view content) {
  std::string record;
  record.reserve(content.size() + 9);
  append_number(record, static_cast<std::uint8_t>(opcode));
  append_number(record, static_cast<std::uint64_t>(content.size()));
  record.append(content);
  return record;
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& path) : file_(path) {
  put(kMagic);
  std::string header;
  append_text(header, "");
  append_text(header, "berm");
  put(make_record(Opcode::header, header));
}

void McapWriter::put(std::string_view bytes) {
  file_.write(bytes);
  offset_ += bytes.size();
  crc_ = crc32(bytes, crc_);
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view encoding, std::string_view data) {
  const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);  // 0 stands for none
  std::string content;
  append_number(content, id);
  append_text(content, name);
  append_text(content, encoding);
  append_text(content, data);
  schemas_.push_back(make_record(Opcode::schema, content));
  chunk_.records += schemas_.back();
  return id;
}

std::uint16_t McapWriter::add_channel(std::uint16_t schema, std::string_view topic, std::string_view encoding) {
  const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
  std::string content;
  append_number(content, id);
  append_number(content, schema);
  append_text(content, topic);
  append_text(content, encoding);
  append_number(content, std::uint32_t{0});  // metadata
  channels_.push_back(make_record(Opcode::channel, content));
  chunk_.records += channels_.back();
  counts_[id] = 0;
  return id;
}

void McapWriter::write(std::uint16_t channel, std::uint64_t time_ns, std::string_view message) {
  std::string content;
  content.reserve(message.size() + 22);
  append_number(content, channel);
  append_number(content, static_cast<std::uint32_t>(counts_[channel]));
  append_number(content, time_ns);
  append_number(content, time_ns);
  content.append(message);
  chunk_.index[channel].emplace_back(time_ns, chunk_.records.size());
  chunk_.records += make_record(Opcode::message, content);
  chunk_.first_ns = chunk_.any ? std::min(chunk_.first_ns, time_ns) : time_ns;
  chunk_.last_ns = chunk_.any ? std::max(chunk_.last_ns, time_ns) : time_ns;
  chunk_.any = true;
  first_ns_ = messages_ > 0 ? std::min(first_ns_, time_ns) : time_ns;
  last_ns_ = messages_ > 0 ? std::max(last_ns_, time_ns) : time_ns;
  ++messages_;
  ++counts_[channel];
  if (chunk_.records.size() >= kChunkBytes) {
    end_chunk();
  }
}

void McapWriter::end_chunk() {
  if (chunk_.records.empty()) {
    return;
  }
  const std::uint64_t begin = offset_;
  const auto size = static_cast<std::uint64_t>(chunk_.records.size());
  std::string content;
  content.reserve(chunk_.records.size() + 40);
  append_number(content, chunk_.first_ns);
  append_number(content, chunk_.last_ns);
  append_number(content, size);
  append_number(content, crc32(chunk_.records));
  append_text(content, "");  // no compression
  append_number(content, size);
  content.append(chunk_.records);
  put(make_record(Opcode::chunk, content));
  const std::uint64_t end = offset_;

  std::string places;
  for (const auto& [channel, entries] : chunk_.index) {
    append_number(places, channel);
    append_number(places, offset_);
    std::string list;
    for (const auto& [time_ns, place] : entries) {
      append_number(list, time_ns);
      append_number(list, place);
    }
    std::string index;
    append_number(index, channel);
    append_text(index, list);
    put(make_record(Opcode::message_index, index));
  }

  std::string index;
  append_number(index, chunk_.first_ns);
  append_number(index, chunk_.last_ns);
  append_number(index, begin);
  append_number(index, end - begin);
  append_text(index, places);
  append_number(index, offset_ - end);
  append_text(index, "");
  append_number(index, size);
  append_number(index, size);
  chunk_indices_.push_back(make_record(Opcode::chunk_index, index));
  chunk_ = {};
}

std::string McapWriter::statistics() const {
  std::string counts;
  for (const auto& [channel, count] : counts_) {
    append_number(counts, channel);
    append_number(counts, count);
  }
  std::string content;
  append_number(content, messages_);
  append_number(content, static_cast<std::uint16_t>(schemas_.size()));
  append_number(content, static_cast<std::uint32_t>(channels_.size()));
  append_number(content, std::uint32_t{0});  // attachments
  append_number(content, std::uint32_t{0});  // metadata
  append_number(content, static_cast<std::uint32_t>(chunk_indices_.size()));
  append_number(content, first_ns_);
  append_number(content, last_ns_);
  append_text(content, counts);
  return make_record(Opcode::statistics, content);
}

void McapWriter::write_summary() {
  const std::uint64_t summary_begin = offset_;
  crc_ = 0;
  std::string offsets;
  const auto put_group = [&](Opcode opcode, const std::vector<std::string>& records) {
    const std::uint64_t begin = offset_;
    for (const std::string& record : records) {
      put(record);
    }
    if (offset_ > begin) {
      std::string content;
      append_number(content, static_cast<std::uint8_t>(opcode));
      append_number(content, begin);
      append_number(content, offset_ - begin);
      offsets += make_record(Opcode::summary_offset, content);
    }
  };
  put_group(Opcode::schema, schemas_);
  put_group(Opcode::channel, channels_);
  put_group(Opcode::statistics, {statistics()});
  put_group(Opcode::chunk_index, chunk_indices_);
  const std::uint64_t offsets_begin = offset_;
  put(offsets);

  // The checksum of the summary goes up to itself: the footer without its last field.
  std::string footer;
  append_number(footer, static_cast<std::uint8_t>(Opcode::footer));
  append_number(footer, std::uint64_t{20});
  append_number(footer, summary_begin);
  append_number(footer, offsets_begin);
  put(footer);
  std::string crc;
  append_number(crc, crc_);
  put(crc);
}

void McapWriter::commit() {
  end_chunk();
  std::string end;
  append_number(end, crc_);
  put(make_record(Opcode::data_end, end));
  write_summary();
  put(kMagic);
  file_.commit();
}

}  // namespace berm
