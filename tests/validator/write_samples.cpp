// write_samples FOLDER: writes the files that the validator is to see.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/document/time/animation_building.h"
#include "core/io/gltf/write/write_vrma.h"
#include "core/io/model/read_model.h"
#include "core/io/model/write_model.h"
#include "tests/support/models/figure_sample.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/models/model_samples.h"
#include "tests/support/models/packed_trunk.h"
#include "tests/support/models/sketched_models.h"
#include "tests/support/models/textured_trunk.h"
#include "tests/support/models/whole_avatar.h"
#include "tests/support/shared_data.h"

namespace {

using namespace penpose;

bool write(const std::filesystem::path& path, const document::Model& model, bool bare = false) {
  const auto bytes = io::write_glb(model, {.bare = bare});
  if (!bytes) {
    std::fprintf(stderr, "%s\n", bytes.error().line(path.string()).c_str());
    return false;
  }
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
  return file.good();
}

bool write_motion(const std::filesystem::path& path) {
  document::Model model = tests::avatar_sample(tests::turned_bones()).read().value();
  std::vector<rig::Pose> poses(2, model.pose);
  for (double& value : poses[1]) value = 0.5;
  model.animations = {document::make_animation(model, "motion", std::vector<double>{0, 1}, poses)};
  const auto written = io::write_vrma(model);
  if (!written) return false;
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(written->bytes.data()), static_cast<std::streamsize>(written->bytes.size()));
  return file.good();
}

/// A file as it was read and as it is saved with a sketched control and a pose.
bool write_drawn_on(const std::filesystem::path& folder, const std::string& name, tests::GltfSample sample) {
  const auto bytes = sample.glb();
  std::filesystem::create_directories(folder / "read");
  std::ofstream(folder / "read" / name, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  document::Model model = tests::with_curl(io::read_model(bytes, "sample.glb").value());
  for (std::size_t i = 0; i < model.pose.size(); ++i) model.pose[i] = 0.1 * static_cast<double>(1 + i % 5);
  return write(folder / name, model);
}

/// A file that was read, with another pose and an animation more.
document::Model patched(const document::Model& model) {
  const auto bytes = io::write_glb(model, {.bare = true}).value();
  document::Model read = io::read_model(bytes, "sample.glb").value();
  std::vector<rig::Pose> poses(2, read.pose);
  for (std::size_t i = 0; i < read.pose.size(); ++i) poses[1][i] = 0.25 * read.rig->parameters()[i].maximum;
  read.animations.push_back(document::make_animation(read, "more", std::vector<double>{0, 1}, poses));
  read.pose = poses[1];
  return read;
}

/// A sketched deformer that turns, baked and animated, on a head that moves.
document::Model tracked() {
  document::Model model = tests::curling_trunk();
  const std::vector<double> times{0, 0.1, 0.1, 0.3};
  const std::vector<rig::Pose> poses{{0}, {0.4}, {0.4}, {1}};
  model.animations = {document::make_animation(model, "tracked", times, poses)};
  const std::vector<document::Placement> placements{{}, {}, {}, {glm::dquat(0.8, 0, 0.6, 0), {0.1, 0, 0}, 1.2}};
  return document::with_placements(std::move(model), 0, {0, 0, 0}, times, placements).value();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = tests::empty_folder(argv[1]);
  bool good = write(folder / "full.glb", tests::full_model());
  good = write(folder / "empty_part.glb", tests::model_with_empty_part()) && good;
  good = write(folder / "morph.glb", tests::morph_sample().read().value(), true) && good;
  good = write(folder / "tracked.glb", tracked()) && good;
  good = write(folder / "skin.glb", tests::skin_sample().read().value(), true) && good;
  good = write(folder / "patched_morph.glb", patched(tests::morph_sample().read().value())) && good;
  good = write(folder / "patched_skin.glb", patched(tests::skin_sample().read().value())) && good;
  good = write(folder / "patched_full.glb", patched(tests::full_model())) && good;
  good = write_drawn_on(folder, "avatar0.vrm", tests::whole_avatar(0)) && good;
  good = write_drawn_on(folder, "avatar1.vrm", tests::whole_avatar(1)) && good;
  good = write_drawn_on(folder, "drawn_textured.glb", tests::textured_trunk()) && good;
  good = write_drawn_on(folder, "drawn_shared.glb", tests::twin_trunks()) && good;
  good = write_drawn_on(folder, "drawn_quantised.glb", tests::quantised_trunk()) && good;
  good = write_drawn_on(folder, "drawn_draco.glb", tests::packed_trunk(1, 14)) && good;
  good = write_motion(folder / "motion.vrma") && good;
  if (!tests::has_shared()) return good ? 0 : 1;
  for (const auto& entry : std::filesystem::directory_iterator(tests::shared_dir() / "meshes")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".glb") && !name.ends_with(".obj")) continue;
    auto model = io::read_model(tests::read_file(entry.path()), name);
    if (!model) {
      std::fprintf(stderr, "%s\n", model.error().line(name).c_str());
      return 1;
    }
    // A pose that is not the rest pose, so that weights and rotations are checked too.
    for (std::size_t i = 0; i < model->pose.size(); i += 3) model->pose[i] = 0.25 * model->rig->parameters()[i].maximum;
    good = write(folder / (name + ".glb"), *model) && good;
    if (!name.ends_with(".glb")) continue;
    std::filesystem::create_directories(folder / "read");
    std::filesystem::copy_file(entry.path(), folder / "read" / (name + ".glb"));
  }
  return good ? 0 : 1;
}
