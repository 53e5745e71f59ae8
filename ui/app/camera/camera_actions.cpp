#include "ui/app/camera/camera_actions.h"

#include <array>

#include "ui/app/camera/camera_desk.h"
#include "ui/app/owners.h"

namespace penpose::app {
namespace {

template <std::uint32_t key>
void go_to_camera(CameraDesk& cameras) {
  cameras.go_to_key(key);
}

template <std::uint32_t key>
void keep_camera(CameraDesk& cameras) {
  cameras.keep(key);
}

/// A camera and its number.
constexpr std::string_view k_camera = "M3 8L14 8L14 17L3 17Z M14 11L21 8L21 17L14 14";

template <std::uint32_t key>
constexpr ActionInfo go_to_action(std::string_view name, std::string_view label) {
  return {{name},
          label,
          plain_key('0' + key),
          {},
          "Look from the camera that is kept on this key",
          k_camera,
          does<go_to_camera<key>>};
}

template <std::uint32_t key>
constexpr ActionInfo keep_action(std::string_view name, std::string_view label) {
  return {{name},
          label,
          {'0' + key, true, false},
          {},
          "Keep this view on a key of its own",
          k_camera,
          does<keep_camera<key>>};
}

bool camera_moves(const CameraDesk& cameras) { return cameras.moves(); }

// clang-format off
constinit const std::array k_camera_actions{
    go_to_action<1>("camera_1", "Camera 1"),
    go_to_action<2>("camera_2", "Camera 2"),
    go_to_action<3>("camera_3", "Camera 3"),
    go_to_action<4>("camera_4", "Camera 4"),
    go_to_action<5>("camera_5", "Camera 5"),
    go_to_action<6>("camera_6", "Camera 6"),
    go_to_action<7>("camera_7", "Camera 7"),
    go_to_action<8>("camera_8", "Camera 8"),
    go_to_action<9>("camera_9", "Camera 9"),
    keep_action<1>("keep_camera_1", "Keep camera 1"),
    keep_action<2>("keep_camera_2", "Keep camera 2"),
    keep_action<3>("keep_camera_3", "Keep camera 3"),
    keep_action<4>("keep_camera_4", "Keep camera 4"),
    keep_action<5>("keep_camera_5", "Keep camera 5"),
    keep_action<6>("keep_camera_6", "Keep camera 6"),
    keep_action<7>("keep_camera_7", "Keep camera 7"),
    keep_action<8>("keep_camera_8", "Keep camera 8"),
    keep_action<9>("keep_camera_9", "Keep camera 9"),
    ActionInfo{{"cameras"}, "Cameras", {'0', true, false}, {}, "Views that are kept: go to one, name, replace or remove it",
     k_camera, does([](Dialogs& dialogs) { dialogs.show(Dialog{"cameras"}); })},
    ActionInfo{{"key_camera"}, "Key the camera", {'i', true, false}, {},
     "Keep this view at this moment: the camera moves from key to key, and films show it",
     "M3 8L12 8L12 17L3 17Z M12 11L17 9L17 16L12 14M20 3L23 6L20 9L17 6F", does([](CameraDesk& cameras) { cameras.key_here(); })},
    ActionInfo{{"delete_camera_key"}, "Delete camera key", {'i', true, true}, {}, "Remove the key of the camera at this moment",
     "M3 8L12 8L12 17L3 17Z M12 11L17 9L17 16L12 14M18 3L23 8M23 3L18 8",
     does([](CameraDesk& cameras) { cameras.delete_key(); }), does([](const CameraDesk& cameras) { return cameras.on_key(); })},
    ActionInfo{{"look_through"}, "Look through the camera", plain_key('0'), plain_key(pad_key(0)),
     "Show what the camera of the timeline shows; again: look freely",
     "M3 5L21 5L21 19L3 19Z C12 12 4", does([](CameraDesk& cameras) { cameras.look_through(!cameras.looks_through()); }),
     does<camera_moves>},
    ActionInfo{{"camera_cut"}, "Camera cut", {}, {},
     "From this key of the camera to the next: stand still and cut, or move smoothly again",
     "M3 17L11 17L11 7L21 7", does([](CameraDesk& cameras) { cameras.cut(); }), does<camera_moves>},
};
// clang-format on

}  // namespace

std::span<const ActionInfo> camera_actions() { return k_camera_actions; }

bool is_camera_key(Action action) {
  const bool of_camera = action.name.starts_with("camera_") || action.name.starts_with("keep_camera_");
  return of_camera && action.name.back() >= '1' && action.name.back() <= '9';
}

}  // namespace penpose::app
