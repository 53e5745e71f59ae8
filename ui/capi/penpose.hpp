// penpose for C++20: poses and rigs 3D characters by drawing. Read this header first; the others say the rest.
//
//   find_package(penpose REQUIRED)
//   target_link_libraries(mine PRIVATE penpose::core)   # penpose::decode: tablets; penpose::replay: sessions
//
// A character is posed so: make it, give it a curve, say where the curve should go, solve, evaluate.
//
//   #include <penpose.hpp>
//   auto head = penpose::Character::read(bytes);                         // or built_in(), make(pieces)
//   auto lip = head->place_reference(*head->points_of("lip_upper"));     // or points_at(vertices),
//   draw_reference(view, px) auto places = *head->positions_of(*lip); for (auto& p : places) p.y += 0.002; if (auto
//   placed = head->place_target(*lip, places); !placed) return fail(placed.error().line()); if (auto solved =
//   head->solve(); !solved) return fail(solved.error().line()); std::vector<penpose::Point>
//   positions(head->vertex_count()); head->evaluate(head->pose(), positions);
//
// Nothing throws but what memory throws. What may fail gives a Result: test it, then `*result` is the value and
// `result.error().line()` one line for a person. A value of a Result that is an error ends the program.
//
// Model space is right-handed, y up, in the model's own unit of length; px have their origin at the top left. A
// Character is used by one thread at a time; different ones by different threads. All of a character is its Document, a
// value that is cheap to copy and that nothing but commands changes: `head->document()` is a snapshot, and
// `penpose::Character(snapshot)` goes on from it.
#pragma once

#include "core/character/character.h"
#include "core/character/live_target.h"
#include "core/tracking/animate.h"

namespace penpose {

using character::Character;   // what is posed
using character::DrawnFace;   // what a drawing of the face was taken for
using character::CurveId;     // a curve of it, from 1
using character::LiveTarget;  // the pose that follows a target while it is drawn
using character::Pieces;      // a character from arrays
using character::Preset;      // what a solve minimises
using character::View;        // where somebody draws from
using Point = geometry::ModelPoint;
using Px = geometry::PxPoint;
using articulation::Sketch;  // a deformer in four strokes
using mesh::MeshPoint;       // a point of the surface
using portrait::Drawing;     // lines of a whole face

// `animate(head.document(), track, map)` makes keyframes from what a face tracker saw, with a track of
// `io::read_track(bytes, nullptr, {})` and its map of `io::read_bundled_map(*track->format)` or
// `io::read_map_file(bytes)`.
using tracking::animate;
using tracking::Animated;
using tracking::AnimateOptions;

}  // namespace penpose

// With penpose::decode: `make_decoder(identity)` gives what turns a tablet's reports into samples.
#include "firmware_io/decode/decoder_factory.h"

// With penpose::replay: `play_session(read_recording(read_from(bytes)), options)` replays a session or a recording of a
// tablet; a CommandRecorder, which a Character's listener feeds, writes a session.
#include "replay/recording/recording.h"
#include "replay/session/command_recorder.h"
#include "replay/session/session_player.h"

// And `character::make_demo_head()`: the built-in head with its sketched controls.
#include "core/character/demo_head.h"
