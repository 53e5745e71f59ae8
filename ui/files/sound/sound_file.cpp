#include "ui/files/sound/sound_file.h"

#include <filesystem>

#include "core/sound/read/read_sound.h"
#include "ui/files/files.h"
#include "ui/files/project/beside_project.h"

namespace penpose::files {
namespace {

namespace fs = std::filesystem;

}  // namespace

base::Result<LoadedSound> load_sound(const std::string& path, const std::string& project) {
  const auto bytes = read_file(path, k_most_sound_bytes);
  if (!bytes) return bytes.error();
  auto sound = sound::read_sound(*bytes);
  if (!sound) return sound.error();
  return LoadedSound{std::move(sound).value(), {name_beside(path, project), base::hash_bytes(*bytes), 0}, false};
}

std::string sound_named_from(const std::string& file, const std::string& before, const std::string& project) {
  return renamed_beside(file, before, project);
}

base::Result<LoadedSound> load_sound_of(const document::SoundReference& reference, const std::string& project) {
  const bool whole = fs::path(reference.file).is_absolute();
  if (!whole && project.empty()) return base::Error{"where the sound lies is not known", "", "open it again"};
  const auto bytes = whole ? read_plain_file(reference.file, k_most_sound_bytes)
                           : read_beside(project_folder(project).string(), reference.file, k_most_sound_bytes);
  if (!bytes) return bytes.error();
  auto sound = sound::read_sound(*bytes);
  if (!sound) return sound.error();
  const bool changed = !(base::hash_bytes(*bytes) == reference.content);
  return LoadedSound{std::move(sound).value(), reference, changed};
}

}  // namespace penpose::files
