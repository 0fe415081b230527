#include "dust.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace berm::sim {
namespace {

/// Plumes that one beam can be in at once; more of them add nothing that could be seen.
constexpr std::size_t kMaxCrossed = 16;
/// Beams that pass a plume farther from its middle than this many sigmas miss it.
constexpr double kReach = 4.0;
/// Thinner plumes are as thick as this.
constexpr double kLeastSigma = 0.01;
/// Reflectivity of a dense wall of mineral dust: pi over its lidar ratio of about 45 sr.
constexpr double kDustReflectivity = 0.07;
/// Depth of air whose echoes fall together: half the length of a pulse of 5 ns.
constexpr double kPulseDepth = 0.75;

/// A Gaussian plume along a beam: extinction peak * exp(-((r - middle) / width)^2 / 2).
struct Crossing {
  double peak_per_m;
  double middle_m;
  double width_m;

  [[nodiscard]] double extinction(double range_m) const {
    const double place = (range_m - middle_m) / width_m;
    return peak_per_m * std::exp(-0.5 * place * place);
  }
  /// One-way optical depth from the sensor to a range.
  [[nodiscard]] double depth(double range_m) const {
    const double scale = 1.0 / (std::numbers::sqrt2 * width_m);
    return peak_per_m * width_m * std::sqrt(std::numbers::pi / 2.0) *
           (std::erf((range_m - middle_m) * scale) + std::erf(middle_m * scale));
  }
};

class Crossings {
 public:
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): a beam fills as many crossings as it reads
  Crossings(const PlumeTree& tree, const std::vector<Eigen::Vector3d>& per_sigma, const AirBeam& beam) {
    tree.visit(beam, [&](std::size_t i) {
      const Plume& plume = tree.plumes()[i];
      const Eigen::Vector3d from = (beam.origin_m - plume.center_m).cwiseProduct(per_sigma[i]);
      const Eigen::Vector3d along = beam.direction.cwiseProduct(per_sigma[i]);
      const double square = along.squaredNorm();
      const double middle_m = -from.dot(along) / square;
      const double miss = from.squaredNorm() - middle_m * middle_m * square;
      if (miss >= kReach * kReach || count_ == kMaxCrossed) {
        return;
      }
      const double width_m = 1.0 / std::sqrt(square);
      if (middle_m > -kReach * width_m && middle_m < beam.end_m + kReach * width_m) {
        crossings_[count_] = {plume.extinction_per_m * std::exp(-0.5 * miss), middle_m, width_m};
        ++count_;
      }
    });
  }

  [[nodiscard]] bool is_empty() const { return count_ == 0; }
  [[nodiscard]] double extinction(double range_m) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      sum += crossings_[i].extinction(range_m);
    }
    return sum;
  }
  [[nodiscard]] double depth(double range_m) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      sum += crossings_[i].depth(range_m);
    }
    return sum;
  }
  /// The range up to which the depth is `depth`, between 0 and `end_m`: Newton's steps, halving where they leave.
  [[nodiscard]] double range_of(double sought, double end_m) const {
    double low = 0.0;
    double high = end_m;
    double range_m = 0.5 * end_m;
    for (int i = 0; i < 40 && high - low > 1e-4; ++i) {
      const double excess = depth(range_m) - sought;
      (excess > 0.0 ? high : low) = range_m;
      const double next = range_m - excess / std::max(extinction(range_m), 1e-12);
      const bool settled = std::abs(next - range_m) < 1e-4;
      range_m = next > low && next < high ? next : 0.5 * (low + high);
      if (settled) {
        break;
      }
    }
    return range_m;
  }

 private:
  std::array<Crossing, kMaxCrossed> crossings_;
  std::size_t count_ = 0;
};

}  // namespace

Dust::Dust(std::vector<Plume> plumes, const OpticsConfig& optics)
    : tree_(std::move(plumes), kReach), optics_(optics), limit_(optics.detection_limit()) {
  for (const Plume& plume : tree_.plumes()) {
    per_sigma_.emplace_back(plume.sigma_m.cwiseMax(kLeastSigma).cwiseInverse());
  }
}

void Dust::pass(const AirBeam& beam, Random& random, AirPath& path) const {
  const Crossings crossings(tree_, per_sigma_, beam);
  if (crossings.is_empty()) {
    return;
  }
  const double total = crossings.depth(beam.end_m);
  if (path.has_echo) {
    const double passed = std::exp(-2.0 * crossings.depth(path.echo.range_m));
    path.echo.light *= passed;
    path.echo.reflectivity *= passed;
    path.has_echo = path.echo.light >= limit_;
  }
  path.transmission *= std::exp(-2.0 * total);
  const double sought = random.exponential();
  if (sought >= total) {
    return;
  }
  const double range_m = crossings.range_of(sought, beam.end_m);
  const double share = 1.0 - std::exp(-crossings.extinction(range_m) * kPulseDepth);
  const double light = received_light(optics_, kDustReflectivity, share, range_m) * std::exp(-2.0 * sought);
  const bool is_hidden = path.has_echo && path.echo.range_m < range_m;
  if (light < limit_ || range_m < optics_.min_range_m || range_m > optics_.max_range_m || is_hidden) {
    return;
  }
  path.has_echo = true;
  path.echo = {range_m, light, 100.0 * light * range_m * range_m, true};
}

}  // namespace berm::sim
