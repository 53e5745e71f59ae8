// make_files FOLDER TAKES: files that the examples of --help name, and TAKES tracks of the built-in head in
// FOLDER/takes, each of another amplitude and pace, in which the jaw opens and lips purse.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/character/demo_head.h"
#include "core/document/commands/apply.h"
#include "core/document/history.h"
#include "core/document/time/animation_sampling.h"
#include "core/io/model/write_model.h"
#include "core/io/project/sketch_file.h"
#include "core/io/project/write_document.h"
#include "tests/support/models/articulation_models.h"

namespace {

using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file
namespace fs = std::filesystem;
using Json = nlohmann::json;

template <typename Content>
void write(const fs::path& path, const Content& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file) {
    std::cerr << path << " cannot be written\n";
    std::exit(1);
  }
}

rig::Pose posed(const document::Model& head, double jaw, double pucker) {
  rig::Pose pose = rig::rest_pose(*head.rig);
  pose[rig::find_parameter(head.rig->parameters(), "jaw").value()] = jaw;
  pose[rig::find_parameter(head.rig->parameters(), "lips_pucker").value()] = pucker;
  return pose;
}

/// What a tracker would see of one pose: the head's own curves in px.
Json seen(const document::Model& head, const rig::Pose& pose) {
  const auto camera = geometry::frame_box(document::rest_world_box(head), {640, 640}, 0);
  document::Model moment = head;
  moment.pose = pose;
  const auto positions = document::posed_positions(moment);
  Json curves;
  for (const auto& curve : head.curves) {
    if (!curve.name.starts_with("lip") && curve.name != "nose_bridge") continue;
    for (const auto& point : curve.points) {
      const auto px = camera.project(mesh::position_of(point, head.mesh->triangles(), positions)).value();
      curves[curve.name].push_back({px.x, px.y});
    }
  }
  return curves;
}

/// A drawing of the head: a path for each curve.
std::string drawing(const document::Model& head, double jaw) {
  const auto camera = geometry::frame_box(document::rest_world_box(head), {640, 640}, 0);
  document::Model moment = head;
  moment.pose = posed(head, jaw, 0);
  const auto positions = document::posed_positions(moment);
  std::string text = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 640 640' fill='none' stroke='black'>\n";
  for (const auto& curve : head.curves) {
    text += "<polyline points='";
    for (const auto& point : curve.points) {
      const auto px = camera.project(mesh::position_of(point, head.mesh->triangles(), positions)).value();
      text += std::to_string(px.x) + "," + std::to_string(px.y) + " ";
    }
    text += "'/>\n";
  }
  return text + "</svg>\n";
}

std::string take(const document::Model& head, int number, int frames) {
  Json list = Json::array();
  for (int f = 0; f < frames; ++f) {
    const double t = static_cast<double>(f) / 25;
    const double jaw = (0.2 + 0.002 * (number % 100)) * (0.5 - 0.5 * std::cos((3 + 0.05 * number) * t));
    list.push_back({{"curves", seen(head, posed(head, jaw, 0.15 * std::sin(2 * t) * std::sin(2 * t)))}});
  }
  return Json{{"fps", 25}, {"frames", list}}.dump();
}

/// One case, in which the mouth is open: what its lower lip is and where it goes.
std::string cases(const document::Model& head) {
  const auto rest = document::posed_positions(head);
  document::Model moment = head;
  moment.pose = posed(head, 0.3, 0);
  const auto open = document::posed_positions(moment);
  Json vertices = Json::array();
  Json target = Json::array();
  for (const auto& curve : head.curves) {
    if (curve.name != "lip_lower") continue;
    for (const auto& point : curve.points) {
      const auto v = head.mesh->triangles()[point.triangle][0];
      if (std::find(vertices.begin(), vertices.end(), v) != vertices.end()) continue;
      vertices.push_back(v);
      target.push_back({open[v].x, open[v].y, open[v].z});
    }
  }
  return Json{{"cases", {{{"name", "smile"}, {"references", {{{"vertices", vertices}, {"target", target}}}}}}}}.dump();
}

