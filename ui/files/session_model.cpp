#include "ui/files/session_model.h"

#include <filesystem>

#include "ui/files/load_model.h"

namespace penpose::files {
namespace {

namespace fs = std::filesystem;

/// A plain file, and no pipe or device that could go on for ever: a session names any path it likes.
bool is_file(const fs::path& path) {
  std::error_code code;
  return fs::is_regular_file(path, code);
}

}  // namespace

std::string kept_model_of(const std::string& session, const std::string& model) {
  return session + ".model" + fs::path(model_name(model).file).extension().string();
}

std::string find_session_model(const std::string& session, const std::string& model) {
  if (model.empty()) return k_default_model;
  if (model.starts_with("builtin:")) return model;
  ModelName name = model_name(model);
  const fs::path beside = fs::path(session).parent_path() / fs::path(name.file).filename();
  if (std::string copy = kept_model_of(session, model); is_file(copy)) {
    name.file = std::move(copy);
  } else if (!is_file(name.file) && is_file(beside)) {
    name.file = beside.string();
  }
  return name.text();
}

}  // namespace penpose::files
