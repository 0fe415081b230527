#include "feature_map.hpp"

#include <Eigen/Eigenvalues>
#include <nanoflann.hpp>

namespace berm {
namespace {

constexpr std::size_t kNeighbours = 5;
/// Points of a leaf of the trees.
constexpr std::size_t kLeaf = 10;
/// The map is cut every so many scans.
constexpr std::size_t kFeatureCutEvery = 10;

/// What nanoflann asks of a set of points.
struct Means {
  const std::vector<VoxelMean>& means;

  // NOLINTBEGIN(readability-identifier-naming): the names are nanoflann's
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return means.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const {
    return means[index].mean_m[static_cast<Eigen::Index>(axis)];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
  // NOLINTEND(readability-identifier-naming)
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Means>, Means, 3, std::uint32_t>;

/// LOAM-Livox' tests, which its program has but leaves off: P asks for them.
bool is_line(const Eigen::Vector3d& ascending_m2) {
  return ascending_m2[2] > 3.0 * ascending_m2[1];
}
bool is_plane(const Eigen::Vector3d& ascending_m2) {
  return ascending_m2[2] > 3.0 * ascending_m2[0] && ascending_m2[2] < 10.0 * ascending_m2[1];
}

}  // namespace

std::optional<FeatureSurface> surface_through(const std::array<Eigen::Vector3d, 5>& neighbours_m, bool edge) {
  Eigen::Vector3d mean_m = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point_m : neighbours_m) {
    mean_m += point_m / static_cast<double>(kNeighbours);
  }
  Eigen::Matrix3d scatter_m2 = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point_m : neighbours_m) {
    scatter_m2 += (point_m - mean_m) * (point_m - mean_m).transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(scatter_m2, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& eigenvalues_m2 = solver.eigenvalues();
  const Eigen::Vector3d& first_m = neighbours_m[0];
  const Eigen::Vector3d to_last_m = neighbours_m[4] - first_m;
  Eigen::Vector3d axis_m = to_last_m;
  if (!edge) {
    axis_m = (neighbours_m[2] - neighbours_m[4]).cross(neighbours_m[2] - first_m);
  }
  const double length = axis_m.norm();
  // Below, rounding gives the direction.
  constexpr double kShortest = 1e-9;
  if (!(edge ? is_line(eigenvalues_m2) : is_plane(eigenvalues_m2)) || !(length > kShortest)) {
    return std::nullopt;
  }
  return FeatureSurface{first_m, axis_m / length};
}

struct FeatureMap::Layer {
  explicit Layer(double voxel_m) : points(voxel_m) {}

  VoxelMeans points;
  std::vector<VoxelMean> indexed;  ///< as the tree knows them
  Means adaptor{indexed};
  Tree tree{3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(kLeaf)};
};

FeatureMap::FeatureMap(const FeatureOdometryConfig& config) : config_(config) {
  for (std::size_t i = 0; i < kFeatureClasses; ++i) {
    const bool edge = is_edge(static_cast<FeatureClass>(i));
    layers_.push_back(std::make_unique<Layer>(edge ? config.edge_spacing_m : config.plane_spacing_m));
  }
}

FeatureMap::~FeatureMap() = default;

void FeatureMap::add(const Eigen::Vector3d& world_m, FeatureClass kind, std::size_t scan) {
  layers_[static_cast<std::size_t>(kind)]->points.add(world_m, 0.0, scan);
}

void FeatureMap::update(const Eigen::Vector3d& center_m, std::size_t scan) {
  const auto keep = static_cast<std::size_t>(config_.keep_scans);
  for (const auto& layer : layers_) {
    if (scan % kFeatureCutEvery == 0) {
      layer->points.cut(center_m, config_.keep_m, scan > keep ? scan - keep : 0);
    }
    layer->indexed = layer->points.means();
    layer->tree.buildIndex();
  }
}

std::optional<FeatureSurface> FeatureMap::find(const Eigen::Vector3d& world_m, FeatureClass kind) const {
  const Layer& layer = *layers_[static_cast<std::size_t>(kind)];
  if (layer.indexed.size() < kNeighbours) {
    return std::nullopt;
  }
  std::array<std::uint32_t, kNeighbours> index{};
  std::array<double, kNeighbours> distance_m2{};
  layer.tree.knnSearch(world_m.data(), kNeighbours, index.data(), distance_m2.data());
  const bool edge = is_edge(kind);
  const double limit_m = edge ? config_.max_edge_distance_m : config_.max_plane_distance_m;
  if (!(distance_m2.back() < limit_m * limit_m)) {
    return std::nullopt;
  }
  std::array<Eigen::Vector3d, kNeighbours> neighbours_m;
  for (std::size_t i = 0; i < kNeighbours; ++i) {
    neighbours_m[i] = layer.indexed[index[i]].mean_m;
  }
  return surface_through(neighbours_m, edge);
}

std::size_t FeatureMap::planes() const {
  return layers_[static_cast<std::size_t>(FeatureClass::piste_plane)]->indexed.size() +
         layers_[static_cast<std::size_t>(FeatureClass::obstacle_plane)]->indexed.size();
}

std::size_t FeatureMap::size() const {
  std::size_t sum = 0;
  for (const auto& layer : layers_) {
    sum += layer->points.size();
  }
  return sum;
}

}  // namespace berm
