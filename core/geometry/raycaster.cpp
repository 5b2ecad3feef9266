// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/raycaster.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

// Embree may be built with ray masks (Debian's is): a ray whose mask shares no bit with the
// geometry's misses everything.
constexpr unsigned kHitsEverything = ~0u;

/// One device for the process: it holds no scene data, only what Embree found out about the CPU.
/// Never released, because scenes in static storage may outlive any order of destruction.
RTCDevice device() {
  static const RTCDevice instance = rtcNewDevice(nullptr);
  if (!instance) {
    throw std::runtime_error(fmt::format("Embree does not start (error {})",
                                         static_cast<int>(rtcGetDeviceError(nullptr))));
  }
  return instance;
}

// The calls that differ between Embree 3 and 4.
#if RTC_VERSION_MAJOR >= 4
struct QueryArguments {
  explicit QueryArguments(bool coherent) {
    rtcInitIntersectArguments(&intersect);
    rtcInitOccludedArguments(&occluded);
    intersect.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    occluded.flags = intersect.flags;
  }
  RTCIntersectArguments intersect;
  RTCOccludedArguments occluded;
};
void trace(RTCScene scene, QueryArguments& arguments, RTCRayHit& ray) {
  rtcIntersect1(scene, &ray, &arguments.intersect);
}
void trace(RTCScene scene, QueryArguments& arguments, const int* valid, RTCRayHit16& rays) {
  rtcIntersect16(valid, scene, &rays, &arguments.intersect);
}
void shadow(RTCScene scene, QueryArguments& arguments, const int* valid, RTCRay16& rays) {
  rtcOccluded16(valid, scene, &rays, &arguments.occluded);
}
#else
struct QueryArguments {
  explicit QueryArguments(bool coherent) {
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
  RTCIntersectContext context;
};
void trace(RTCScene scene, QueryArguments& arguments, RTCRayHit& ray) {
  rtcIntersect1(scene, &arguments.context, &ray);
}
void trace(RTCScene scene, QueryArguments& arguments, const int* valid, RTCRayHit16& rays) {
  rtcIntersect16(valid, scene, &arguments.context, &rays);
}
void shadow(RTCScene scene, QueryArguments& arguments, const int* valid, RTCRay16& rays) {
  rtcOccluded16(valid, scene, &arguments.context, &rays);
}
#endif

constexpr std::size_t kPacket = 16;

/// Fills lane `lane` of a packet, and the lanes behind it for the last ray.
void setLane(RTCRay16& packet, std::size_t lane, const Raycaster::Ray& ray) {
  packet.org_x[lane] = ray.origin.x();
  packet.org_y[lane] = ray.origin.y();
  packet.org_z[lane] = ray.origin.z();
  packet.dir_x[lane] = ray.direction.x();
  packet.dir_y[lane] = ray.direction.y();
  packet.dir_z[lane] = ray.direction.z();
  packet.tnear[lane] = ray.min_distance;
  packet.tfar[lane] = ray.max_distance;
  packet.time[lane] = 0;
  packet.mask[lane] = kHitsEverything;
  packet.id[lane] = 0;
  packet.flags[lane] = 0;
}

/// Packs `count` rays; lanes behind them are switched off.
void fillPacket(std::span<const Raycaster::Ray> rays, RTCRay16& packet, int* valid) {
  for (std::size_t lane = 0; lane < kPacket; ++lane) {
    setLane(packet, lane, rays[std::min(lane, rays.size() - 1)]);
    valid[lane] = lane < rays.size() ? -1 : 0;
  }
}

/// Nearest point relative to the query, which stands at the origin (Ericson, Real-Time Collision
/// Detection, 5.1.5).
Eigen::Vector3d nearestToOrigin(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const double d1 = -ab.dot(a);
  const double d2 = -ac.dot(a);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = -ab.dot(b);
  const double d4 = -ac.dot(b);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  const double d5 = -ab.dot(c);
  const double d6 = -ac.dot(c);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  }
  // Inside. The foot on the plane keeps more digits than the barycentric sum, which cancels on long
  // thin triangles.
  const Eigen::Vector3d normal = ab.cross(ac);
  return normal * (normal.dot(a) / normal.squaredNorm());
}

}  // namespace

