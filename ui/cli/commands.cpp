#include "ui/cli/commands.h"

#include "ui/cli/animate_command.h"
#include "ui/cli/articulate_command.h"
#include "ui/cli/convert_command.h"
#include "ui/cli/decode_command.h"
#include "ui/cli/demo_command.h"
#include "ui/cli/devices_command.h"
#include "ui/cli/info_command.h"
#include "ui/cli/pose_command.h"
#include "ui/cli/record_command.h"
#include "ui/cli/render_command.h"
#include "ui/cli/replay_command.h"
#include "ui/cli/serve_command.h"
#include "ui/cli/suggest_command.h"
#include "ui/cli/track_command.h"

namespace penpose::cli {

std::vector<AddCommand> all_commands() {
  return {
      add_demo_command,        //
      add_info_command,        //
      add_devices_command,     //
      add_record_command,      //
      add_decode_command,      //
      add_replay_command,      //
      add_pose_command,        //
      add_suggest_command,     //
      add_articulate_command,  //
      add_track_command,       //
      add_animate_command,     //
      add_render_command,      //
      add_convert_command,     //
      add_serve_command,       //
  };
}

}  // namespace penpose::cli
