#pragma once

#include <string>

#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::cli {

/// Prints the tablets that are plugged in, how each is read and what is missing to open it. Returns the exit status.
int list_live_devices(const decode::TabletTable& own, bool json);

/// Prints the udev rule for the known tablets, the user's own and what is plugged in.
int print_udev_rule(const decode::TabletTable& own);
/// Writes it where udev looks and applies it; needs root.
int install_udev_rule(const decode::TabletTable& own, const std::string& folder);

/// Binds the kernel's drivers to interfaces of tablets that have none, as after a crash.
int give_back_devices();

}  // namespace penpose::cli
