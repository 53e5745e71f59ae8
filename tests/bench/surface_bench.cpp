// The surface of the shared face: posing all of it, projecting strokes onto it, refitting and loading, against peers in
// one run.

#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdio>
#include <embree3/rtcore.h>

#include "core/base/math.h"
#include "core/curve/projection.h"
#include "core/geometry/bvh.h"
#include "core/geometry/camera.h"
#include "core/io/model/read_model.h"
#include "core/rig/surface_poser.h"
#include "tests/support/shared_data.h"

namespace {

using namespace penpose;

const std::vector<std::uint8_t>& file() {
  static const auto bytes = tests::read_file(tests::shared_dir() / "meshes" / "ict_face.glb");
  return bytes;
}
const document::Model& face() {
  static const document::Model model = io::read_model(file(), "ict_face.glb").value();
  return model;
}

rig::Pose pose_number(int k) {
  rig::Pose pose(face().pose.size());
  for (std::size_t i = 0; i < pose.size(); ++i)
    pose[i] = static_cast<double>((i * 7 + static_cast<std::size_t>(k) * 13) % 101) / 200.0;
  return pose;
}

/// Positions and normals of the whole face, all 53 parameters moving.
void pose_surface(benchmark::State& state) {
  rig::SurfacePoser poser(face().rig);
  const rig::Pose poses[] = {pose_number(1), pose_number(2)};
  int k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(poser.update(poses[++k % 2]));
}

/// The peer: every delta of every vertex as one dense loop over floats, positions alone.
void pose_dense_loop(benchmark::State& state) {
  const std::size_t n = face().mesh->vertex_count() * 3;
  std::vector<float> rest(n);
  for (std::size_t v = 0; v < face().mesh->vertex_count(); ++v) {
    for (int a = 0; a < 3; ++a)
      rest[3 * v + static_cast<std::size_t>(a)] = static_cast<float>(face().mesh->positions()[v][a]);
  }
  std::vector<std::vector<float>> dense(face().pose.size(), std::vector<float>(n, 0.0F));
  for (std::size_t s = 0; s < dense.size(); ++s) {
    const auto& shape = face().shapes->shapes()[s];
    for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
      for (int a = 0; a < 3; ++a) dense[s][3 * shape.vertices[i] + static_cast<std::size_t>(a)] = shape.deltas[i][a];
    }
  }
  const rig::Pose pose = pose_number(1);
  std::vector<float> out(n);
  for (auto _ : state) {
    out = rest;
    for (std::size_t s = 0; s < dense.size(); ++s) {
      const auto weight = static_cast<float>(pose[s]);
      const float* delta = dense[s].data();
      for (std::size_t i = 0; i < n; ++i) out[i] += weight * delta[i];
    }
    benchmark::DoNotOptimize(out.data());
  }
}

geometry::Camera camera() { return geometry::frame_box(face().mesh->rest_box(), {1000, 1000}, 20, 5); }

std::vector<geometry::PxPoint> stroke() {
  std::vector<geometry::PxPoint> line;
  for (int i = 0; i < 500; ++i) {
    const double t = i / 499.0;
    line.push_back({360 + 250 * t, 450 + 70 * base::sin(t * 9)});
  }
  return line;
}

void project_stroke(benchmark::State& state) {
  const rig::SurfacePoser poser(face().rig);
  const geometry::TriangleBvh bvh(poser.positions(), face().mesh->triangles());
  const auto view = camera();
  const auto line = stroke();
  std::size_t points = 0;
  for (auto _ : state) points = curve::project_stroke(line, view, bvh).value().points.size();
  state.counters["points"] = static_cast<double>(points);
}

void project_stroke_embree(benchmark::State& state) {
  const rig::SurfacePoser poser(face().rig);
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, poser.positions().size()));
  for (std::size_t v = 0; v < poser.positions().size(); ++v) {
    for (int a = 0; a < 3; ++a) vertices[3 * v + static_cast<std::size_t>(a)] = poser.positions()[v][a];
  }
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, face().mesh->triangle_count()));
  for (std::size_t t = 0; t < face().mesh->triangle_count(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) indices[3 * t + k] = face().mesh->triangles()[t][k];
  }
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(scene, mesh);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene);
  const auto view = camera();
  const auto line = stroke();
  std::size_t hits = 0;
  for (auto _ : state) {
    hits = 0;
    for (const auto& px : line) {
      const auto ray = view.ray(px);
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
      RTCRayHit hit{};
      hit.ray.org_x = static_cast<float>(ray.origin.x);
      hit.ray.org_y = static_cast<float>(ray.origin.y);
      hit.ray.org_z = static_cast<float>(ray.origin.z);
      hit.ray.dir_x = static_cast<float>(ray.direction.x);
      hit.ray.dir_y = static_cast<float>(ray.direction.y);
      hit.ray.dir_z = static_cast<float>(ray.direction.z);
      hit.ray.tfar = INFINITY;
      hit.ray.mask = 0xffffffffU;
      hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene, &context, &hit);
      hits += hit.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
    }
  }
  state.counters["points"] = static_cast<double>(hits);
  rtcReleaseGeometry(mesh);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

void refit(benchmark::State& state) {
  rig::SurfacePoser poser(face().rig);
  geometry::TriangleBvh bvh(poser.positions(), face().mesh->triangles());
  poser.update(pose_number(1));
  for (auto _ : state) bvh.refit(poser.positions());
}

/// From the bytes of the file to a model that can be drawn on and posed: mesh, rig, whole surface, BVH.
void load_everything(benchmark::State& state) {
  file();
  for (auto _ : state) {
    const auto model = io::read_model(file(), "ict_face.glb").value();
    const rig::SurfacePoser poser(model.rig);
    const geometry::TriangleBvh bvh(poser.positions(), model.mesh->triangles());
    benchmark::DoNotOptimize(bvh.memory());
  }
}

BENCHMARK(pose_surface)->Unit(benchmark::kMicrosecond);
BENCHMARK(pose_dense_loop)->Unit(benchmark::kMicrosecond);
BENCHMARK(project_stroke)->Unit(benchmark::kMicrosecond);
BENCHMARK(project_stroke_embree)->Unit(benchmark::kMicrosecond);
BENCHMARK(refit)->Unit(benchmark::kMicrosecond);
BENCHMARK(load_everything)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  if (!penpose::tests::has_shared()) {
    std::puts("the shared models are not here: nothing to measure");
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
