#include "ui/app/view/present/output/drm_screens.h"

#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <unistd.h>
#include <xf86drmMode.h>

#include "ui/app/view/present/output/drm_objects.h"

namespace penpose::app {
namespace {

/// Cards are numbered from 0, and one that left leaves a hole.
constexpr int k_most_cards = 16;

}  // namespace

DrmScreens find_drm_screens() {
  DrmScreens found;
  for (int card = 0; card < k_most_cards; ++card) {
    DrmScreen screen;
    screen.card = card;
    const OpenDevice device(screen.device());
    if (!device && (device.reason() == EACCES || device.reason() == EPERM) && found.forbidden.empty())
      found.forbidden = screen.device();
    if (!device) continue;
    const DrmResources resources(drmModeGetResources(device.number()));
    for (int i = 0; resources && i < resources->count_connectors; ++i) {
      const DrmConnector connector(drmModeGetConnector(device.number(), resources->connectors[i]));
      if (!connector || connector->connection != DRM_MODE_CONNECTED || connector->count_modes == 0) continue;
      screen.connector = connector->connector_id;
      screen.dpi = dpi_of(best_mode(*connector).hdisplay, connector->mmWidth);
      found.all.push_back(screen);
      ++screen.of_card;
    }
  }
  return found;
}

}  // namespace penpose::app
