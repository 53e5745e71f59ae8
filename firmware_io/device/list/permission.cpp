#include "firmware_io/device/list/permission.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <spawn.h>
#include <string>
#include <string_view>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

#include "firmware_io/device/source/built_in.h"

namespace penpose::device {
namespace {

/// Make tablets and nothing that one types passwords on: Wacom, and Wacom's digitizers built into other makers'
/// devices.
constexpr std::array<std::uint16_t, 2> k_makers_of_tablets = {0x056a, 0x2d1f};

/// Digitizers with a pen that are built into notebooks and handhelds, of makers that build keyboards and touchpads as
/// well (github.com/linuxwacom/wacom-hid-descriptors, interfaces with a pen).
struct BuiltIn {
  std::uint16_t vendor;
  std::uint16_t product;
};
constexpr auto k_built_in = std::to_array<BuiltIn>({
    {0x03eb, 0x8abb}, {0x04f3, 0x2283}, {0x04f3, 0x23db}, {0x04f3, 0x241e}, {0x04f3, 0x24b8}, {0x04f3, 0x251c},
    {0x04f3, 0x2522}, {0x04f3, 0x2718}, {0x04f3, 0x29a1}, {0x04f3, 0x29b6}, {0x04f3, 0x2a70}, {0x04f3, 0x2ad8},
    {0x04f3, 0x2ad9}, {0x04f3, 0x2b5f}, {0x04f3, 0x2bb1}, {0x04f3, 0x2bd6}, {0x04f3, 0x2cf7}, {0x04f3, 0x2da1},
    {0x04f3, 0x2de2}, {0x04f3, 0x2fc2}, {0x04f3, 0x2fc4}, {0x04f3, 0x41eb}, {0x04f3, 0x42c3}, {0x0531, 0x0104},
    {0x0531, 0x0105}, {0x06cb, 0x125d}, {0x27c6, 0x0111}, {0x27c6, 0x0113}, {0x27c6, 0x0118}, {0x27c6, 0x011a},
    {0x27c6, 0x0e0d},
});

/// Where logind (or elogind) keeps the seats whose users `uaccess` lets in.
constexpr const char* k_seats = "/run/systemd/seats";
constexpr const char* k_group = "input";
constexpr const char* k_join = "sudo usermod -aG input $USER and log in again";

constexpr std::string_view k_head =
    R"(# Pen tablets for penpose: whoever sits at the machine may read them (uaccess), nobody else.
# Where nothing knows who sits there (no logind), the group "input" may.
# Made by `penpose devices --udev-rule`; goes to /etc/udev/rules.d.
ACTION=="remove", GOTO="penpose_end"
)";
constexpr std::string_view k_tail = "LABEL=\"penpose_end\"\n";
/// What the kernel makes of tablets, those that are on no bus of HID among them.
constexpr std::string_view k_event_devices = "SUBSYSTEM==\"input\", KERNEL==\"event*\", ENV{ID_INPUT_TABLET}==\"1\"";
/// What the rule calls a tablet.
constexpr const char* k_mark = "PENPOSE_TABLET";

std::string hex_digits(std::uint16_t id, const char* form) {
  std::array<char, 8> digits{};
  std::snprintf(digits.data(), digits.size(), form, id);
  return digits.data();
}

/// The alternatives for both kinds of node; no products means all.
void append_rules(std::string& rule, std::uint16_t vendor, const std::set<std::uint16_t>& products) {
  std::string parents;
  std::string ids;
  for (const std::uint16_t product : products) {
    if (!ids.empty()) {
      parents += '|';
      ids += '|';
    }
    parents += "*:" + hex_digits(vendor, "%04X") + ":" + hex_digits(product, "%04X") + ".*";
    ids += hex_digits(product, "%04x");
  }
  if (products.empty()) parents = "*:" + hex_digits(vendor, "%04X") + ":*";
  const std::string gives = std::string(", TAG+=\"uaccess\", ENV{") + k_mark + "}=\"1\"\n";
  rule += "SUBSYSTEM==\"hidraw\", KERNELS==\"" + parents + "\"" + gives;
  rule += "SUBSYSTEM==\"usb\", ENV{DEVTYPE}==\"usb_device\", ATTR{idVendor}==\"" + hex_digits(vendor, "%04x") + "\"";
  if (!products.empty()) rule += ", ATTR{idProduct}==\"" + ids + "\"";
  rule += gives;
}

bool rule_is_installed() {
  for (const char* folder : {k_rules_folder, "/run/udev/rules.d", "/usr/local/lib/udev/rules.d",
                             "/usr/lib/udev/rules.d", "/lib/udev/rules.d"}) {
    if (::access((std::string(folder) + "/" + k_rule_file).c_str(), F_OK) == 0) return true;
  }
  return false;
}

/// The number of a group of this machine. The C library's own look-up loads libraries, which a static program cannot.
std::optional<gid_t> number_of_group(std::string_view name) {
  std::ifstream file("/etc/group");
  for (std::string line; std::getline(file, line);) {
    // "input:x:104:someone,somebody"
    const std::size_t number = line.find(':', name.size() + 1) + 1;
    if (line.compare(0, name.size() + 1, std::string(name) + ':') != 0 || number == 0) continue;
    return static_cast<gid_t>(std::strtoul(line.c_str() + number, nullptr, 10));
  }
  return std::nullopt;
}

/// Whether this process has the rights of a group.
bool in_group(const char* name) {
  const auto wanted = number_of_group(name);
  if (!wanted) return false;
  std::vector<gid_t> groups(static_cast<std::size_t>(std::max(0, ::getgroups(0, nullptr))));
  const int count = ::getgroups(static_cast<int>(groups.size()), groups.data());
  groups.resize(static_cast<std::size_t>(std::max(0, count)));
  groups.push_back(::getegid());
  return std::find(groups.begin(), groups.end(), *wanted) != groups.end();
}

std::string denied(const LiveTablet& tablet, const std::string& program) {
  const bool event = tablet.transport == Transport::event;
  if (!rule_is_installed()) {
    return "You may not open it because no udev rule gives you access; run: sudo " + program +
           " devices --install-udev-rule" +
           (event && !in_group(k_group) ? ", or join the group " + std::string(k_group) + ": " + k_join : "");
  }
  if (::access(k_seats, F_OK) != 0) {
    if (!in_group(k_group)) {
      return "You may not open it because you are not in the group " + std::string(k_group) +
             ", which the udev rule lets in where there is no logind; run: " + k_join;
    }
  } else if (std::getenv("SSH_CONNECTION") != nullptr) {
    return "You may not open it because the udev rule gives access to whoever sits at the machine, not to a remote "
           "login; run: sudo setfacl -m u:$USER:rw " +
           tablet.node();
  }
  return "You may not open it although the udev rule is installed, which has not been applied to it yet; run: sudo "
         "udevadm trigger --action=add " +
         tablet.node();
}

bool run(std::array<const char*, 4> arguments) {
  pid_t process = 0;
  std::array<char*, 5> copy{};
  for (std::size_t i = 0; i < arguments.size(); ++i) copy[i] = const_cast<char*>(arguments[i]);
  if (::posix_spawnp(&process, copy[0], nullptr, nullptr, copy.data(), environ) != 0) return false;
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return false;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::string udev_rule(const decode::TabletTable& table, const std::vector<LiveTablet>& also) {
  std::map<std::uint16_t, std::set<std::uint16_t>> products;
  const auto add = [&](std::uint16_t vendor, std::uint16_t product) {
    const bool whole =
        std::find(k_makers_of_tablets.begin(), k_makers_of_tablets.end(), vendor) != k_makers_of_tablets.end();
    if (!whole) products[vendor].insert(product);
  };
  for (const decode::Tablet& tablet : table.tablets()) {
    for (const auto* list : {&tablet.identifiers, &tablet.pads}) {
      for (const decode::TabletIdentifier& identifier : *list) add(identifier.vendor, identifier.product);
    }
  }
  for (const LiveTablet& tablet : also) add(tablet.interface.identity.vendor, tablet.interface.identity.product);
  for (const BuiltIn& one : k_built_in) add(one.vendor, one.product);
  std::string rule(k_head);
  for (const std::uint16_t vendor : k_makers_of_tablets) append_rules(rule, vendor, {});
  for (const auto& [vendor, ids] : products) append_rules(rule, vendor, ids);
  rule += std::string(k_event_devices) + ", TAG+=\"uaccess\", ENV{" + k_mark + "}=\"1\"\n";
  rule +=
      std::string("ENV{") + k_mark + "}==\"1\", TEST!=\"" + k_seats + "\", GROUP=\"" + k_group + "\", MODE=\"0660\"\n";
  return rule += k_tail;
}

base::Status install_udev_rule(const std::string& folder, const std::string& rule) {
  const std::string path = folder + "/" + k_rule_file;
  if (folder.empty()) return base::Error{"the folder has no name", "--rules-folder", "name a folder"};
  const std::string temporary = path + ".new";
  const auto fail = [&](const char* what) {
    base::Error error{std::string(what) + " (" + std::generic_category().message(errno) + ")", path,
                      "run the command as root"};
    ::unlink(temporary.c_str());
    return error;
  };
  // Made anew and through no link: what was left there by a run that was killed, or by somebody else, goes.
  ::unlink(temporary.c_str());
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (file < 0) return fail("cannot be written");
  const bool written = ::write(file, rule.data(), rule.size()) == static_cast<ssize_t>(rule.size());
  if (::close(file) != 0 || !written) return fail("cannot be written");
  if (::rename(temporary.c_str(), path.c_str()) != 0) return fail("cannot be written");
  // Another folder is a packager's.
  if (folder != k_rules_folder) return base::Done{};
  const bool applied = run({"udevadm", "control", "--reload", nullptr}) &&
                       run({"udevadm", "trigger", "--action=add", "--subsystem-match=hidraw"}) &&
                       run({"udevadm", "trigger", "--action=add", "--subsystem-match=usb"}) &&
                       // Desktops take a device that is added for another one.
                       run({"udevadm", "trigger", "--action=change", "--subsystem-match=input"});
  if (!applied) {
    return base::Error{"is written, but udev could not be told", path, "plug the tablet in again, or restart"};
  }
  return base::Done{};
}

std::string missing(const LiveTablet& tablet, const std::string& program) {
  switch (tablet.access) {
    case Access::denied:
      return denied(tablet, program);
    case Access::busy:
      return "Another program has taken it from the system; close that program";
    case Access::absent:
      if (!reads_through(tablet.transport)) {
        return reads_through(Transport::hidraw)
                   ? "It is read through libusb alone, which this penpose was built without (PENPOSE_LIBUSB)"
                   : "This penpose was built to read no tablets (PENPOSE_DEVICES)";
      }
      return "The system has made no device node for it; in a container, start that with the host's /dev";
    case Access::allowed:
      break;
  }
  if (!tablet.strings_unread || (tablet.match && tablet.match->certain)) return {};
  return tablet.interface.usb_node.empty() ? std::string()
                                           : "Which model it is cannot be read from " + tablet.interface.usb_node +
                                                 "; run: sudo " + program + " devices --install-udev-rule";
}

}  // namespace penpose::device
