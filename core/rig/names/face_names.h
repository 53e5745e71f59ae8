#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The names that programs give to what a face does (face_names.tsv): ARKit's, those of the Facial Action Coding System
// (Ekman and Friesen 1978), of VRM, MikuMikuDance, Unified Expressions, SRanipal, Character Creator and others.

namespace penpose::rig {

/// A name without its side, as it is looked up: small letters and digits of its words joined.
/// A side stands first, last or between other words, as "left", "l", "lf" or 左.
enum class Side : std::uint8_t { none, left, right };

/// One thing that a face does: a row of the table.
struct FaceMeaning {
  std::string name;                     ///< "eyeBlink"
  std::string words;                    ///< "eye closes"; empty: it has none of its own
  std::vector<std::string_view> names;  ///< those that programs give it, as the table writes them
  std::string_view instead;             ///< the sets of controls that stand for it; empty: none
};

/// All meanings, in the order of the table.
[[nodiscard]] std::span<const FaceMeaning> face_meanings();

/// A name as the table has it.
struct FaceName {
  std::size_t meaning = 0;  ///< its row
  Side side = Side::none;
  std::size_t rank = 0;  ///< its place among the names of the row
  friend bool operator==(const FaceName&, const FaceName&) = default;
};

/// Returns what a name of any program means. A number in front ("A14_Eye_Blink_Left") and what programs write before
/// and behind names ("CTRL_expressions_", "facs_bs_", "vrc.", "_div2") are no part of it. Nothing: the table does not
/// have it.
[[nodiscard]] std::optional<FaceName> face_name(std::string_view name);

}  // namespace penpose::rig
