#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/io/model/write_model.h"
#include "core/io/project/cast_file.h"

namespace penpose::files {

/// Whether saving says on standard error how exactly deformers were baked, and that there are more morph targets than
/// common viewers show.
enum class SaveNotes : bool { quiet, loud };

/// Writes a model in the format that the path's extension asks for, atomically. Errors of the writer and of the file
/// system.
[[nodiscard]] base::Status save_model(const document::Model& model, const std::string& path,
                                      SaveNotes say = SaveNotes::loud, const io::WriteOptions& options = {});
/// Writes a document, .glb as a project, atomically. Errors of the writer and of the file system.
[[nodiscard]] base::Status save_document(const document::Document& document, const std::string& path,
                                         SaveNotes say = SaveNotes::loud, const io::WriteOptions& options = {});
/// Writes a project of several characters, atomically; of `cast` all but the files. Errors: a name that is none of
/// binary glTF; of the writer and of the file system. Precondition: a document for each member.
[[nodiscard]] base::Status save_cast(io::Cast cast, std::span<const document::Document* const> documents,
                                     const std::string& path);
/// Writes a document as what it came from: a model that nothing was drawn on stays a model.
[[nodiscard]] base::Status save_as_it_came(const document::Document& document, const std::string& path,
                                           SaveNotes say = SaveNotes::loud, const io::WriteOptions& options = {});

}  // namespace penpose::files
