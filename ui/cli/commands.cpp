#include "ui/cli/commands.h"

namespace penpose::cli {

// Each stands at the end of its file. A new one is that file, a line here and a row below.
Subcommand demo_subcommand();
Subcommand info_subcommand();
Subcommand devices_subcommand();
Subcommand record_subcommand();
Subcommand decode_subcommand();
Subcommand replay_subcommand();
Subcommand pose_subcommand();
Subcommand poses_subcommand();
Subcommand suggest_subcommand();
Subcommand draw_subcommand();
Subcommand articulate_subcommand();
Subcommand track_subcommand();
Subcommand animate_subcommand();
Subcommand mouths_subcommand();
Subcommand render_subcommand();
Subcommand film_subcommand();
Subcommand convert_subcommand();
Subcommand serve_subcommand();

std::span<const Subcommand> subcommands() {
  static const Subcommand all[] = {
      demo_subcommand(),        //
      info_subcommand(),        //
      devices_subcommand(),     //
      record_subcommand(),      //
      decode_subcommand(),      //
      replay_subcommand(),      //
      pose_subcommand(),        //
      poses_subcommand(),       //
      suggest_subcommand(),     //
      draw_subcommand(),        //
      articulate_subcommand(),  //
      track_subcommand(),       //
      animate_subcommand(),     //
      mouths_subcommand(),      //
      render_subcommand(),      //
      film_subcommand(),        //
      convert_subcommand(),     //
      serve_subcommand(),       //
  };
  return all;
}

const Subcommand* subcommand_named(std::string_view name) {
  for (const Subcommand& command : subcommands()) {
    if (command.name == name) return &command;
  }
  return nullptr;
}

std::span<const Example> examples_of(std::string_view command) {
  static constexpr std::array<Example, 2> k_program{
      {{"penpose demo -o out", "the built-in head, rigged and posed by a bundled pen session"},
       {"penpose replay drawn.session -o face.glb", "a recorded session, drawn again"}}};
  if (command.empty()) return k_program;
  const Subcommand* found = subcommand_named(command);
  return found == nullptr ? std::span<const Example>() : found->examples;
}

}  // namespace penpose::cli
