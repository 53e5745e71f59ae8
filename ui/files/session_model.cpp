#include "ui/files/session_model.h"

#include <filesystem>

#include "core/base/edition.h"
#include "replay/session/session_line.h"
#include "replay/trace/trace_reader.h"
#include "ui/files/load_model.h"
#include "ui/files/trace_file.h"

namespace penpose::files {
namespace {

namespace fs = std::filesystem;

/// Editors and other programs may write lines in front of the first of a session.
constexpr int k_most_lines_before = 1000;

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

bool changes_with_editions(const std::string& model) {
  return model.starts_with("builtin:") || is_older_project(model_name(model).file);
}

std::optional<std::uint32_t> older_edition_of(const std::string& session) {
  const auto file = open_plain(session);
  if (!file) return std::nullopt;
  replay::TraceReader lines(read_from_file(file->get()));
  for (int i = 0; i < k_most_lines_before; ++i) {
    const auto line = lines.next();
    if (!line || !*line) return std::nullopt;
    const auto origin = replay::session_origin((*line)->text);
    if (origin) return origin->edition < base::k_edition ? std::optional(origin->edition) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace penpose::files
