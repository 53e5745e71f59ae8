// write_blender_samples FOLDER [FILE.glb ...]: animated files, the named ones too, and where their vertices should be
// at twenty times.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/document/commands/apply.h"
#include "core/document/time/animation_building.h"
#include "core/document/time/animation_sampling.h"
#include "core/io/model/read_model.h"
#include "core/io/model/write_model.h"
#include "core/io/project/write_document.h"
#include "tests/support/models/articulation_models.h"
#include "tests/support/models/model_samples.h"
#include "tests/support/models/rendered_track.h"
#include "tests/support/shared_data.h"
#include "ui/demo/run_demo.h"

namespace {

using namespace penpose;

/// A clip in which every weight goes its own way.
document::Model animated(document::Model model) {
  std::vector<double> times;
  std::vector<rig::Pose> poses;
  tests::Shaker random(7);
  const std::size_t weights = document::weight_count(model);
  for (int f = 0; f <= 60; ++f) {
    times.push_back(f / 30.0);
    rig::Pose pose = rig::rest_pose(*model.rig);
    for (std::size_t i = 0; i < weights; ++i) {
      const rig::Parameter& p = model.rig->parameters()[i];
      const double middle = 0.5 * (p.minimum + p.maximum);
      pose[i] = middle + 0.4 * (p.maximum - p.minimum) *
                             std::sin(0.1 * f * (1.0 + 0.1 * static_cast<double>(i % 7)) + static_cast<double>(i));
    }
    poses.push_back(std::move(pose));
  }
  model.animations = {document::make_animation(model, "clip", times, poses)};
  model.pose = rig::rest_pose(*model.rig);
  std::vector<document::Placement> placements;
  for (int f = 0; f <= 60; ++f) {
    const double a = 0.3 * std::sin(0.1 * f);
    placements.push_back({glm::dquat(std::cos(a / 2), 0, std::sin(a / 2), 0), {0.01 * f, 0, 0}, 1 + 0.002 * f});
  }
  if (model.skeleton) return model;
  return document::with_placements(std::move(model), 0, document::rest_world_box(model).center(), times, placements)
      .value();
}

/// Writes the file and where its vertices should be: at times of all kinds, or at keys.
bool write_file(const std::filesystem::path& folder, const std::string& name,
                const base::Result<std::vector<std::uint8_t>>& bytes, bool at_keys) {
  if (!bytes) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), bytes.error().line().c_str());
    return false;
  }
  std::ofstream(folder / (name + ".glb"), std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
  const auto read = io::read_model(*bytes, name + ".glb").value();
  nlohmann::json wanted = {{"size", document::rest_world_box(read).diagonal()}, {"times", nlohmann::json::array()}};
  wanted["shape_keys"] = nlohmann::json::array();
  for (std::size_t i = 0; i < document::weight_count(read); ++i)
    wanted["shape_keys"].push_back(read.rig->parameters()[i].name);
  for (const mesh::Part& part : read.mesh->parts())
    wanted["parts"].push_back({{"name", part.name}, {"positions", nlohmann::json::array()}});
  tests::Shaker random(3);
  const double duration = document::duration_s(read.animations[0]);
  for (int k = 0; k < 20; ++k) {
    double time = duration * (0.5 + 0.5 * random());
    if (at_keys) time = std::round(time * 30) / 30;
    wanted["times"].push_back(time);
    const auto moment = document::model_at(read, document::sample(read, read.animations[0], time)).value();
    const auto positions = document::posed_positions(moment);
    for (std::size_t p = 0; p < read.mesh->parts().size(); ++p) {
      const mesh::Part& part = read.mesh->parts()[p];
      nlohmann::json list = nlohmann::json::array();
      for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
        list.push_back({positions[v].x, positions[v].y, positions[v].z});
      }
      wanted["parts"][p]["positions"].push_back(std::move(list));
    }
  }
  std::ofstream(folder / (name + ".json")) << wanted.dump();
  return true;
}

