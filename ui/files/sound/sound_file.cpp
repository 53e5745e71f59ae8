#include "ui/files/sound/sound_file.h"

#include <filesystem>

#include "core/sound/read/read_sound.h"
#include "ui/files/files.h"

namespace penpose::files {
namespace {

namespace fs = std::filesystem;

/// The folder that a project lies in.
fs::path folder_of(const std::string& project) {
  std::error_code ignored;
  return fs::absolute(fs::path(project), ignored).parent_path();
}

std::string named_from(const std::string& path, const std::string& project) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::path(path), error);
  if (error) return path;
  if (project.empty()) return whole.string();
  const fs::path folder = fs::weakly_canonical(folder_of(project), error);
  const fs::path relative = error ? fs::path() : whole.lexically_relative(folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return below ? relative.string() : whole.string();
}

}  // namespace

base::Result<LoadedSound> load_sound(const std::string& path, const std::string& project) {
  const auto bytes = read_file(path, k_most_sound_bytes);
  if (!bytes) return bytes.error();
  auto sound = sound::read_sound(*bytes);
  if (!sound) return sound.error();
  return LoadedSound{std::move(sound).value(), {named_from(path, project), base::hash_bytes(*bytes), 0}, false};
}

std::string sound_named_from(const std::string& file, const std::string& before, const std::string& project) {
  const bool whole = fs::path(file).is_absolute();
  if (!whole && before.empty()) return file;
  return named_from(whole ? file : (folder_of(before) / file).string(), project);
}

base::Result<LoadedSound> load_sound_of(const document::SoundReference& reference, const std::string& project) {
  const bool whole = fs::path(reference.file).is_absolute();
  if (!whole && project.empty()) return base::Error{"where the sound lies is not known", "", "open it again"};
  const auto bytes = whole ? read_plain_file(reference.file, k_most_sound_bytes)
                           : read_beside(folder_of(project).string(), reference.file, k_most_sound_bytes);
  if (!bytes) return bytes.error();
  auto sound = sound::read_sound(*bytes);
  if (!sound) return sound.error();
  const bool changed = !(base::hash_bytes(*bytes) == reference.content);
  return LoadedSound{std::move(sound).value(), reference, changed};
}

}  // namespace penpose::files
