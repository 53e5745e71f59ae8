#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <glm/vec3.hpp>

#include "core/articulation/motion/slide.h"
#include "core/articulation/region/canvas.h"
#include "core/articulation/sketched_deformers.h"
#include "core/character/demo_head.h"
#include "core/head/head.h"
#include "core/io/model/read_model.h"
#include "core/posing/solve.h"
#include "core/rig/character_rig.h"
#include "replay/session/session_player.h"
#include "tests/support/shared_data.h"
#include "ui/demo/embedded_files.h"

namespace penpose {
namespace {

using articulation::Canvas;
using articulation::Mode;
using articulation::Sketch;
using articulation::SketchedDeformers;
using geometry::ModelPoint;
using geometry::PxPoint;

constexpr std::size_t k_head_vertices = 7500;
constexpr std::size_t k_face_vertices = 26719;

/// A smooth head-sized surface of about that many vertices, evenly spread (a Fibonacci lattice, Delaunay is not needed:
/// a grid with its poles aside).
std::shared_ptr<const mesh::TriangleMesh> round_mesh(std::size_t vertices) {
  const auto rows = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(vertices) / 1.6));
  const std::uint32_t columns = static_cast<std::uint32_t>(vertices) / rows;
  mesh::MeshSource source;
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const double elevation = 3.14 * (r + 0.5) / rows - 1.57;
      const double azimuth = 6.283185307 * c / columns;
      source.positions.push_back(
          {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)});
    }
  }
  for (std::uint32_t r = 0; r + 1 < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t a = r * columns + c;
      const std::uint32_t b = r * columns + (c + 1) % columns;
      source.triangles.push_back({a, b, b + columns});
      source.triangles.push_back({a, b + columns, a + columns});
    }
  }
  return mesh::TriangleMesh::build(std::move(source)).value();
}

std::vector<PxPoint> ring(PxPoint middle, double radius) {
  std::vector<PxPoint> points;
  for (int i = 0; i < 80; ++i) {
    points.push_back(middle + PxPoint{std::cos(i * 0.0785398), 0.7 * std::sin(i * 0.0785398)} * radius);
  }
  return points;
}

std::vector<PxPoint> line(PxPoint from, PxPoint to, double bow) {
  std::vector<PxPoint> points;
  for (int i = 0; i <= 60; ++i) {
    const double t = i / 60.0;
    points.push_back(from + (to - from) * t + PxPoint{0, bow * 4 * t * (1 - t)});
  }
  return points;
}

enum class Kind : std::int64_t { mixed, turning };

