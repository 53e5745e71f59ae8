#pragma once

#include <string>

#include "core/base/result.h"
#include "firmware_io/decode/table/tablet_table.h"
#include "firmware_io/device/live_tablet.h"

namespace penpose::device {

/// The udev rule that gives whoever sits at the machine access to the tablets of the table (and to nobody else:
/// `uaccess`). Of makers that build other devices too it names the products, so that no keyboard becomes readable.
/// `also` adds tablets that are plugged in and not in the table.
[[nodiscard]] std::string udev_rule(const decode::TabletTable& table, const std::vector<LiveTablet>& also = {});

/// Its name and place. For the known tablets the text lies beside this file, for packagers. A number below 73, where
/// systemd gives out access.
inline constexpr const char* k_rule_file = "70-penpose.rules";
inline constexpr const char* k_rules_folder = "/etc/udev/rules.d";

/// Writes the rule into a folder and, where that is k_rules_folder, has udev apply it to what is plugged in. Errors:
/// not permitted; udev does not take it, which plugging in again or a restart mends.
[[nodiscard]] base::Status install_udev_rule(const std::string& folder, const std::string& rule);

/// What keeps a tablet from being opened and the command that mends it, in one sentence; empty where nothing does.
/// `program`: how to call this program as root.
[[nodiscard]] std::string missing(const LiveTablet& tablet, const std::string& program);

}  // namespace penpose::device
