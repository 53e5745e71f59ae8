#include <string>

#include "ui/app/view/present/output/drm_output.h"
#include "ui/app/view/present/output/drm_screens.h"
#include "ui/app/view/present/output/frame_buffer_output.h"
#include "ui/app/view/present/output/picture_output.h"

namespace penpose::app {

base::Result<std::unique_ptr<PictureOutput>> open_screen_output(std::optional<int> screen, bool slow) {
  const DrmScreens screens = find_drm_screens();
  const auto count = static_cast<int>(screens.all.size());
  const int wanted = screen.value_or(0);
  if (wanted < count) return open_drm_output(screens.all[static_cast<std::size_t>(wanted)], slow);
  if (count > 0) {
    return base::Error{"there is no screen " + std::to_string(wanted), "",
                       "--screen counts the connected ones from 0 to " + std::to_string(count - 1)};
  }
  auto frame_buffer = open_frame_buffer_output(wanted);
  if (frame_buffer || screens.forbidden.empty()) return frame_buffer;
  return base::Error{"may not be opened", screens.forbidden, "sudo usermod -aG video $USER, then log in again"};
}

}  // namespace penpose::app
