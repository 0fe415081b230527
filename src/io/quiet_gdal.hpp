#pragma once

#include <string>

namespace berm {

/// Registers GDAL's drivers, and keeps what GDAL has to say from stderr while it lives.
class QuietGdal {
 public:
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;

  /// The last complaint on one line.
  [[nodiscard]] static std::string complaint();
};

}  // namespace berm
