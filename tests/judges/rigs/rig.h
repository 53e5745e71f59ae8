#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/document/model.h"

namespace penpose::judges {

using geometry::ModelPoint;
using geometry::ModelVector;

/// Which rigs a figure may be tuned on. Nobody chooses anything by looking at a rig that is held out.
enum class Group : std::uint8_t { seen, held_out, shared };

/// "seen", "held_out", "shared".
[[nodiscard]] const char* group_name(Group group);

/// A line of the face that an artist draws, through vertices in order. Names are those of the built-in head: lip_upper,
/// lip_lower, lip_upper_inner, lip_lower_inner, jaw, nose_bridge, and of each side (_L, _R) brow, eyelid_upper,
/// eyelid_lower. A shared face has the names of its file of landmarks.
struct FaceLine {
  std::string name;
  std::vector<std::uint32_t> vertices;
};

/// A pose that the rig can make; other controls are at rest.
struct KnownPose {
  std::string name;  ///< of the expression: smile, open_smile, blink, ...; what is not a letter or digit is "_"
  std::vector<std::pair<std::string, double>> values;  ///< controls by name, at most one of each
};

/// What a control does, in the words of `parts.h`: smile_L, jaw_open, brow_inner_up_R, ...
struct Meaning {
  std::string control;             ///< a parameter's name; a joint's without ".rx"
  std::vector<std::string> means;  ///< empty: more than any single gesture asks for
};

/// A limb that is posed by turning joints, and the line that is drawn along it.
struct Move {
  struct Turn {
    std::size_t joint = 0;
    geometry::ModelVector degrees{0};  ///< an axis of the world times the angle
  };
  std::string name;
  double yaw_degrees = 0;          ///< from where it is drawn
  std::vector<std::size_t> chain;  ///< joints from root to tip that the line runs along
  std::vector<Turn> turns;         ///< parents before their children
};

/// A model with what a judge knows about it and the program does not.
struct Rig {
  std::string name;
  std::string kind;  ///< one line: how it differs from the others
  Group group = Group::seen;
  document::Model model;  ///< at rest, as a reader of files would give it
  std::vector<FaceLine> lines;
  std::vector<KnownPose> poses;
  std::vector<Meaning> meanings;
  std::vector<Move> moves;

  [[nodiscard]] const FaceLine* line(std::string_view called) const;
};

/// A rig that is made when it is needed; making one takes a fraction of a second.
struct RigMaker {
  const char* name;
  Group group;
  Rig (*make)();
};

/// All rigs of the project: those in rigs/seen, then those in rigs/held_out. They are the same bits on every machine.
[[nodiscard]] std::span<const RigMaker> own_rigs();

}  // namespace penpose::judges