struct Raycaster::Impl {
  struct Triangles {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Eigen::Vector3i> faces;
  };

  Impl() : scene(rtcNewScene(device())) {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
  }
  ~Impl() { rtcReleaseScene(scene); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  RTCScene scene;
  std::vector<Triangles> meshes;
  double largest_coordinate = 0;
  bool committed = false;
};

Raycaster::Raycaster() : impl_(std::make_unique<Impl>()) {}
Raycaster::~Raycaster() = default;
Raycaster::Raycaster(Raycaster&&) noexcept = default;
Raycaster& Raycaster::operator=(Raycaster&&) noexcept = default;

std::uint32_t Raycaster::add(const Mesh& mesh) {
  assert(!impl_->committed);
  const auto index = static_cast<std::uint32_t>(impl_->meshes.size());
  impl_->meshes.push_back({mesh.vertices, mesh.faces});
  if (mesh.faces.empty()) return index;

  RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.vertices.size()));
  auto* faces = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), mesh.faces.size()));
  if (!vertices || !faces) throw std::bad_alloc();
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    impl_->largest_coordinate = std::max(impl_->largest_coordinate, vertex.cwiseAbs().maxCoeff());
    for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(vertex[axis]);
  }
  for (const Eigen::Vector3i& face : mesh.faces) {
    for (int i = 0; i < 3; ++i) {
      assert(face[i] >= 0 && static_cast<std::size_t>(face[i]) < mesh.vertices.size());
      *faces++ = static_cast<unsigned>(face[i]);
    }
  }
  rtcSetGeometryMask(geometry, kHitsEverything);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(impl_->scene, geometry, index);
  rtcReleaseGeometry(geometry);
  return index;
}

void Raycaster::commit() {
  assert(!impl_->committed);
  // The order of triangles inside a leaf decides between equally distant hits, and Embree promises
  // nothing about it when several threads build. On one thread it cannot depend on their number
  // (0.2 s for 500 000 triangles).
  runOnThisThreadOnly([this] { rtcCommitScene(impl_->scene); });
  impl_->committed = true;
}

Raycaster::Hit Raycaster::intersect(const Ray& ray) const {
  assert(impl_->committed);
  RTCRayHit packet = {};
  packet.ray.org_x = ray.origin.x();
  packet.ray.org_y = ray.origin.y();
  packet.ray.org_z = ray.origin.z();
  packet.ray.dir_x = ray.direction.x();
  packet.ray.dir_y = ray.direction.y();
  packet.ray.dir_z = ray.direction.z();
  packet.ray.tnear = ray.min_distance;
  packet.ray.tfar = ray.max_distance;
  packet.ray.mask = kHitsEverything;
  packet.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  packet.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  QueryArguments arguments(false);
  trace(impl_->scene, arguments, packet);
  if (packet.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {packet.hit.geomID, packet.hit.primID, packet.ray.tfar, packet.hit.u, packet.hit.v};
}

void Raycaster::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  assert(impl_->committed && hits.size() == rays.size());
  QueryArguments arguments(true);
  RTCRayHit16 packet;
  alignas(64) int valid[kPacket];
  for (std::size_t begin = 0; begin < rays.size(); begin += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - begin);
    fillPacket(rays.subspan(begin, count), packet.ray, valid);
    std::fill_n(packet.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(packet.hit.instID[0], kPacket, RTC_INVALID_GEOMETRY_ID);
    trace(impl_->scene, arguments, valid, packet);
    for (std::size_t lane = 0; lane < count; ++lane) {
      Hit& hit = hits[begin + lane];
      if (packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) {
        hit = {};
      } else {
        hit = {packet.hit.geomID[lane], packet.hit.primID[lane], packet.ray.tfar[lane],
               packet.hit.u[lane], packet.hit.v[lane]};
      }
    }
  }
}

