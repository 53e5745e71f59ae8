#include "ui/files/load_model.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "core/base/numbers.h"
#include "core/base/text/closest_name.h"
#include "core/base/text/letters.h"
#include "core/character/demo_head.h"
#include "core/document/expressions.h"
#include "core/head/head.h"
#include "core/io/gltf/read/gltf_contents.h"
#include "core/io/model/model_formats.h"
#include "core/io/model/read_model.h"
#include "core/io/project/cast_file.h"
#include "core/io/project/read_document.h"
#include "ui/files/files.h"
#include "ui/files/open_file.h"

namespace penpose::files {

namespace {

constexpr std::string_view k_built_in = "builtin:";

base::Result<document::Model> built_in_model(std::string_view name) {
  if (name == "head") return head::make_head();
  if (name == "demo") return character::make_demo_head();
  return base::Error{"there is no such model in the program", "", "use builtin:head or builtin:demo"};
}

base::Result<std::vector<std::uint8_t>> read_named(const std::string& path, NamedBy named) {
  return named == NamedBy::user ? read_file(path) : read_plain_file(path);
}

base::Error says_itself() {
  return {"the file says itself how its coordinates are meant", "",
          "leave out --up and --left-handed, which are for OBJ, PLY, OFF and STL"};
}

/// Gives the files that a model names.
io::FileResolver files_beside(const std::string& path) {
  return [folder = std::filesystem::path(path).parent_path().string()](const std::string& name) {
    return read_beside(folder, name);
  };
}

/// What follows a path in a ModelName's text.
constexpr std::array<std::pair<std::string_view, io::Orientation>, 3> k_ends{{
    {"?up=z", {io::Up::z, false}},
    {"?left-handed", {io::Up::y, true}},
    {"?up=z&left-handed", {io::Up::z, true}},
}};

ModelName named_model(const std::string& path, const io::Orientation& orientation) {
  ModelName name = model_name(path);
  if (!orientation.is_usual()) name.orientation = orientation;
  return name;
}

constexpr std::string_view k_character = "?character=";

/// The bytes of one character. Errors: there is none of that number; those of read_cast.
base::Result<std::vector<std::uint8_t>> file_of_character(base::Result<std::vector<std::uint8_t>> bytes,
                                                          std::size_t character) {
  if (!bytes) return bytes;
  const bool several = io::holds_cast(*bytes);
  if (!several && character == 1) return bytes;
  auto cast = several ? io::read_cast(*bytes) : base::Result<io::Cast>(io::Cast{0, {}, {{}}});
  if (!cast) return cast.error();
  if (character > cast->files.size()) {
    return base::Error{"the file has no character " + std::to_string(character), "",
                       "name one from 1 to " + std::to_string(cast->files.size())};
  }
  return std::move(cast->files[character - 1]);
}

/// Whether there is more than the two usual chunks in binary glTF, and so perhaps several characters. Reads their heads
/// alone: models are large, and hardly any has more.
bool has_third_chunk(const std::string& file) {
  const auto opened = open_plain(file);
  if (!opened) return false;
  long at = 12;
  for (int chunk = 0; chunk < 3; ++chunk) {
    std::array<std::uint8_t, 8> head{};
    if (std::fseek(opened->get(), at, SEEK_SET) != 0 || std::fread(head.data(), 1, head.size(), opened->get()) != 8)
      return false;
    at += 8 + static_cast<long>(*base::ByteReader(head).read<std::uint32_t>());
  }
  return true;
}

/// Empty where a file cannot be a project.
io::GltfContents contents_of(const std::string& file) {
  if (!io::keeps_everything(file)) return {};
  const auto bytes = read_plain_file(file);
  return bytes ? io::gltf_contents(*bytes) : io::GltfContents();
}

}  // namespace

std::string ModelName::text() const {
  if (character > 1) return file + std::string(k_character) + std::to_string(character);
  for (const auto& [end, meant] : k_ends) {
    if (meant.up == orientation.up && meant.left_handed == orientation.left_handed) return file + std::string(end);
  }
  return file;
}

ModelName model_name(const std::string& text) {
  std::error_code code;
  for (const auto& [end, meant] : k_ends) {
    if (!text.ends_with(end) || std::filesystem::exists(text, code)) continue;
    return {text.substr(0, text.size() - end.size()), meant};
  }
  const std::size_t at = text.rfind(k_character);
  const auto number = at == std::string::npos ? std::nullopt : base::parse_int(text.substr(at + k_character.size()));
  if (number && *number > 0 && !std::filesystem::exists(text, code))
    return {text.substr(0, at), {}, static_cast<std::size_t>(*number)};
  return {text, {}};
}

bool leaves_axes_open(const std::string& file) {
  const std::string extension = base::lower_case(std::filesystem::path(file).extension().string());
  return extension == ".obj" || extension == ".ply" || extension == ".off" || extension == ".stl";
}

bool is_project(const std::string& file) { return contents_of(file).is_project; }

bool is_older_project(const std::string& file) { return contents_of(file).is_older_project; }

base::Result<document::Model> load_model(const std::string& called, NamedBy named, const io::Orientation& wanted) {
  const auto [path, orientation, character] = named_model(called, wanted);
  if (path.starts_with(k_built_in)) {
    if (!orientation.is_usual()) return says_itself();
    return built_in_model(std::string_view(path).substr(k_built_in.size()));
  }
  const auto bytes = file_of_character(read_named(path, named), character);
  if (!bytes) return bytes.error();
  auto model = io::read_model(*bytes, path, files_beside(path));
  if (!model || orientation.is_usual()) return model;
  if (!io::has_open_orientation(*bytes, path)) return says_itself();
  return io::oriented(*model, orientation);
}

base::Result<document::Document> load_document(const std::string& called, NamedBy named,
                                               const io::Orientation& wanted) {
  const auto [path, orientation, character] = named_model(called, wanted);
  // What leaves its orientation open is no project.
  if (path.starts_with(k_built_in) || !orientation.is_usual()) {
    auto model = load_model(path, named, orientation);
    if (!model) return model.error();
    return document::make_document(std::move(model).value());
  }
  const auto bytes = file_of_character(read_named(path, named), character);
  if (!bytes) return bytes.error();
  return io::read_document(*bytes, path, files_beside(path));
}

base::Result<std::optional<LoadedCast>> load_cast(const std::string& path, NamedBy named) {
  if (path.starts_with(k_built_in) || !io::keeps_everything(path) || !has_third_chunk(path))
    return std::optional<LoadedCast>();
  const auto bytes = read_named(path, named);
  if (!bytes) return bytes.error();
  if (!io::holds_cast(*bytes)) return std::optional<LoadedCast>();
  auto cast = io::read_cast(*bytes);
  if (!cast) return cast.error();
  LoadedCast loaded;
  for (const auto& file : cast->files) {
    auto document = io::read_document(file, path, files_beside(path));
    if (!document) return document.error();
    loaded.documents.push_back(std::move(*document));
  }
  cast->files.clear();
  loaded.cast = std::move(*cast);
  return std::optional(std::move(loaded));
}

base::Status set_parameter(document::Model& model, const std::string& assignment) {
  const std::size_t equals = assignment.rfind('=');
  const std::string place = "--set " + assignment;
  if (equals == std::string::npos) return base::Error{"has no '='", place, "write NAME=VALUE"};
  const std::string name = assignment.substr(0, equals);
  const auto value = base::parse_double(base::trim(std::string_view(assignment).substr(equals + 1)));
  if (!value) return base::Error{"the value is not a number", place, "write NAME=VALUE"};
  const auto parameters = model.rig->parameters();
  const auto found = rig::find_parameter(parameters, name);
  const auto expression = std::find_if(model.expressions.begin(), model.expressions.end(),
                                       [&](const document::Expression& one) { return one.name == name; });
  if (!found && expression != model.expressions.end()) {
    if (!(*value >= 0 && *value <= 1)) return base::Error{"the value is out of range", place, "use 0 to 1"};
    document::set_expression(model, *expression, *value, model.pose);
    return base::Done{};
  }
  if (!found) {
    std::vector<std::string> names;
    for (const rig::Parameter& parameter : parameters) names.push_back(parameter.name);
    for (const document::Expression& one : model.expressions) names.push_back(one.name);
    const auto close = base::closest_name(name, names);
    const std::string remedy = names.empty() ? "this model has nothing to set"
                               : close       ? "did you mean " + *close + "?"
                                             : "`penpose info` lists the " + std::to_string(names.size()) + " names";
    return base::Error{"the model has no parameter \"" + name + "\"", place, remedy};
  }
  const rig::Parameter& parameter = parameters[*found];
  if (!(*value >= parameter.minimum && *value <= parameter.maximum)) {
    return base::Error{
        "the value is out of range", place,
        "use " + base::format_double(parameter.minimum) + " to " + base::format_double(parameter.maximum)};
  }
  model.pose[*found] = *value;
  return base::Done{};
}

}  // namespace penpose::files