bool write(const std::filesystem::path& folder, const std::string& name, const document::Model& model) {
  // Deformers between amounts are as exact as they are baked: finer than the comparison here. They mix exactly at keys
  // only.
  return write_file(folder, name, io::write_glb(model, {5e-6}), model.deformers != nullptr);
}

document::Model trunk() {
  const tests::Trunk trunk = tests::make_trunk();
  mesh::MeshSource source;
  source.positions.assign(trunk.canvas->positions().begin(), trunk.canvas->positions().end());
  source.triangles.assign(trunk.canvas->mesh().triangles().begin(), trunk.canvas->mesh().triangles().end());
  source.parts = {{.name = "trunk",
                   .first_vertex = 0,
                   .vertex_count = static_cast<std::uint32_t>(source.positions.size()),
                   .first_triangle = 0,
                   .triangle_count = static_cast<std::uint32_t>(source.triangles.size())}};
  auto model = document::make_model(mesh::TriangleMesh::build(std::move(source)).value(), nullptr, nullptr).value();
  const auto deformer = articulation::build_deformer(trunk.curl(), *document::make_canvas(model).value()).value();
  return document::with_deformers(std::move(model), articulation::SketchedDeformers::make({deformer}).value()).value();
}

/// The head with keys of single controls, of all kinds beside each other, that were bent, broken down and trimmed.
document::Document keyed_head(document::Model model) {
  using namespace document;  // NOLINT(google-build-using-namespace): every line names a command
  tests::Shaker random(11);
  Document head = make_document(std::move(model));
  const auto parameters = head.model->rig->parameters();
  const std::size_t weights = weight_count(*head.model);
  ApplyWorkspace work;
  const auto does = [&](const Command& command) { head = apply(head, command, work).value(); };
  for (const double time_s : {0.0, 0.25, 0.75, 1.25, 2.0}) {
    SetParameters pose;
    SetKey key{time_s, ""};
    SetKeyKind kinds;
    for (std::size_t i = 0; i < weights; ++i) {
      if (time_s > 0 && time_s < 2 && random() > 0.3) continue;
      const rig::Parameter& p = parameters[i];
      pose.values.push_back({p.name, p.minimum + (0.5 + 0.5 * random()) * (p.maximum - p.minimum)});
      key.names.push_back(p.name);
    }
    does(pose);
    does(key);
    for (std::size_t k = 0; k < key.names.size(); ++k)
      does(
          SetKeyKind{{{time_s}, {key.names[k]}}, static_cast<KeyKind>((k + static_cast<std::size_t>(4 * time_s)) % 8)});
    does(SetKeySlopes{time_s, key.names.front(), 0.7, -0.4});
  }
  does(Tween{1, 1.2, {}});
  does(TrimClip{0.1, 1.9});
  return head;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::filesystem::path folder = tests::empty_folder(argv[1]);
  bool good = write(folder, "trunk", animated(trunk()));
  // The built-in head, through the whole ranges of its controls, which go below 0 and above 1.
  const auto demo = demo::run_demo().value();
  good = write(folder, "head_clip", animated(document::model_of(demo.document))) && good;
  // The demo as it is written, its timeline of smooth keys and all.
  good = write_file(folder, "demo", io::write_project(demo.document), false) && good;
  good = write_file(folder, "keyed", io::write_project(keyed_head(*demo.document.model)), false) && good;
  for (int i = 2; i < argc; ++i) {
    const std::filesystem::path file = argv[i];
    good = write_file(folder, file.stem().string(), tests::read_file(file), false) && good;
  }
  if (!tests::has_shared()) return good ? 0 : 1;
  for (const char* name : {"ict_face.glb", "ict_face_narrow.glb"}) {
    const auto file = tests::shared_dir() / "meshes" / name;
    good = write(folder, std::filesystem::path(name).stem().string(),
                 animated(io::read_model(tests::read_file(file), name).value())) &&
           good;
  }
  return good ? 0 : 1;
}