void Raycaster::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
  assert(impl_->committed && blocked.size() == rays.size());
  QueryArguments arguments(true);
  RTCRay16 packet;
  alignas(64) int valid[kPacket];
  for (std::size_t begin = 0; begin < rays.size(); begin += kPacket) {
    const std::size_t count = std::min(kPacket, rays.size() - begin);
    fillPacket(rays.subspan(begin, count), packet, valid);
    shadow(impl_->scene, arguments, valid, packet);
    for (std::size_t lane = 0; lane < count; ++lane) {
      // Embree marks a blocked ray by a far end of minus infinity.
      blocked[begin + lane] = packet.tfar[lane] < 0 ? 1 : 0;
    }
  }
}

Raycaster::SurfacePoint Raycaster::nearest(const Eigen::Vector3d& query,
                                           double max_distance) const {
  assert(impl_->committed);
  struct Search {
    const std::vector<Impl::Triangles>& meshes;
    const Eigen::Vector3d& query;
    double slack;  ///< [m] by how much float boxes may seem farther than the triangles in double
    double squared_limit;
    SurfacePoint best;
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    double squared_best = std::numeric_limits<double>::infinity();

    /// Returns true where the search radius shrank.
    bool visit(RTCPointQueryFunctionArguments& arguments) {
      const Impl::Triangles& mesh = meshes[arguments.geomID];
      const Eigen::Vector3i& face = mesh.faces[arguments.primID];
      const Eigen::Vector3d to_surface =
          nearestToOrigin(mesh.vertices[static_cast<std::size_t>(face[0])] - query,
                          mesh.vertices[static_cast<std::size_t>(face[1])] - query,
                          mesh.vertices[static_cast<std::size_t>(face[2])] - query);
      const double squared = to_surface.squaredNorm();
      if (!(squared <= squared_limit) || squared > squared_best) return false;
      // Of equally near faces the first one, whatever the order of the visits.
      const bool is_first =
          std::pair(arguments.geomID, arguments.primID) < std::pair(best.mesh, best.face);
      if (squared == squared_best && !is_first) return false;
      best.mesh = arguments.geomID;
      best.face = arguments.primID;
      offset = to_surface;
      const bool shrinks = squared < squared_best;
      squared_best = squared;
      if (shrinks) {
        arguments.query->radius = static_cast<float>(std::sqrt(squared) * (1 + 0x1.0p-20) + slack);
      }
      return shrinks;
    }
  };
  // Vertices, query and Embree's differences of them are rounded to 24 bits each; 16 units cover
  // them in three axes twice.
  const double magnitude = std::max(impl_->largest_coordinate, query.cwiseAbs().maxCoeff());
  const double slack = 16 * 0x1.0p-24 * magnitude;
  Search search{impl_->meshes, query, slack, max_distance * max_distance, {}};

  RTCPointQuery point;
  point.x = static_cast<float>(query.x());
  point.y = static_cast<float>(query.y());
  point.z = static_cast<float>(query.z());
  point.time = 0;
  point.radius = static_cast<float>(max_distance * (1 + 0x1.0p-20) + slack);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(
      impl_->scene, &point, &context,
      [](RTCPointQueryFunctionArguments* arguments) {
        return static_cast<Search*>(arguments->userPtr)->visit(*arguments);
      },
      &search);
  if (search.best.face == kMiss) return search.best;
  search.best.position = query + search.offset;
  search.best.distance = std::sqrt(search.squared_best);
  return search.best;
}

Eigen::Vector3d nearestPointOnTriangle(const Eigen::Vector3d& query, const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return query + nearestToOrigin(a - query, b - query, c - query);
}

}  // namespace hydrabench
