#include "berm/odometry/odometry.hpp"

namespace berm {

std::string_view health_name(OdometryHealth health) {
  switch (health) {
    case OdometryHealth::good:
      return "good";
    case OdometryHealth::starting:
      return "starting";
    case OdometryHealth::weak:
      return "weak";
    case OdometryHealth::lost:
      break;
  }
  return "lost";
}

}  // namespace berm
