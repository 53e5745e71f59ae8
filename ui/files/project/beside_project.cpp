#include "ui/files/project/beside_project.h"

namespace penpose::files {
namespace {

namespace fs = std::filesystem;

}  // namespace

fs::path project_folder(const std::string& project) {
  std::error_code ignored;
  return fs::absolute(fs::path(project), ignored).parent_path();
}

std::string name_beside(const std::string& path, const std::string& project) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::path(path), error);
  if (error) return path;
  if (project.empty()) return whole.string();
  const fs::path folder = fs::weakly_canonical(project_folder(project), error);
  const fs::path relative = error ? fs::path() : whole.lexically_relative(folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return below ? relative.string() : whole.string();
}

std::string path_beside(const std::string& name, const std::string& project) {
  if (fs::path(name).is_absolute()) return name;
  return project.empty() ? std::string() : (project_folder(project) / name).string();
}

std::string renamed_beside(const std::string& name, const std::string& before, const std::string& project) {
  const std::string path = path_beside(name, before);
  return path.empty() ? name : name_beside(path, project);
}

}  // namespace penpose::files
