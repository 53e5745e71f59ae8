#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/io/project/cast_file.h"
#include "core/io/surface/orientation.h"

namespace penpose::files {

/// Who names a file: the user, who may mean a pipe, or another file, which may name whatever it likes, so that only
/// plain files are opened.
enum class NamedBy : bool { user, file };

/// A model's file, how its coordinates are meant, and which character of a project of several it is. As one text, as
/// sessions and the lists of what was opened keep it, what is not usual stands behind the path: "head.obj?up=z",
/// "head.obj?left-handed", "head.obj?up=z&left-handed", "scene.glb?character=2".
struct ModelName {
  std::string file;
  io::Orientation orientation;
  std::size_t character = 1;  ///< from 1

  [[nodiscard]] std::string text() const;
};
/// The parts of such a text. A file that really is called so is that file.
[[nodiscard]] ModelName model_name(const std::string& text);

/// Whether files of this name leave open which axis is up: OBJ, PLY, OFF, STL.
[[nodiscard]] bool leaves_axes_open(const std::string& file);

/// Whether a file opens as a project with all that was done in it, and not as a model that others made.
[[nodiscard]] bool is_project(const std::string& file);
/// Whether a file is a project that an older edition saved: what today does not build as it was stays as it was baked.
[[nodiscard]] bool is_older_project(const std::string& file);

/// Opens and reads a model, and the files below its folder that it names; "builtin:head" is the built-in head and
/// "builtin:demo" the same with the deformers of the demo. `path` may be a ModelName's text. `orientation`: how
/// the file's coordinates are meant, where it does not say so itself; before what the text says. Errors of the file
/// system and of the reader; an orientation for a file that has one.
[[nodiscard]] base::Result<document::Model> load_model(const std::string& path, NamedBy named = NamedBy::user,
                                                       const io::Orientation& orientation = {});

/// The same as a document: of a project with all that it keeps beyond its model.
[[nodiscard]] base::Result<document::Document> load_document(const std::string& path, NamedBy named = NamedBy::user,
                                                             const io::Orientation& orientation = {});

/// The characters of a project of several.
struct LoadedCast {
  io::Cast cast;  ///< without files
  std::vector<document::Document> documents;
};
/// Opens them; nothing: the file is no project of several characters. Errors: as load_document.
[[nodiscard]] base::Result<std::optional<LoadedCast>> load_cast(const std::string& path, NamedBy named = NamedBy::user);

/// Sets one parameter of the model's pose, or the targets of one expression, from "NAME=VALUE". Errors: no "=", no
/// number, no parameter and no expression of that name (the
/// closest one is suggested), a value outside its range.
[[nodiscard]] base::Status set_parameter(document::Model& model, const std::string& assignment);

}  // namespace penpose::files
