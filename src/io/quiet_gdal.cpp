#include "quiet_gdal.hpp"

#include <mutex>

#include <cpl_error.h>
#include <gdal_priv.h>

namespace berm {

QuietGdal::QuietGdal() {
  // Drivers register with the process, once.
  static std::once_flag registered;
  std::call_once(registered, [] { GDALAllRegister(); });
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLErrorReset();
}

QuietGdal::~QuietGdal() {
  CPLPopErrorHandler();
}

std::string QuietGdal::complaint() {
  const std::string text = CPLGetLastErrorMsg();
  return text.empty() ? "GDAL does not say why" : text;
}

}  // namespace berm
