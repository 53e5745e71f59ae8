#include "tests/sketches/sketch_cases.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/head/head.h"
#include "core/io/model/read_model.h"
#include "tests/sketches/other_meshes.h"
#include "tests/support/models/articulation_models.h"
#include "tests/support/models/test_rigs.h"
#include "tests/support/shared_data.h"

namespace penpose::sketches {
namespace {

using Line = std::vector<PxPoint>;

constexpr double k_pi = 3.14159265358979323846;

/// How a feature moves at full strength: px along, px down, turned (degrees) about its first end, bowed (px).
struct Change {
  double right = 0, down = 0, turn = 0, bow = 0;
};

struct Strength {
  const char* name;
  double factor;
};
constexpr Strength k_strengths[] = {{"weak", 0.4}, {"usual", 1.0}, {"strong", 1.6}};

/// A mesh as it is drawn on: a view of it, and lines on it in px.
struct Stage {
  std::string name;
  std::shared_ptr<const Canvas> canvas;
  geometry::Viewport viewport{1000, 1000};

  [[nodiscard]] geometry::Camera camera(double yaw, double pitch = 0) const {
    geometry::Box box;
    for (const ModelPoint& p : canvas->positions()) box.add(p);
    return geometry::frame_box(box, viewport, yaw, pitch);
  }
};

Line seen(const geometry::Camera& camera, const std::vector<ModelPoint>& points) {
  Line line;
  for (const ModelPoint& p : points) line.push_back(*camera.project(p));
  return line;
}

/// The outline of all that lies within a radius of a line, as a lasso drawn by hand would run: the hull of the circles
/// about the places of the line, taken piece by piece along it.
Line around(const Line& line, double radius) {
  const auto offset = [&](std::size_t i, double side) {
    const PxPoint& a = line[i == 0 ? 0 : i - 1];
    const PxPoint& b = line[i + 1 == line.size() ? i : i + 1];
    const double length = std::max(1e-9, geometry::distance(a, b));
    return line[i] + PxPoint{-(b.y - a.y), b.x - a.x} * (side * radius / length);
  };
  const auto cap = [&](std::size_t i, double side, Line& out) {
    const PxPoint from = offset(i, side) - line[i];
    for (int k = 0; k <= 12; ++k) {
      const double angle = -k_pi * k / 12;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      out.push_back(line[i] + PxPoint{from.x * c - from.y * s, from.x * s + from.y * c});
    }
  };
  Line out;
  for (std::size_t i = 0; i < line.size(); ++i) out.push_back(offset(i, 1));
  cap(line.size() - 1, 1, out);
  for (std::size_t i = line.size(); i-- > 0;) out.push_back(offset(i, -1));
  cap(0, -1, out);
  return out;
}

Line changed(const Line& line, const Change& change, double k) {
  Line out;
  const double angle = change.turn * k * k_pi / 180;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(line.size() - 1);
    const PxPoint p = line[i] - line.front();
    const PxPoint turned{p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
    out.push_back(line.front() + turned + PxPoint{change.right * k, (change.down + change.bow * 4 * t * (1 - t)) * k});
  }
  return out;
}

/// A limb that curls: its direction turns evenly by `degrees` from its first end to its last, its length stays.
Line curled(const Line& line, double degrees) {
  Line out{line.front()};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double angle = degrees * k_pi / 180 * static_cast<double>(i + 1) / static_cast<double>(line.size() - 1);
    const PxPoint p = line[i + 1] - line[i];
    out.push_back(out.back() + PxPoint{p.x * std::cos(angle) - p.y * std::sin(angle),
                                       p.x * std::sin(angle) + p.y * std::cos(angle)});
  }
  return out;
}

struct Feature {
  const char* name;
  double yaw = 0;
  Line line;
  double specific = 20;  ///< px about the line
  double general = 100;
  std::function<Line(const Line&, double)> target;
  bool drawn = true;
};

void add(std::vector<SketchCase>& cases, const Stage& stage, const Feature& feature) {
  for (const Strength& strength : k_strengths) {
    Sketch sketch;
    sketch.name = feature.name;
    sketch.viewport = stage.viewport;
    sketch.camera = stage.camera(feature.yaw).pose();
    sketch.general = around(feature.line, feature.general);
    sketch.specific = around(feature.line, feature.specific);
    if (feature.drawn) sketch.reference = feature.line;
    sketch.target = feature.target(feature.line, strength.factor);
    cases.push_back({stage.name, feature.name, strength.name, stage.canvas, std::move(sketch)});
  }
}

std::function<Line(const Line&, double)> moves(Change change) {
  return [change](const Line& line, double k) { return changed(line, change, k); };
}
std::function<Line(const Line&, double)> curls(double degrees) {
  return [degrees](const Line& line, double k) { return curled(line, degrees * k); };
}

Line part(const Line& line, double from, double to) {
  Line out;
  const double last = static_cast<double>(line.size() - 1);
  for (int i = 0; i <= 24; ++i) {
    const double at = (from + (to - from) * i / 24) * last;
    const auto k = std::min(line.size() - 2, static_cast<std::size_t>(at));
    out.push_back(line[k] + (line[k + 1] - line[k]) * (at - static_cast<double>(k)));
  }
  return out;
}

Line straight(PxPoint a, PxPoint b) { return part({a, b}, 0, 1); }

using Curves = std::map<std::string, std::vector<ModelPoint>>;

void add_head(std::vector<SketchCase>& cases, const Stage& stage, const Curves& curves) {
  const auto front = stage.camera(0);
  const auto of = [&](const char* name) {
    Line line = seen(front, curves.at(name));
    if (line.front().x > line.back().x) std::reverse(line.begin(), line.end());
    return line;
  };
  const Line lip = of("lip_upper_inner");
  const Line lower = of("lip_lower_inner");
  const Line brow = of("brow_L");
  const Line lid = of("eyelid_upper_L");
  const double m = geometry::distance(lip.front(), lip.back());  // the mouth's width is the unit
  const PxPoint corner = lip.back();
  const PxPoint nose = seen(front, {curves.at("nose_bridge").back()})[0];
  add(cases, stage,
      {"mouth corner", 0, part(lip, 0.6, 1), 0.16 * m, 0.62 * m, moves({0.10 * m, -0.12 * m, -14, 0}), true});
  add(cases, stage,
      {"corner, inferred", 0, part(lip, 0.6, 1), 0.16 * m, 0.62 * m, moves({0.10 * m, -0.14 * m}), false});
  const Line chin = straight(lower.front() + PxPoint{0.1 * m, 0.5 * m}, lower.back() + PxPoint{-0.1 * m, 0.5 * m});
  add(cases, stage, {"jaw", 0, chin, 0.35 * m, 1.3 * m, moves({0, 0.28 * m, 0, 0.1 * m}), true});
  add(cases, stage, {"lower lip", 0, part(lower, 0.1, 0.9), 0.1 * m, 0.6 * m, moves({0, 0.05 * m, 0, 0.12 * m}), true});
  add(cases, stage, {"upper lip", 0, part(lip, 0.1, 0.9), 0.1 * m, 0.6 * m, moves({0, -0.04 * m, 0, -0.1 * m}), true});
  add(cases, stage, {"brow", 0, brow, 0.13 * m, 0.75 * m, moves({0, -0.13 * m, 0, -0.12 * m}), true});
  add(cases, stage, {"brow, inferred", 0, brow, 0.13 * m, 0.75 * m, moves({0, -0.1 * m, -12, 0}), false});
  add(cases, stage, {"lid", 0, part(lid, 0.05, 0.95), 0.05 * m, 0.32 * m, moves({0, 0.02 * m, 0, 0.09 * m}), true});
  const PxPoint cheek{0.5 * (corner.x + brow.back().x), nose.y + 0.1 * m};
  add(cases, stage,
      {"cheek", 0, straight(cheek, cheek + PxPoint{0.5 * m, -0.12 * m}), 0.18 * m, 0.8 * m,
       moves({0.08 * m, -0.16 * m, -12, -0.05 * m}), true});
  add(cases, stage,
      {"nose", 0, straight(nose + PxPoint{-0.25 * m, 0.12 * m}, nose + PxPoint{0.25 * m, 0.12 * m}), 0.12 * m, 0.6 * m,
       moves({0.02 * m, -0.14 * m, 12, 0}), true});
  // The ear from its side: what reaches farthest sideways between nose and brow.
  const ModelPoint top = curves.at("brow_L").front();
  const ModelPoint low = curves.at("nose_bridge").back();
  ModelPoint rim{0};
  for (const ModelPoint& p : stage.canvas->positions()) {
    if (p.y < top.y && p.y > low.y - 0.3 * (top.y - low.y) && p.x > rim.x) rim = p;
  }
  const PxPoint ear = seen(stage.camera(90), {rim})[0];
  add(cases, stage,
      {"ear", 90, straight(ear + PxPoint{0, 0.45 * m}, ear + PxPoint{0.05 * m, -0.35 * m}), 0.3 * m, 0.75 * m,
       moves({0.05 * m, 0, 16, 0}), true});
}

Stage stage_of(const char* name, const char* file) {
  const auto bytes = tests::read_file(tests::shared_dir() / "meshes" / file);
  const document::Model model = io::read_model(bytes, file).value();
  return {name, document::make_canvas(model).value()};
}

Curves landmarks(const Stage& stage, const char* file) {
  const auto bytes = tests::read_file(tests::shared_dir() / "meshes" / file);
  const auto json = nlohmann::json::parse(bytes.begin(), bytes.end());
  Curves curves;
  for (const auto& [name, curve] : json["curves"].items()) {
    for (const auto& v : curve["vertices"]) curves[name].push_back(stage.canvas->positions()[v.get<std::size_t>()]);
  }
  return curves;
}

void add_elephant(std::vector<SketchCase>& cases) {
  const Stage stage = stage_of("elephant", "elephant.obj");
  const auto front = stage.camera(0);
  const auto line = [&](std::vector<ModelPoint> points) { return part(seen(front, points), 0, 1); };
  const double u = 0.1 * geometry::distance(seen(front, {{0, -0.5, 0}})[0], seen(front, {{0, 0.5, 0}})[0]);
  const Line trunk = line({{0.2, 0.2, 0.15}, {0.17, 0.3, 0.18}, {0.15, 0.39, 0.18}, {0.19, 0.47, 0.1}});
  add(cases, stage, {"trunk", 0, trunk, 0.6 * u, 0.95 * u, curls(60), true});
  add(cases, stage, {"trunk, inferred", 0, trunk, 0.6 * u, 0.95 * u, curls(-60), false});
  const Line ear = line({{0.15, 0.05, 0.2}, {0.24, -0.15, 0.2}});
  add(cases, stage, {"ear", 0, part(ear, 0.3, 1), 0.5 * u, 1.5 * u, curls(40), true});
  const Line leg = line({{0.13, -0.3, 0.0}, {0.13, -0.47, 0.0}});
  add(cases, stage, {"leg", 0, leg, 0.7 * u, 1.2 * u, curls(-35), true});
  const Line hind = line({{-0.12, -0.33, 0}, {-0.12, -0.47, 0}});
  add(cases, stage, {"hind leg", 0, hind, 0.8 * u, 1.3 * u, moves({0.4 * u, -0.1 * u, 10, 0}), true});
}

/// A beast: a ball of a head with a muzzle, two ears that stand off and a horn, in one grid.
Stage beast(double ears = 38, double muzzle = 0.9, double aside = 0) {
  constexpr std::uint32_t k_rows = 90;
  constexpr std::uint32_t k_columns = 140;
  const auto bump = [](const ModelPoint& d, ModelPoint toward, double sharp) {
    toward = geometry::normalized(toward);
    const double c = d.x * toward.x + d.y * toward.y + d.z * toward.z;
    return std::exp(sharp * (c - 1));
  };
  mesh::MeshSource source;
  tests::add_grid(source, "beast", k_rows, k_columns, true, [&](std::uint32_t r, std::uint32_t c) {
    const double e = k_pi * ((r + 0.3) / (k_rows - 0.4) - 0.5);
    const double a = 2 * k_pi * c / k_columns;
    const ModelPoint d{std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
    const double size = 1 + muzzle * bump(d, {aside, -0.15, 1}, 9) + 1.1 * bump(d, {0.9, 0.6, -0.1}, ears) +
                        1.1 * bump(d, {-0.9, 0.6, -0.1}, ears) + 0.05 * bump(d, {0.35, 0.3, 1}, 60);
    return d * size;
  });
  return {ears == 38 ? "beast" : "other beast", tests::canvas_of(std::move(source))};
}

void add_beast(std::vector<SketchCase>& cases, const Stage& stage) {
  const auto front = stage.camera(0);
  const auto from_side = stage.camera(90);
  const Line muzzle = seen(front, {{-0.3, -0.5, 1.6}, {0.3, -0.5, 1.6}});
  const double u = geometry::distance(muzzle[0], muzzle[1]);
  const Line ear = seen(front, {{0.85, 0.6, -0.1}, {1.62, 1.1, -0.18}});
  add(cases, stage,
      {"mouth corner", 0, straight(muzzle[0] + PxPoint{0.6 * u, 0}, muzzle[1]), 0.2 * u, 0.9 * u,
       moves({0.15 * u, -0.2 * u, -15, 0}), true});
  add(cases, stage,
      {"jaw", 0, straight(muzzle[0], muzzle[1]), 0.25 * u, 1.1 * u, moves({0, 0.35 * u, 0, 0.1 * u}), true});
  add(cases, stage, {"ear", 0, straight(ear[0], ear[1]), 0.6 * u, 1.1 * u, curls(45), true});
  add(cases, stage, {"ear, inferred", 0, straight(ear[0], ear[1]), 0.6 * u, 1.1 * u, curls(45), false});
  const Line ear_side = seen(from_side, {{1.0, 0.65, -0.1}, {1.62, 1.1, -0.18}});
  add(cases, stage,
      {"ear from its side", 90, straight(ear_side[0], ear_side[1]), 0.4 * u, 0.9 * u, moves({0.2 * u, 0, 15, 0}),
       true});
  const Line brow = seen(front, {{0.15, 0.45, 0.9}, {0.6, 0.4, 0.75}});
  add(cases, stage,
      {"brow", 0, straight(brow[0], brow[1]), 0.15 * u, 0.9 * u, moves({0, -0.2 * u, -8, -0.1 * u}), true});
  const Line snout = seen(from_side, {{0, -0.1, 1.0}, {0, -0.25, 1.88}});
  add(cases, stage, {"snout", 90, straight(snout[0], snout[1]), 0.5 * u, 1.1 * u, curls(30), true});
}

}  // namespace

std::vector<SketchCase> sketch_cases() {
  std::vector<SketchCase> cases;
  const document::Model head = head::make_head();
  Stage built_in{"built-in", document::make_canvas(head).value()};
  Curves curves;
  for (const auto& curve : head.curves) {
    for (const auto& p : curve.points) {
      const auto& triangle = head.mesh->triangles()[p.triangle];
      ModelPoint at{0};
      for (std::size_t i = 0; i < 3; ++i) at += head.mesh->positions()[triangle[i]] * p.barycentric[i];
      curves[curve.name].push_back(at);
    }
  }
  add_head(cases, built_in, curves);
  add_beast(cases, beast());
  if (!tests::has_shared()) return cases;
  for (const char* name : {"ict_face", "ict_face_narrow"}) {
    const Stage stage = stage_of(name, (std::string(name) + ".glb").c_str());
    add_head(cases, stage, landmarks(stage, "ict_face_landmarks.json"));
  }
  const Stage other = stage_of("carry_head", "carry_head.glb");
  add_head(cases, other, landmarks(other, "carry_head_landmarks.json"));
  add_elephant(cases);
  return cases;
}

std::vector<SketchCase> varied_sketch_cases(std::uint64_t seed) {
  std::vector<SketchCase> cases = sketch_cases();
  for (SketchCase& one : other_sketch_cases()) cases.push_back(std::move(one));
  tests::Random random(seed);
  for (SketchCase& one : cases) {
    Sketch& sketch = one.sketch;
    PxPoint middle{0, 0};
    for (const PxPoint& p : sketch.specific) middle = middle + p * (1.0 / static_cast<double>(sketch.specific.size()));
    const double general = random(0.75, 1.2), specific = random(0.7, 1.3), far = random(0.6, 1.25);
    const double turn = random(-0.25, 0.25), wave = random(0, 0.06);
    const PxPoint aside{random(-6, 6), random(-6, 6)};
    const double phase = random(0, 2 * k_pi);
    const auto widen = [&](Line& lasso, double factor) {
      for (PxPoint& p : lasso) {
        const PxPoint from = p - middle;
        p = middle + from * (factor * (1 + wave * std::sin(3 * std::atan2(from.y, from.x) + phase)));
      }
    };
    widen(sketch.general, general);
    widen(sketch.specific, specific);
    const Line was = sketch.reference;
    for (PxPoint& p : sketch.reference) p = p + aside + PxPoint{random(-1, 1), random(-1, 1)};
    for (std::size_t i = 0; i < sketch.target.size(); ++i) {
      PxPoint& p = sketch.target[i];
      if (was.empty()) {
        p = p + aside;
        continue;
      }
      const PxPoint from = was[std::min(i, was.size() - 1)], way = p - from;
      p = from + aside +
          PxPoint{way.x * std::cos(turn) - way.y * std::sin(turn), way.x * std::sin(turn) + way.y * std::cos(turn)} *
              far;
    }
  }
  return cases;
}

std::vector<SketchCase> other_sketch_cases() {
  std::vector<SketchCase> cases;
  add_beast(cases, beast(24, 1.2, 0.25));
  if (!tests::has_shared()) return cases;
  const Stage face = stage_of("coarse face", "ict_face.glb");
  const Curves of_face = landmarks(face, "ict_face_landmarks.json");
  add_head(cases, {"coarse face", coarser(*face.canvas, 0.3)}, of_face);
  const Stage head = stage_of("warped head", "carry_head.glb");
  Curves of_head = landmarks(head, "carry_head_landmarks.json");
  const Warp warp(*head.canvas);
  for (auto& [name, points] : of_head) {
    for (ModelPoint& p : points) p = warp(p);
  }
  add_head(cases, {"warped head", warped(*head.canvas, warp)}, of_head);
  add_head(cases, {"coarse warped", coarser(*warped(*head.canvas, warp), 0.15)}, of_head);
  return cases;
}

}  // namespace penpose::sketches
