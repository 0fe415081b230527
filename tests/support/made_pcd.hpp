#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <lzf.h>

/// PCD files made byte by byte, independent of `write_pcd`: what tests of the reader read.
namespace berm::test {

struct MadeField {
  std::string name;
  char type = 'F';
  std::size_t size = 4;
  std::size_t count = 1;
  std::vector<long double> values;  ///< `count` for each point; long double holds every u64 and every double
};

struct MadePcd {
  std::vector<MadeField> fields;
  std::size_t points = 0;

  [[nodiscard]] std::string header(const std::string& encoding) const {
    std::ostringstream names, sizes, types, counts, all;
    for (const MadeField& field : fields) {
      names << ' ' << field.name;
      sizes << ' ' << field.size;
      types << ' ' << field.type;
      counts << ' ' << field.count;
    }
    all << "VERSION 0.7\nFIELDS" << names.str() << "\nSIZE" << sizes.str() << "\nTYPE" << types.str() << "\nCOUNT"
        << counts.str() << "\nWIDTH " << points << "\nHEIGHT 1\nPOINTS " << points << "\nDATA " << encoding << "\n";
    return all.str();
  }

  [[nodiscard]] std::string ascii() const {
    std::ostringstream body;
    body.precision(21);
    for (std::size_t i = 0; i < points; ++i) {
      for (std::size_t f = 0; f < fields.size(); ++f) {
        for (std::size_t j = 0; j < fields[f].count; ++j) {
          body << (f + j == 0 ? "" : " ") << fields[f].values.at(i * fields[f].count + j);
        }
      }
      body << '\n';
    }
    return header("ascii") + body.str();
  }

  [[nodiscard]] std::string binary() const {
    std::string body;
    for (std::size_t i = 0; i < points; ++i) {
      for (const MadeField& field : fields) {
        append(body, field, i);
      }
    }
    return header("binary") + body;
  }

  [[nodiscard]] std::string binary_compressed() const {
    std::string plain;
    for (const MadeField& field : fields) {
      for (std::size_t i = 0; i < points; ++i) {
        append(plain, field, i);
      }
    }
    std::string packed(plain.size() * 2 + 64, '\0');
    packed.resize(lzf_compress(plain.data(), static_cast<unsigned>(plain.size()), packed.data(),
                               static_cast<unsigned>(packed.size())));
    std::string body;
    append_raw(body, static_cast<std::uint32_t>(packed.size()));
    append_raw(body, static_cast<std::uint32_t>(plain.size()));
    return header("binary_compressed") + body + packed;
  }

  [[nodiscard]] std::string encoded(const std::string& encoding) const {
    return encoding == "ascii" ? ascii() : encoding == "binary" ? binary() : binary_compressed();
  }

 private:
  template <typename Value>
  static void append_raw(std::string& bytes, Value value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(Value));
  }

  static void append(std::string& bytes, const MadeField& field, std::size_t point) {
    for (std::size_t j = 0; j < field.count; ++j) {
      const long double value = field.values.at(point * field.count + j);
      const std::string type = field.type + std::to_string(field.size);
      if (type == "F4") {
        append_raw(bytes, static_cast<float>(value));
      } else if (type == "F8") {
        append_raw(bytes, static_cast<double>(value));
      } else if (type == "I1") {
        append_raw(bytes, static_cast<std::int8_t>(value));
      } else if (type == "U1") {
        append_raw(bytes, static_cast<std::uint8_t>(value));
      } else if (type == "I2") {
        append_raw(bytes, static_cast<std::int16_t>(value));
      } else if (type == "U2") {
        append_raw(bytes, static_cast<std::uint16_t>(value));
      } else if (type == "I4") {
        append_raw(bytes, static_cast<std::int32_t>(value));
      } else if (type == "U4") {
        append_raw(bytes, static_cast<std::uint32_t>(value));
      } else if (type == "I8") {
        append_raw(bytes, static_cast<std::int64_t>(value));
      } else if (type == "U8") {
        append_raw(bytes, static_cast<std::uint64_t>(value));
      } else {
        throw std::logic_error("no such type: " + type);
      }
    }
  }
};

/// Fields x y z of type F4 with the values 0, 1, 2, ...
[[nodiscard]] inline MadePcd made_xyz(std::size_t points) {
  MadePcd pcd{.fields = {}, .points = points};
  for (const char* name : {"x", "y", "z"}) {
    MadeField field{.name = name, .values = {}};
    for (std::size_t i = 0; i < points; ++i) {
      field.values.push_back(static_cast<long double>(i));
    }
    pcd.fields.push_back(field);
  }
  return pcd;
}

[[nodiscard]] inline std::span<const std::byte> as_bytes(const std::string& text) {
  return std::as_bytes(std::span(text));
}

}  // namespace berm::test
