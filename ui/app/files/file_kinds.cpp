#include "ui/app/files/file_kinds.h"

#include <filesystem>

#include "core/io/model/model_formats.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

/// Behind the name of a model, before the extension: the project that was made of it.
constexpr std::string_view k_own_end = ".penpose";

/// Without what the program itself puts behind a name.
std::string stem_of(const Files& files) {
  const std::string from = !files.project().empty() ? files.project() : files.path();
  if (from.starts_with("builtin:")) return "head";
  std::string stem = fs::path(from).stem().string();
  if (stem.size() > k_own_end.size() && stem.ends_with(k_own_end)) stem.resize(stem.size() - k_own_end.size());
  return stem;
}

std::string free_name(const std::string& folder, const std::string& stem) {
  return fs::path(free_path(folder, stem, ".glb")).filename().string();
}

}  // namespace

const std::vector<FileKind>& opened_kinds() {
  static const std::vector<FileKind> kinds = [] {
    const std::vector<std::string> recordings{".session", ".hid", ".trace"};
    auto all = io::extensions_read();
    all.insert(all.end(), recordings.begin(), recordings.end());
    return std::vector<FileKind>{
        {"All that opens", all}, {"Models", io::extensions_read()}, {"Sessions", recordings}, {"Every file", {}}};
  }();
  return kinds;
}

const std::vector<FileKind>& picture_kinds() {
  static const std::vector<FileKind> kinds{{"Pictures", {".png", ".jpg", ".jpeg"}}};
  return kinds;
}

const std::vector<FileKind>& reference_kinds() {
  static const std::vector<FileKind> kinds = [] {
    const std::vector<std::string> films{".mp4", ".mov", ".m4v", ".webm", ".mkv", ".avi", ".gif"};
    std::vector<std::string> all = picture_kinds().front().extensions;
    all.insert(all.end(), films.begin(), films.end());
    return std::vector<FileKind>{{"Pictures and films", all}, picture_kinds().front(), {"Films", films}};
  }();
  return kinds;
}

const std::vector<FileKind>& sound_kinds() {
  static const std::vector<FileKind> kinds{
      {"Sounds", {".wav", ".flac", ".ogg", ".oga", ".opus", ".mp3", ".aiff", ".aif", ".caf", ".w64", ".rf64", ".au"}}};
  return kinds;
}

std::string name_to_save(const Files& files, const std::string& folder) {
  if (!files.project().empty()) return fs::path(files.project()).filename().string();
  std::string stem = stem_of(files);
  std::error_code code;
  const bool taken = fs::exists(fs::path(folder) / (stem + ".glb"), code);
  if (taken && !files.path().starts_with("builtin:")) stem += k_own_end;
  return free_name(folder, stem);
}

std::string name_to_export(const Files& files, const std::string& folder) {
  return free_name(folder, stem_of(files) + "-export");
}

}  // namespace penpose::app
