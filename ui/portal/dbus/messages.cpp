#include "ui/portal/dbus/messages.h"

#include <algorithm>

#include "core/base/text/letters.h"
#include "core/base/text/utf8.h"

namespace penpose::portal {
namespace {

/// Writes a part of a message into a container of its own.
template <typename Write>
void within(DBusMessageIter& outer, int kind, const char* signature, const Write& write) {
  DBusMessageIter inner;
  if (dbus_message_iter_open_container(&outer, kind, signature, &inner) == 0) return;
  write(inner);
  dbus_message_iter_close_container(&outer, &inner);
}

/// D-Bus takes valid UTF-8 alone.
void add_text(DBusMessageIter& to, const std::string& text) {
  const std::string valid = base::valid_utf8(text);
  const char* start = valid.c_str();
  dbus_message_iter_append_basic(&to, DBUS_TYPE_STRING, static_cast<const void*>(&start));
}

template <typename Write>
void add_option(DBusMessageIter& options, const char* name, const char* signature, const Write& write) {
  within(options, DBUS_TYPE_DICT_ENTRY, nullptr, [&](DBusMessageIter& entry) {
    add_text(entry, name);
    within(entry, DBUS_TYPE_VARIANT, signature, write);
  });
}

void add_text_option(DBusMessageIter& options, const char* name, const std::string& text) {
  add_option(options, name, "s", [&](DBusMessageIter& value) { add_text(value, text); });
}

/// A path as it is, in bytes, with a zero behind it.
void add_path_option(DBusMessageIter& options, const char* name, const std::string& path) {
  add_option(options, name, "ay", [&](DBusMessageIter& value) {
    within(value, DBUS_TYPE_ARRAY, "y", [&](DBusMessageIter& bytes) {
      const char* start = path.c_str();
      dbus_message_iter_append_fixed_array(&bytes, DBUS_TYPE_BYTE, static_cast<const void*>(&start),
                                           static_cast<int>(path.size() + 1));
    });
  });
}

/// "*.[gG][lL][bB]": patterns tell upper from lower case.
std::string pattern_of(const std::string& extension) {
  std::string pattern = "*";
  for (const char c : extension) {
    if (base::lower(c) == base::upper(c)) {
      pattern += c;
    } else {
      pattern += {'[', base::lower(c), base::upper(c), ']'};
    }
  }
  return pattern;
}

void add_filters(DBusMessageIter& options, const std::vector<FileFilter>& filters) {
  add_option(options, "filters", "a(sa(us))", [&](DBusMessageIter& value) {
    within(value, DBUS_TYPE_ARRAY, "(sa(us))", [&](DBusMessageIter& list) {
      for (const FileFilter& filter : filters) {
        within(list, DBUS_TYPE_STRUCT, nullptr, [&](DBusMessageIter& one) {
          add_text(one, filter.label);
          within(one, DBUS_TYPE_ARRAY, "(us)", [&](DBusMessageIter& patterns) {
            const auto add = [&](const std::string& pattern) {
              within(patterns, DBUS_TYPE_STRUCT, nullptr, [&](DBusMessageIter& pair) {
                const dbus_uint32_t glob = 0;
                dbus_message_iter_append_basic(&pair, DBUS_TYPE_UINT32, &glob);
                add_text(pair, pattern);
              });
            };
            for (const std::string& extension : filter.extensions) add(pattern_of(extension));
            if (filter.extensions.empty()) add("*");
          });
        });
      }
    });
  });
}

/// The first text of a list of texts in a variant; empty where it is none.
std::string first_text(DBusMessageIter& variant) {
  DBusMessageIter list;
  dbus_message_iter_recurse(&variant, &list);
  if (dbus_message_iter_get_arg_type(&list) != DBUS_TYPE_ARRAY) return {};
  DBusMessageIter text;
  dbus_message_iter_recurse(&list, &text);
  if (dbus_message_iter_get_arg_type(&text) != DBUS_TYPE_STRING) return {};
  const char* start = nullptr;
  dbus_message_iter_get_basic(&text, static_cast<void*>(&start));
  return start;
}

}  // namespace

Message call_of(const FileQuestion& question, const std::string& token) {
  Message call(dbus_message_new_method_call(k_service, "/org/freedesktop/portal/desktop",
                                            "org.freedesktop.portal.FileChooser",
                                            question.saves ? "SaveFile" : "OpenFile"));
  if (!call) return call;
  DBusMessageIter arguments;
  dbus_message_iter_init_append(call.get(), &arguments);
  add_text(arguments, question.parent);
  add_text(arguments, question.title);
  within(arguments, DBUS_TYPE_ARRAY, "{sv}", [&](DBusMessageIter& options) {
    add_text_option(options, "handle_token", token);
    if (!question.folder.empty()) add_path_option(options, "current_folder", question.folder);
    if (question.saves) add_text_option(options, "current_name", question.name);
    if (!question.filters.empty()) add_filters(options, question.filters);
  });
  return call;
}

std::string request_path(const std::string& connection, const std::string& token) {
  std::string sender = connection.substr(connection.starts_with(':') ? 1 : 0);
  std::replace(sender.begin(), sender.end(), '.', '_');
  return "/org/freedesktop/portal/desktop/request/" + sender + "/" + token;
}

FileAnswer answer_of(DBusMessage* response) {
  constexpr dbus_uint32_t k_chosen = 0;
  constexpr dbus_uint32_t k_cancelled = 1;
  DBusMessageIter arguments;
  if (dbus_message_has_signature(response, "ua{sv}") == 0 || dbus_message_iter_init(response, &arguments) == 0)
    return {FileAnswer::Kind::unavailable, {}};
  dbus_uint32_t code = 2;
  dbus_message_iter_get_basic(&arguments, &code);
  if (code == k_cancelled) return {FileAnswer::Kind::cancelled, {}};
  dbus_message_iter_next(&arguments);
  DBusMessageIter entry;
  dbus_message_iter_recurse(&arguments, &entry);
  std::string path;
  for (; code == k_chosen && dbus_message_iter_get_arg_type(&entry) == DBUS_TYPE_DICT_ENTRY;
       dbus_message_iter_next(&entry)) {
    DBusMessageIter pair;
    dbus_message_iter_recurse(&entry, &pair);
    const char* name = nullptr;
    dbus_message_iter_get_basic(&pair, static_cast<void*>(&name));
    dbus_message_iter_next(&pair);
    if (std::string_view(name) == "uris") path = path_of_address(first_text(pair));
  }
  if (path.empty()) return {FileAnswer::Kind::unavailable, {}};
  return {FileAnswer::Kind::chosen, path};
}

}  // namespace penpose::portal
