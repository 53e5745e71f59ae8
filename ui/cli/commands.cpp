#include "ui/cli/commands.h"

#include "ui/cli/model/articulate_command.h"
#include "ui/cli/model/convert_command.h"
#include "ui/cli/model/demo_command.h"
#include "ui/cli/model/info_command.h"
#include "ui/cli/model/render_command.h"
#include "ui/cli/pose/pose_command.h"
#include "ui/cli/pose/serve_command.h"
#include "ui/cli/pose/suggest_command.h"
#include "ui/cli/tablet/decode_command.h"
#include "ui/cli/tablet/devices_command.h"
#include "ui/cli/tablet/record_command.h"
#include "ui/cli/tablet/replay_command.h"
#include "ui/cli/track/animate_command.h"
#include "ui/cli/track/track_command.h"

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
