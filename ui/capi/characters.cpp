#include <algorithm>

#include "core/base/byte_reader.h"
#include "core/base/text/utf8.h"
#include "core/io/model/model_formats.h"
#include "ui/capi/from_c.h"

using namespace penpose;        // NOLINT(google-build-using-namespace): functions of C have no namespace of their own
using namespace penpose::capi;  // NOLINT(google-build-using-namespace)

namespace {

std::vector<glm::vec3> float_points_of(const float* xyz, std::size_t count) {
  const auto numbers = array(xyz, numbers_of(count, 3, "shapes/count"), "shapes/deltas");
  std::vector<glm::vec3> out;
  for (std::size_t i = 0; i < numbers.size(); i += 3) out.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return out;
}

/// A name that files can hold: formats of text keep no others.
std::string name_of(const char* name, const char* place) {
  std::string out(text(name, place));
  if (base::valid_utf8(out) != out) fail_argument("a name that is not valid UTF-8", place, "give it in UTF-8");
  return out;
}

rig::BlendShape shape_of(const penpose_shape& shape, std::size_t vertex_count) {
  rig::BlendShape out;
  out.parameter = {name_of(shape.name, "shapes/name"), 0, shape.minimum, shape.maximum};
  if (out.parameter.name.empty()) fail_argument("a shape without a name", "shapes/name", "give it one of its own");
  if (!(shape.minimum <= 0 && shape.maximum >= 0))
    fail_argument("the range is without 0", "shape " + out.parameter.name, "let 0 lie in it");
  const auto deltas = float_points_of(shape.deltas, shape.count);
  if (shape.vertices == nullptr && shape.count != vertex_count && shape.count > 0) {
    fail_argument(std::to_string(shape.count) + " entries for " + std::to_string(vertex_count) + " vertices",
                  "shape " + out.parameter.name, "name their vertices, or give one for each");
  }
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    // What does not move is no part of a shape of all vertices.
    if (shape.vertices == nullptr && deltas[i] == glm::vec3(0)) continue;
    out.vertices.push_back(shape.vertices == nullptr ? static_cast<std::uint32_t>(i) : shape.vertices[i]);
    out.deltas.push_back(deltas[i]);
  }
  return out;
}

rig::Joint joint_of(const penpose_joint& joint) {
  rig::Joint out;
  out.name = name_of(joint.name, "joints/name");
  out.parent = joint.parent;
  out.posable = joint.posable != 0;
  const auto triple = [](const double* from) { return glm::dvec3(from[0], from[1], from[2]); };
  out.translation = triple(joint.translation);
  out.rest_rotation = glm::dquat(joint.rotation[3], joint.rotation[0], joint.rotation[1], joint.rotation[2]);
  out.scale = triple(joint.scale);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) out.inverse_bind[column][row] = joint.inverse_bind[4 * column + row];
  }
  out.minimum = triple(joint.minimum);
  out.maximum = triple(joint.maximum);
  return out;
}

void add_influences(const penpose_arrays& arrays, character::Pieces& out) {
  const std::size_t count = arrays.influences;
  if (arrays.joint_count == 0) return;
  if (count > 64) fail_argument("more than 64 influences a vertex", "influences", "give those that count");
  const auto joints = array(arrays.joint_of, count * arrays.vertex_count, "joint_of");
  const auto weights = array(arrays.weight_of, count * arrays.vertex_count, "weight_of");
  for (std::size_t v = 0; v < arrays.vertex_count; ++v) {
    out.first_influence.push_back(static_cast<std::uint32_t>(out.influences.size()));
    for (std::size_t i = v * count; i < (v + 1) * count; ++i) {
      // What is 0 is padding, whichever joint it names.
      if (weights[i] != 0) out.influences.push_back({joints[i], weights[i]});
    }
  }
  out.first_influence.push_back(static_cast<std::uint32_t>(out.influences.size()));
}

