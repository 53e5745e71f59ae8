#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "firmware_io/decode/table/tablet_table.h"
#include "firmware_io/device/hid_interface.h"
#include "firmware_io/device/report_source.h"
#include "firmware_io/device/source/wake_up.h"

namespace penpose::device {

enum class Transport : std::uint8_t {
  hidraw,  ///< in parallel with the kernel's driver
  libusb,  ///< instead of the kernel's driver
  event,   ///< what the kernel's driver makes of it
};

/// What an interface is for.
enum class Carries : std::uint8_t {
  pen,       ///< and perhaps keys and fingers
  pad,       ///< keys and dials, and perhaps fingers
  touch,     ///< fingers alone
  receiver,  ///< tells which tablet the other interfaces of a wireless receiver belong to
  other,
};

/// Whether an interface may be opened.
enum class Access : std::uint8_t {
  allowed,
  denied,  ///< no permission
  busy,    ///< another program has it
  absent,  ///< the system made no node to open
};

/// A recognised interface.
struct LiveTablet {
  HidInterface interface;
  Carries carries = Carries::other;
  std::string method;                        ///< how it is read: "descriptor", "protocol NAME", ...; empty for `other`
  bool has_keys = false;                     ///< has keys or dials
  bool has_touch = false;                    ///< feels fingers
  std::optional<decode::TabletMatch> match;  ///< in the table of tablets; points into it
  std::string guess;                         ///< decode::Recognition::guess
  bool strings_unread = false;               ///< the table asks for strings that could not be read
  Transport transport = Transport::hidraw;
  std::string reason;  ///< for that transport: "it has no hidraw node"
  Access access = Access::absent;

  /// What is opened: "/dev/hidraw3", "/dev/bus/usb/001/004" or "/dev/input/event5".
  [[nodiscard]] const std::string& node() const;
  /// The interface's name on the command line: its node, or "usb:1-2:1.0" where it is read through libusb.
  [[nodiscard]] std::string path() const;
  /// Overrides the choice of transport.
  void use(Transport other);
  /// The steps that wake it; empty if the kernel's driver has done that, or if the tablet is not certain.
  [[nodiscard]] WakeUp wake_up() const;
};

/// Reads a USB string of a device; replaced in tests.
using ReadString = std::function<base::Result<std::string>(const std::string& usb_node, std::uint8_t index)>;

/// Recognises an interface: reads the strings that the table needs to distinguish its tablets, unless they are known,
/// and decides how to open it. Takes no interface away from a driver. `own` (may be null) holds the user's tablets and
/// must live as long as the result.
[[nodiscard]] LiveTablet recognise(HidInterface interface, const decode::TabletTable* own = nullptr,
                                   const ReadString& read_string = {});

/// Puts event devices in the place of the interfaces of the same device where none of those can be opened, or none is
/// recognised, so that no tablet is listed twice. Where neither way is open, the interfaces remain. What a program
/// makes (uinput) counts only where no other pen can be opened, because it may be made of one. `all` are the recognised
/// and unrecognised interfaces, of which `tablets` are a part.
[[nodiscard]] std::vector<LiveTablet> with_event_devices(std::vector<LiveTablet> tablets,
                                                         const std::vector<HidInterface>& all,
                                                         std::vector<LiveTablet> events);

/// Every interface with a pen, the keys or the fingers of a tablet; touch devices that belong to no tablet are left to
/// the desktop. Strings of devices in `before` are reused and not requested again.
[[nodiscard]] std::vector<LiveTablet> list_tablets(const decode::TabletTable* own = nullptr,
                                                   const std::vector<LiveTablet>& before = {});

/// Opens it through `transport`. If only the device itself knows its descriptor or ranges, reads them and recognises
/// the tablet again. Errors say what is missing.
[[nodiscard]] base::Result<std::unique_ptr<ReportSource>> open_tablet(LiveTablet& tablet,
                                                                      const decode::TabletTable* own = nullptr);

}  // namespace penpose::device