std::vector<std::uint8_t> keyed(const document::Model& head) {
  document::Document document = document::make_document(head);
  document::ApplyWorkspace work;
  for (int k = 0; k < 5; ++k) {
    document::SetParameters set;
    set.values.push_back({"jaw", 0.1 + 0.1 * k});
    set.values.push_back({"lips_pucker", 0.05 * k});
    document = document::apply(document, set, work).value();
    document = document::apply(document, document::SetKey{0.5 * k, "face " + std::to_string(k)}, work).value();
  }
  document = document::apply(document, document::ResetParameters{}, work).value();
  return io::write_document(document, "keyed.glb").value();
}

void write_elephant(const fs::path& folder) {
  const tests::Trunk trunk = tests::make_trunk();
  mesh::MeshSource source;
  source.positions.assign(trunk.canvas->positions().begin(), trunk.canvas->positions().end());
  source.triangles.assign(trunk.canvas->mesh().triangles().begin(), trunk.canvas->mesh().triangles().end());
  const auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  write(folder / "elephant.glb", io::write_glb(document::make_model(mesh, nullptr, nullptr).value()).value());
  io::SketchFile file;
  file.viewport = trunk.viewport;
  file.sketches = {trunk.curl()};
  write(folder / "trunk.json", io::write_sketch_file(file));
}

/// Pictures of a bright mouth on a dark face that opens: the upper edge stays, the lower edge sinks.
std::string picture(double open) {
  std::string text = "P5 64 64 255\n";
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double inside = std::clamp(y + 0.5 - 30, 0.0, 1.0) * std::clamp(34 + 12 * open - y, 0.0, 1.0);
      text += static_cast<char>(static_cast<int>(x > 16 && x < 48 ? 60 + 150 * inside : 60));
    }
  }
  return text;
}

void write_pictures(const fs::path& folder) {
  Json list = Json::array();
  for (int k = 0; k <= 10; ++k) {
    const std::string name = "labelled/" + std::to_string(k) + ".pgm";
    const double low = 34 + 1.2 * k;
    write(folder / name, picture(k / 10.0));
    list.push_back(
        {{"image", name},
         {"curves", {{"upper", {{16, 30}, {32, 30}, {48, 30}}}, {"lower", {{16, low}, {32, low}, {48, low}}}}}});
  }
  write(folder / "labels.json", Json{{"frames", list}}.dump());
  for (int f = 0; f < 4; ++f) {
    write(folder / "frames" / ("face" + std::to_string(f) + ".pgm"), picture(0.05 + 0.2 * f));
  }
}

void write_shapes(const fs::path& folder) {
  write(folder / "scan.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  write(folder / "shapes" / "lift.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n"));
}

/// Nine places of a lip whose ends go up.
std::string moved_lip() {
  std::string text = "[";
  for (int i = -4; i <= 4; ++i) text += (i > -4 ? ", " : "") + std::string("[0, ") + (i * i > 8 ? "0.1" : "0") + ", 0]";
  return text + "]";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: make_files FOLDER TAKES\n";
    return 2;
  }
  const fs::path folder(argv[1]);
  const auto head = character::make_demo_head();
  if (!head) {
    std::cerr << head.error().line() << '\n';
    return 1;
  }
  write(folder / "face.glb", io::write_document(document::make_document(*head), "face.glb").value());
  write(folder / "smile.svg", drawing(*head, 0.5));
  write(folder / "rest.svg", drawing(*head, 0));
  write(folder / "keyed.glb", keyed(*head));
  write(folder / "smile.pose.json", std::string(R"({"penpose_pose": 1, "name": "smile", "values": {"smile": 0.8}, )"
                                                R"("moves": {"lip_upper": )" +
                                                moved_lip() + "}}"));
  write(folder / "cases.json", cases(*head));
  write(folder / "track.json", take(*head, 50, 12));
  write(folder / "cues.tsv", std::string("0.00\tX\n0.50\tD\n1.00\tA\n1.10\tD\n1.50\tX\n"));
  write(folder / "words.srt", std::string("1\n00:00:00,200 --> 00:00:00,900\nhello there\n"));
  write_elephant(folder);
  write_pictures(folder);
  write_shapes(folder);
  for (int number = 0; number < std::atoi(argv[2]); ++number) {
    std::string name = std::to_string(number);
    name.insert(0, 3 - std::min<std::size_t>(3, name.size()), '0');
    write(folder / "takes" / ("take" + name + ".json"), take(*head, number, 8));
  }
  return 0;
}
