#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/state_hash.h"
#include "core/document/document.h"

namespace penpose::document {

/// The parts of a state, in the order in which they are hashed.
enum class StatePart : std::uint8_t { model, deformers, parameters, curves, keys };
inline constexpr std::array<std::string_view, 5> k_state_parts{"model", "deformers", "parameters", "curves", "keys"};

/// The canonical hash of a document (method, section 5), with that of every part, so that a difference can be named.
struct DocumentState {
  base::Hash128 whole;
  std::array<std::uint32_t, k_state_parts.size()> parts{};  ///< the low 32 bits of each part's own hash
  friend bool operator==(const DocumentState&, const DocumentState&) = default;
};

/// The names of the parts in which two states differ.
[[nodiscard]] std::vector<std::string_view> differing_parts(const DocumentState& a, const DocumentState& b);

/// Which members of a document are hashed. An older session recorded hashes of fewer members; in its form they can be
/// compared.
struct HashForm {
  /// The timeline has one kind for all keys, and says it before them; controls have none of their own.
  std::optional<KeyKind> one_kind = {};
  bool moments_of_curves = true;  ///< curves say when they were drawn
};

/// Hashes documents. Remembers the hashes of shared parts, so that hashing after every stroke costs only as much as the
/// parts that changed.
class DocumentHasher {
 public:
  DocumentHasher() = default;
  explicit DocumentHasher(HashForm form) : form_(form) {}

  [[nodiscard]] DocumentState operator()(const Document& document);

 private:
  struct HashedCurve {
    std::shared_ptr<const PoseCurve> curve;
    base::Hash128 hash;
  };
  [[nodiscard]] base::Hash128 hash_curves(const Document& document);

  HashForm form_;
  std::vector<HashedCurve> curves_;
  std::shared_ptr<const mesh::TriangleMesh> mesh_;
  std::shared_ptr<const rig::BlendShapes> shapes_;
  std::shared_ptr<const rig::Skeleton> skeleton_;
  base::Hash128 surface_;
  std::shared_ptr<const Model> animated_;
  std::vector<std::size_t> opened_;  ///< animations of it that are clips
  base::Hash128 animations_;
};

}  // namespace penpose::document