character::Pieces pieces_of(const penpose_arrays& arrays) {
  if (arrays.vertex_count > 0xffffffffU) fail_argument("too many vertices", "vertex_count", "split the model");
  character::Pieces out;
  out.mesh.positions = points_of(arrays.positions, arrays.vertex_count, "positions");
  const auto corners = array(arrays.triangles, numbers_of(arrays.triangle_count, 3, "triangle_count"), "triangles");
  for (std::size_t i = 0; i < corners.size(); i += 3)
    out.mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  for (const penpose_shape& shape : array(arrays.shapes, arrays.shape_count, "shapes"))
    out.shapes.push_back(shape_of(shape, arrays.vertex_count));
  for (const penpose_joint& joint : array(arrays.joints, arrays.joint_count, "joints"))
    out.joints.push_back(joint_of(joint));
  add_influences(arrays, out);
  return out;
}

}  // namespace

base::Result<document::Document> penpose::capi::built_in_document(std::string_view name) {
  auto made = character::Character::built_in(name);
  if (!made) return made.error();
  return made->document();
}

int32_t penpose_character_read(penpose_library* library, const void* bytes, size_t size, const char* hint,
                               penpose_handle* character, penpose_error* error) {
  return call(error, [&] {
    needed(library, "library");
    needed(character, "character");
    const auto read = array(static_cast<const std::uint8_t*>(bytes), size, "bytes");
    give<CharacterObject>(*library, *character,
                          taken(character::Character::read(read, hint == nullptr ? std::string_view() : hint)));
  });
}

int32_t penpose_character_built_in(penpose_library* library, const char* name, penpose_handle* character,
                                   penpose_error* error) {
  return call(error, [&] {
    needed(library, "library");
    needed(character, "character");
    give<CharacterObject>(*library, *character, character::Character(taken(built_in_document(text(name, "name")))));
  });
}

int32_t penpose_character_from_arrays(penpose_library* library, const penpose_arrays* arrays, penpose_handle* character,
                                      penpose_error* error) {
  return call(error, [&] {
    needed(library, "library");
    needed(character, "character");
    give<CharacterObject>(*library, *character, taken(character::Character::make(pieces_of(needed(arrays, "arrays")))));
  });
}

int32_t penpose_character_copy(penpose_library* library, penpose_handle character, penpose_handle* copy,
                               penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    give<CharacterObject>(*library, needed(copy, "copy"), character::Character(one.document()));
  });
}

int32_t penpose_count(penpose_library* library, penpose_handle character, penpose_counts* counts,
                      penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    const document::Document& document = one.document();
    needed(counts, "counts") = {document.model->mesh->vertex_count(), document.model->mesh->triangle_count(),
                                one.parameters().size(), document.curves.size()};
  });
}

int32_t penpose_triangles(penpose_library* library, penpose_handle character, uint32_t* corners, size_t count,
                          penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    const auto triangles = one.document().model->mesh->triangles();
    if (count < triangles.size()) {
      fail(PENPOSE_TOO_SMALL,
           {"there are " + std::to_string(triangles.size()) + " triangles", "count", "give room for all of them"});
    }
    std::uint32_t* out = array(corners, 3 * triangles.size(), "corners").data();
    for (const mesh::Triangle& triangle : triangles) out = std::copy(triangle.begin(), triangle.end(), out);
  });
}

int32_t penpose_state(penpose_library* library, penpose_handle character, char state[33], penpose_error* error) {
  return call_character(library, character, error, [&](character::Character& one, CharacterObject&) {
    needed(state, "state");
    const std::string hex = one.state().whole.hex();
    std::copy_n(hex.c_str(), 33, state);
  });
}

int32_t penpose_write(penpose_library* library, penpose_handle character, const char* format, void* bytes,
                      size_t capacity, size_t* size, penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    const std::string_view wanted = text(format, "format");
    if (!io::format_to_write(wanted))
      fail_argument("there is no such format", "format", "give " + io::extensions_to_write());
    const auto file = taken(one.write(wanted));
    write_list<std::uint8_t>(file, static_cast<std::uint8_t*>(bytes), capacity, size, "bytes");
  });
}
