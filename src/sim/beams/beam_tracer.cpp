#include "beam_tracer.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace berm::sim {
namespace {

/// More surfaces than these a ray does not cross: the last one stops it.
constexpr std::uint16_t kMaxCasts = 40;
/// Behind a surface the next cast begins this far on: several roundings of a float at 200 m.
constexpr float kOn_m = 2e-3F;
/// Rays farther apart than this are better cast alone.
constexpr float kApart_rad = 0.08F;

void set_lane(RayPacket& packet, std::size_t lane, const TracedRay& ray, float end_m) {
  packet.x_m[lane] = ray.origin_m.x();
  packet.y_m[lane] = ray.origin_m.y();
  packet.z_m[lane] = ray.origin_m.z();
  packet.dx[lane] = ray.direction.x();
  packet.dy[lane] = ray.direction.y();
  packet.dz[lane] = ray.direction.z();
  packet.min_range_m[lane] = ray.from_m;
  packet.max_range_m[lane] = end_m;
  packet.time_s[lane] = ray.time_s;
}

/// Casts the rays that `ray_at` names, up to eight at a time: as many as follow each other in nearly one direction.
template <typename RayAt>
void cast_packets(const RayCaster& caster, std::size_t count, float max_range_m, const RayAt& ray_at) {
  RayPacket packet{};
  std::size_t lanes = 0;
  for (std::size_t first = 0; first < count; first += lanes) {
    const Eigen::Vector3f& direction = ray_at(first).direction;
    for (lanes = 0; lanes < RayPacket::kSize && first + lanes < count; ++lanes) {
      const TracedRay& ray = ray_at(first + lanes);
      if ((ray.direction - direction).squaredNorm() > kApart_rad * kApart_rad) {
        break;
      }
      set_lane(packet, lanes, ray, std::min(max_range_m, ray.crown_end_m));
    }
    for (std::size_t lane = lanes; lane < RayPacket::kSize; ++lane) {
      // Lanes that are over repeat a ray, so that they have a time and a direction.
      set_lane(packet, lane, ray_at(first), -1.0F);
    }
    caster.cast(packet);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      TracedRay& ray = ray_at(first + lane);
      ray.hit = packet.hits[lane];
      ++ray.casts;
    }
  }
}

void enter_or_leave_crown(TracedRay& ray, Random& random) {
  if (ray.hit.normal.dot(ray.direction) < 0.0F) {
    if (ray.crowns++ == 0) {
      ray.crown_object = ray.hit.object;
      ray.crown_triangle = ray.hit.triangle;
      ray.crown_end_m = ray.hit.range_m + static_cast<float>(kCrownDepth_m * random.exponential());
    }
  } else if (ray.crowns > 0 && --ray.crowns == 0) {
    ray.crown_end_m = std::numeric_limits<float>::infinity();
  }
}

/// Whether the ray ends with its last hit; else it goes on behind it.
bool is_settled(const RayCaster& caster, TracedRay& ray, float max_range_m, Random& random) {
  if (ray.hit.is_nothing()) {
    if (ray.crown_end_m < max_range_m) {
      // Needles and leaves look everywhere: as good as facing the beam.
      ray.hit = {ray.crown_object, ray.crown_triangle, ray.crown_end_m, -ray.direction};
    }
    return true;
  }
  if (ray.hit.object == 0 || ray.casts >= kMaxCasts) {
    return true;
  }
  const Surface surface = caster.material_of(ray.hit).surface;
  if (surface == Surface::foliage) {
    enter_or_leave_crown(ray, random);
  } else if (surface != Surface::net || random.chance(kNetShare)) {
    return true;
  }
  ray.from_m = ray.hit.range_m + kOn_m;
  return false;
}

/// Rays that go through the same tree come together, whenever they were fired: they make better packets. A tree has
/// some fifty triangles in a row; it does no harm that trees far from each other share a bucket.
void gather_by_tree(std::span<const TracedRay> rays, PendingRays& pending) {
  constexpr std::uint32_t kBuckets = 1024;
  constexpr std::uint32_t kTriangles = 32;
  const auto bucket_of = [&](std::uint32_t i) { return rays[i].hit.triangle / kTriangles % kBuckets; };
  std::array<std::uint32_t, kBuckets + 1> begins{};
  for (const std::uint32_t i : pending.rays) {
    ++begins[bucket_of(i) + 1];
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  pending.sorted.resize(pending.rays.size());
  for (const std::uint32_t i : pending.rays) {
    pending.sorted[begins[bucket_of(i)]++] = i;
  }
  pending.rays.swap(pending.sorted);
}

}  // namespace

void cast_all(const RayCaster& caster, std::span<TracedRay> rays, std::size_t step, float max_range_m) {
  if (step == 1) {
    cast_packets(caster, rays.size(), max_range_m, [&](std::size_t i) -> TracedRay& { return rays[i]; });
    return;
  }
  // A block holds a packet of every laser; what is left over goes as it comes.
  const std::size_t block = step * RayPacket::kSize;
  const std::size_t blocks = rays.size() / block * block;
  cast_packets(caster, rays.size(), max_range_m, [&](std::size_t i) -> TracedRay& {
    const std::size_t within = i % block;
    return rays[i < blocks ? i - within + within % RayPacket::kSize * step + within / RayPacket::kSize : i];
  });
}

void settle(const RayCaster& caster, std::span<TracedRay> rays, float max_range_m, std::span<Random> randoms,
            PendingRays& pending) {
  pending.rays.clear();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!is_settled(caster, rays[i], max_range_m, randoms[rays[i].beam])) {
      pending.rays.push_back(static_cast<std::uint32_t>(i));
    }
  }
  gather_by_tree(rays, pending);
  while (!pending.rays.empty()) {
    cast_packets(caster, pending.rays.size(), max_range_m,
                 [&](std::size_t i) -> TracedRay& { return rays[pending.rays[i]]; });
    std::erase_if(pending.rays,
                  [&](std::uint32_t i) { return is_settled(caster, rays[i], max_range_m, randoms[rays[i].beam]); });
  }
}

}  // namespace berm::sim