/// Fifteen controls over a face, overlapping as those of lids, brows, cheeks and lips do.
std::vector<Sketch> fifteen(Kind kind) {
  std::vector<Sketch> sketches;
  for (int i = 0; i < 15; ++i) {
    Sketch sketch;
    sketch.name = "control" + std::to_string(i);
    sketch.viewport = {1000, 1000};
    sketch.camera = {{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 24};
    const PxPoint middle{300.0 + 100 * (i % 5), 320.0 + 170 * (i / 5)};
    sketch.general = ring(middle, 130);
    sketch.specific = ring(middle, 70);
    const PxPoint reach{60, 0};
    const bool turns = kind == Kind::turning || i % 3 == 0;
    if (i % 2 == 0) sketch.reference = line(middle - reach, middle + reach, -20);
    sketch.target = turns ? line(middle - reach + PxPoint{0, 5}, middle + reach - PxPoint{10, 50}, 25)
                          : line(middle - reach, middle + reach, 25);
    sketch.mode = turns ? Mode::rotate : Mode::translate;
    if (!turns && i % 3 == 1) sketch.surface = articulation::Sphere{{0, 0, 0}, 0.9};
    sketches.push_back(std::move(sketch));
  }
  return sketches;
}

std::shared_ptr<const rig::CharacterRig> rig_of(std::size_t vertices, Kind kind) {
  const auto mesh = round_mesh(vertices);
  const auto canvas = Canvas::make(mesh, nullptr).value();
  const auto deformers = SketchedDeformers::build(fifteen(kind), *canvas).value();
  return rig::CharacterRig::make(mesh, {deformers}, nullptr).value();
}

/// Builds a deformer repeatedly; with the second argument, of half the face.
void measure_building(benchmark::State& state, Sketch sketch, const Canvas& canvas) {
  if (state.range(1) != 0) {
    sketch.general = ring({500, 500}, 420);
    sketch.specific = ring({500, 500}, 300);
  }
  std::size_t moved = 0;
  for (auto _ : state) {
    const auto deformer = articulation::build_deformer(sketch, canvas).value();
    moved = deformer->vertices().size();
    benchmark::DoNotOptimize(moved);
  }
  state.counters["vertices"] = static_cast<double>(moved);
}

void build_deformer(benchmark::State& state) {
  const auto canvas = Canvas::make(round_mesh(k_face_vertices), nullptr).value();
  const Sketch sketch = fifteen(Kind::turning)[static_cast<std::size_t>(state.range(0))];
  measure_building(state, sketch, *canvas);
}
BENCHMARK(build_deformer)->Args({6, 0})->Args({7, 0})->Args({6, 1})->Args({7, 1})->Unit(benchmark::kMillisecond);

void evaluate_all(benchmark::State& state) {
  const auto rig = rig_of(k_head_vertices, static_cast<Kind>(state.range(0)));
  rig::Pose pose(15, 0.5);
  std::vector<ModelPoint> positions(rig->vertex_count());
  for (auto _ : state) {
    for (double& x : pose) x = x == 0.5 ? 0.6 : 0.5;
    rig->evaluate(pose, positions);
    benchmark::DoNotOptimize(positions.data());
  }
}
BENCHMARK(evaluate_all)->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

/// Two curves of 32 vertices across the face.
std::vector<std::vector<std::uint32_t>> two_curves(const rig::CharacterRig& rig) {
  std::vector<std::vector<std::uint32_t>> curves;
  for (const double y : {0.2, -0.15}) {
    std::vector<std::uint32_t> curve;
    for (int i = 0; i < 32; ++i) {
      const double x = -0.55 + 1.1 * i / 31;
      const ModelPoint wanted{x, y, std::sqrt(1 - x * x - y * y)};
      std::uint32_t nearest = 0;
      for (std::uint32_t v = 0; v < rig.vertex_count(); ++v) {
        if (geometry::distance(rig.mesh().positions()[v], wanted) <
            geometry::distance(rig.mesh().positions()[nearest], wanted)) {
          nearest = v;
        }
      }
      curve.push_back(nearest);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

void evaluate_curves(benchmark::State& state) {
  const auto rig = rig_of(k_head_vertices, static_cast<Kind>(state.range(0)));
  std::vector<std::uint32_t> vertices;
  for (const auto& curve : two_curves(*rig)) vertices.insert(vertices.end(), curve.begin(), curve.end());
  const auto bound = rig->bind(vertices);
  std::vector<ModelPoint> positions(vertices.size());
  rig::Pose pose(15, 0.5);
  for (auto _ : state) {
    for (double& x : pose) x = x == 0.5 ? 0.6 : 0.5;
    bound->evaluate(pose, positions);
    benchmark::DoNotOptimize(positions.data());
  }
}
BENCHMARK(evaluate_curves)->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

void solve_two_curves(benchmark::State& state) {
  const auto rig = rig_of(k_head_vertices, static_cast<Kind>(state.range(0)));
  rig::Pose answer(15);
  for (std::size_t i = 0; i < 15; ++i) answer[i] = 0.2 + 0.05 * static_cast<double>(i % 9);
  std::vector<ModelPoint> posed(rig->vertex_count());
  rig->evaluate(answer, posed);
  posing::PoseProblem problem;
  for (const auto& curve : two_curves(*rig)) {
    posing::CurvePair pair;
    for (const std::uint32_t v : curve) {
      pair.reference.push_back(posing::at_vertex(v));
      // Off by what a hand is off, so that no pose fits exactly.
      pair.target.push_back(posed[v] +
                            ModelPoint{0, 0.004 * std::sin(0.7 * static_cast<double>(pair.target.size())), 0});
    }
    problem.pairs.push_back(std::move(pair));
  }
  for (std::size_t i = 0; i < 15; ++i) problem.free.push_back(i);
  problem.start = rig::rest_pose(*rig);
  posing::SolveWorkspace work;
  posing::Solution solution;
  for (auto _ : state) solution = posing::solve(*rig, problem, {}, work).value();
  state.counters["energy_start"] = solution.energy_start;
  state.counters["energy"] = solution.energy;
  state.counters["evaluations"] = static_cast<double>(solution.evaluations);
  state.counters["variables"] = static_cast<double>(solution.variables);
}
BENCHMARK(solve_two_curves)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// The same on what the issue names: the built-in head with its fifteen deformers, and the face of 26,719 vertices.

const document::Model& demo_head() {
  static const document::Model model = character::make_demo_head().value();
  return model;
}

void make_built_in_head(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(head::make_head().mesh.get());
}
BENCHMARK(make_built_in_head)->Unit(benchmark::kMillisecond);

void evaluate_demo_head(benchmark::State& state) {
  const document::Model& model = demo_head();
  rig::Pose pose(model.rig->parameters().size(), 0.5);
  std::vector<ModelPoint> positions(model.mesh->vertex_count());
  for (auto _ : state) {
    for (double& x : pose) x = x == 0.5 ? 0.6 : 0.5;
    model.rig->evaluate(pose, positions);
    benchmark::DoNotOptimize(positions.data());
  }
  state.counters["deformers"] = static_cast<double>(pose.size());
  state.counters["vertices"] = static_cast<double>(positions.size());
}
BENCHMARK(evaluate_demo_head)->Unit(benchmark::kMicrosecond);

/// What the demo's session asks of the solver at an expression, from rest, all fifteen deformers free: two of its
/// curves, or all.
void solve_demo_head(benchmark::State& state) {
  static const std::vector<document::Document> documents = [] {
    std::vector<document::Document> all;
    replay::PlayerOptions options;
    options.open = [](const std::string&) {
      return base::Result<document::Document>(document::make_document(head::make_head()));
    };
    options.stop_when = [&all](const replay::Session& session) {
      const document::Document& document = session.editor().document();
      const auto& keys = document.timeline->keys;
      const bool named = !keys.empty() && !keys.back().name.empty() && keys.back().time_s == document.time_s;
      if (named && (all.empty() || all.back().timeline != document.timeline)) all.push_back(document);
      return false;
    };
    static_cast<void>(replay::play_session(replay::read_from(base::as_bytes(demo::embedded_session())), options));
    return all;
  }();
  const document::Document& document = documents[static_cast<std::size_t>(state.range(0))];
  posing::PoseProblem problem = document::pose_problem(document);
  problem.start = rig::rest_pose(*document.model->rig);
  problem.pairs.resize(std::min<std::size_t>(problem.pairs.size(), static_cast<std::size_t>(state.range(1))));
  posing::SolveWorkspace work;
  posing::Solution solution;
  for (auto _ : state) solution = posing::solve(*document.model->rig, problem, {}, work).value();
  state.SetLabel(document.timeline->keys.back().name);
  state.counters["curves"] = static_cast<double>(problem.pairs.size());
  state.counters["evaluations"] = static_cast<double>(solution.evaluations);
  state.counters["variables"] = static_cast<double>(solution.variables);
}
BENCHMARK(solve_demo_head)->ArgsProduct({benchmark::CreateDenseRange(0, 7, 1), {2, 99}})->Unit(benchmark::kMillisecond);

void build_on_face(benchmark::State& state, Mode mode, bool paper) {
  const auto bytes = tests::read_file(tests::shared_dir() / "meshes" / "ict_face.glb");
  if (bytes.empty()) return state.SkipWithError("the face is not there");
  const document::Model face = io::read_model(bytes, "ict_face.glb").value();
  const auto canvas = document::make_canvas(face).value();
  geometry::Box box;
  for (const ModelPoint& p : canvas->positions()) box.add(p);
  Sketch sketch = fifteen(Kind::turning)[static_cast<std::size_t>(state.range(0))];
  sketch.mode = mode;
  sketch.paper = paper;
  sketch.camera.look_at = box.center();
  sketch.camera.eye = box.center() + ModelPoint{0, 0, 2.4 * box.diagonal()};
  measure_building(state, sketch, *canvas);
}
BENCHMARK_CAPTURE(build_on_face, turned, Mode::rotate, true)
    ->ArgsProduct({{6, 7}, {0, 1}})
    ->Unit(benchmark::kMillisecond);
// As the app makes a control: both ways of going there are tried and measured, and what tears is given way to.
BENCHMARK_CAPTURE(build_on_face, chosen, Mode::automatic, false)
    ->ArgsProduct({{6, 7}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace penpose
