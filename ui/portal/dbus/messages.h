#pragma once

#include <dbus/dbus.h>
#include <memory>
#include <string>

#include "ui/portal/portal.h"

// What is said to org.freedesktop.portal.FileChooser and what it says, as D-Bus messages.

namespace penpose::portal {

inline constexpr const char* k_service = "org.freedesktop.portal.Desktop";

struct Unref {
  void operator()(DBusMessage* message) const { dbus_message_unref(message); }
};
using Message = std::unique_ptr<DBusMessage, Unref>;

/// The call of OpenFile or SaveFile; null: there is no memory. `token`: letters and digits that name the request.
[[nodiscard]] Message call_of(const FileQuestion& question, const std::string& token);
/// The object that stands for the request by the name of the connection, which its signal comes from.
[[nodiscard]] std::string request_path(const std::string& connection, const std::string& token);
/// What the signal Response says.
[[nodiscard]] FileAnswer answer_of(DBusMessage* response);

}  // namespace penpose::portal
