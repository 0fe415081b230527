#pragma once

#include <cstdio>
#include <string>

namespace berm::test {

/// `body` as a sentence: with '$', checksum and line end.
inline std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) {
    sum ^= static_cast<unsigned char>(c);
  }
  char text[8];
  std::snprintf(text, sizeof text, "*%02X\r\n", sum);
  return "$" + body + text;
}

/// A position near 48 N, 11.5 E, `minutes` of longitude and 545.4 + 46.9 m up.
inline std::string gga(const std::string& time, const std::string& minutes, int quality = 4) {
  return sentence("GNGGA," + time + ",4800.0000000,N,01130." + minutes + ",E," + std::to_string(quality) +
                  ",14,0.7,545.400,M,46.900,M,1.0,0001");
}

inline std::string hdt(const std::string& heading) {
  return sentence("GNHDT," + heading + ",T");
}

}  // namespace berm::test
