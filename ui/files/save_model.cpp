#include "ui/files/save_model.h"

#include <filesystem>
#include <iostream>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/base/text/shown_text.h"
#include "core/io/gltf/write/plain_textures.h"
#include "core/io/model/write_model.h"
#include "core/io/project/write_document.h"
#include "ui/files/files.h"
#include "ui/files/open_file.h"

namespace penpose::files {

namespace {

constexpr std::size_t k_longest_path = 4096;

/// What comes out of standard output has no name that says its format.
std::string format_hint(const std::string& path) { return path == k_standard_stream ? ".glb" : path; }

/// Writes what belongs beside a file. What is there already stays; a file of that name that holds something else is
/// left alone, but for that which is named after the file itself.
base::Status save_beside(const io::WriteReport& report, const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const std::string stem = io::stem_of(path);
  for (const auto& [name, bytes] : report.files) {
    const std::filesystem::path beside = folder / name;
    std::error_code code;
    if (std::filesystem::exists(beside, code)) {
      const auto there = read_file(beside.string());
      if (there && *there == bytes) continue;
      const bool own = name.starts_with(stem) && (name.substr(stem.size()) == ".bin" || name.ends_with("_new.bin"));
      if (!own) {
        std::string what = base::shown_name(name, k_longest_path);
        what += " beside it holds something else";
        return base::Error{std::move(what), "", "choose another folder, or write a .glb file, which holds everything"};
      }
    }
    std::filesystem::create_directories(beside.parent_path(), code);
    if (auto written = write_file(beside.string(), bytes); !written) return written;
  }
  return base::Done{};
}

base::Status save(const base::Result<std::vector<std::uint8_t>>& bytes, const io::WriteReport& report,
                  const io::WriteOptions& options, bool animated, const std::string& path, SaveNotes say) {
  if (!bytes) return bytes.error();
  constexpr double k_rounding = 1e-6;  // of the file's numbers; what is off by less needs no word
  if (say == SaveNotes::loud && (report.baked > 0 || report.bake_error > k_rounding)) {
    const int digits = report.bake_error < 1e-4 ? 6 : 3;
    std::cerr << "penpose: " << base::shown_name(path, k_longest_path) << ": ";
    if (report.baked > 0) {
      std::cerr << "deformers are baked to " << report.baked << " morph targets more; no vertex is off by over ";
    } else {
      std::cerr << "eases are straight lines between keys on whole frames; no vertex is off by over ";
    }
    std::cerr << base::format_fixed(100 * report.bake_error, digits) << " % of the model's size";
    if (report.baked > 0 && report.bake_error > options.bake_tolerance)
      std::cerr << ", which is as near to the tolerance as it gets";
    std::cerr << '\n';
  }
  if (say == SaveNotes::loud && animated && report.targets > io::k_common_targets) {
    std::cerr << "penpose: " << base::shown_name(path, k_longest_path) << ": it has " << report.targets
              << " morph targets; some viewers show no more than 8 at a time\n";
  }
  if (auto beside = save_beside(report, path); !beside) return beside;
  if (options.plain_textures) {
    const std::string extension = base::lower_case(std::filesystem::path(path).extension().string());
    if (extension != ".glb" && extension != ".vrm")
      return base::Error{"plain textures are written into a .glb or .vrm file alone", "", "name the output .glb"};
    std::vector<std::string> notes;
    const auto plain = io::with_plain_textures(*bytes, notes);
    if (!plain) return plain.error();
    for (const std::string& note : notes) warn(note, path);
    if (auto written = write_file(path, *plain); !written || say == SaveNotes::quiet) return written;
    for (const std::string& note : report.notes) warn(note, path);
    return base::Done{};
  }
  if (auto written = write_file(path, *bytes); !written || say == SaveNotes::quiet) return written;
  for (const std::string& note : report.notes) warn(note, path);
  return base::Done{};
}

}  // namespace

base::Status save_model(const document::Model& model, const std::string& path, SaveNotes say,
                        const io::WriteOptions& options) {
  io::WriteReport report;
  return save(io::write_model(model, format_hint(path), options, &report), report, options, !model.animations.empty(),
              path, say);
}

base::Status save_document(const document::Document& document, const std::string& path, SaveNotes say,
                           const io::WriteOptions& options) {
  io::WriteReport report;
  const bool animated = !document.timeline->keys.empty() || !document.model->animations.empty();
  return save(io::write_document(document, format_hint(path), options, &report), report, options, animated, path, say);
}

base::Status save_cast(io::Cast cast, std::span<const document::Document* const> documents, const std::string& path) {
  const std::string extension = base::lower_case(std::filesystem::path(path).extension().string());
  if (extension != ".glb") {
    return base::Error{"several characters are kept in a .glb file alone", "",
                       "save under a name that ends in .glb, or export each character"};
  }
  cast.files.clear();
  for (const document::Document* document : documents) {
    auto bytes = io::write_document(*document, path);
    if (!bytes) return bytes.error();
    cast.files.push_back(std::move(*bytes));
  }
  const auto whole = io::write_cast(cast);
  return whole ? write_file(path, *whole) : whole.error();
}

base::Status save_as_it_came(const document::Document& document, const std::string& path, SaveNotes say,
                             const io::WriteOptions& options) {
  return document::is_plain(document) ? save_model(document::model_of(document), path, say, options)
                                      : save_document(document, path, say, options);
}

}  // namespace penpose::files
