#include "ui/cli/examples.h"

#include <array>

namespace penpose::cli {
namespace {

struct Row {
  std::string_view command;
  std::array<Example, 2> examples;
};

constexpr auto k_rows = std::to_array<Row>({
    {"",
     {{{"penpose demo -o out", "the built-in head, rigged and posed by a bundled pen session"},
       {"penpose replay drawn.session -o face.glb", "a recorded session, drawn again"}}}},
    {"demo",
     {{{"penpose demo -o out", "writes out/demo.glb and out/demo.png"},
       {"penpose demo -o out --json", "what it did, for scripts"}}}},
    {"info",
     {{{"penpose info face.glb", "what can be posed"},
       {"penpose info builtin:demo --json", "the built-in head with its controls, for scripts"}}}},
    {"devices",
     {{{"penpose devices", "the tablets that are plugged in, and what is missing to open them"},
       {"penpose devices --known", "every tablet whose raw reports are understood"}}}},
    {"record",
     {{{"penpose record -o pen.hid", "until Ctrl-C, or until the tablets are unplugged"},
       {"penpose record -o short.hid --seconds 10", "ten seconds of them"}}}},
    {"decode",
     {{{"penpose decode pen.hid --csv", "the pen, sample by sample"},
       {"penpose decode pen.hid --pad", "what the keys and rings of the tablet did"}}}},
    {"replay",
     {{{"penpose replay drawn.session -o face.glb --png face.png", "the project and a picture of it"},
       {"penpose replay drawn.session --stroke 3 --json", "what it was after three strokes"}}}},
    {"pose",
     {{{"penpose pose face.glb --cases cases.json --case smile -o smile.glb", "one case, and the posed model"},
       {"penpose pose face.glb --cases cases.json --json", "all cases, for scripts"}}}},
    {"suggest",
     {{{"penpose suggest keyed.glb --set jaw=0.3", "the rest of the face, from the poses that are keyed"},
       {"penpose suggest keyed.glb --leave-one-out", "how well the keyed poses foretell each other"}}}},
    {"articulate",
     {{{"penpose articulate elephant.glb --sketch trunk.json -o rigged.glb", "controls from strokes"},
       {"penpose articulate elephant.glb --sketch trunk.json -o paper.glb --preset paper", "as published in 2006"}}}},
    {"track",
     {{{"penpose track frames --labels labels.json -o lips.json", "curves in a folder of pictures"},
       {"penpose track frames --labels labels.json -o lips.json --fps 30", "of a faster camera"}}}},
    {"animate",
     {{{"penpose animate face.glb --track track.json -o clip.glb", "keyframes from a tracked face"},
       {"penpose animate face.glb --track track.json --smooth 0.1 -o clip.glb --json", "steadier, and for scripts"}}}},
    {"render",
     {{{"penpose render builtin:demo --set jaw=0.4 --view front -o jaw.png", "a picture"},
       {"penpose render clip.glb --frames --size 320x320 -o frames/clip", "frames/clip0001.png, ... for ffmpeg"}}}},
    {"serve",
     {{{"penpose serve <<< '{\"do\": \"load\", \"model\": \"builtin:head\"}'", "one line in, one line out"},
       {"penpose serve --session talk.session <<< '{\"do\": \"load\", \"model\": \"builtin:demo\"}'",
        "what is said, recorded to be replayed"}}}},
    {"convert",
     {{{"penpose convert scan.obj scan.glb --shapes shapes", "OBJ files as blend shapes"},
       {"penpose convert posed.glb posed.obj", "the pose as it stands"}}}},
});

}  // namespace

std::span<const Example> examples_of(std::string_view command) {
  for (const Row& row : k_rows) {
    if (row.command == command) return row.examples;
  }
  return {};
}

}  // namespace penpose::cli
