#include "ui/files/session_model.h"

#include <filesystem>

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
  return session + ".model" + fs::path(model).extension().string();
}

std::string find_session_model(const std::string& session, const std::string& model) {
  if (model.empty()) return k_default_model;
  if (model.starts_with("builtin:")) return model;
  if (std::string copy = kept_model_of(session, model); is_file(copy)) return copy;
  if (is_file(model)) return model;
  const fs::path beside = fs::path(session).parent_path() / fs::path(model).filename();
  return is_file(beside) ? beside.string() : model;
}

}  // namespace penpose::files
