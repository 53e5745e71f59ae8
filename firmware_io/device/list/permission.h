#pragma once

#include <string>

#include "core/base/result.h"
#include "firmware_io/decode/table/tablet_table.h"
#include "firmware_io/device/live_tablet.h"

namespace penpose::device {

/// The udev rule that gives the user at the machine, and nobody else (`uaccess`), access to the tablets of the table.
/// For vendors that also build other devices it names the products, so that no keyboard becomes readable. `also` adds
/// connected tablets that are not in the table.
[[nodiscard]] std::string udev_rule(const decode::TabletTable& table, const std::vector<LiveTablet>& also = {});

/// Its name and folder. The text for the known tablets is next to this file, for packagers. The number is below 73,
/// where systemd grants access.
inline constexpr const char* k_rule_file = "70-penpose.rules";
inline constexpr const char* k_rules_folder = "/etc/udev/rules.d";

/// Writes the rule into a folder and, if that is k_rules_folder, makes udev apply it to connected devices. Errors: not
/// permitted; udev does not apply it, in which case plugging in again or a restart helps.
[[nodiscard]] base::Status install_udev_rule(const std::string& folder, const std::string& rule);

/// Why a tablet cannot be opened and the command that fixes it, in one sentence; empty if it can. `program`: how to
/// call this program as root.
[[nodiscard]] std::string missing(const LiveTablet& tablet, const std::string& program);

}  // namespace penpose::device
