#include "firmware_io/device/list/permission.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <map>
#include <set>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace penpose::device {
namespace {

/// Makes tablets and nothing that one types passwords on.
constexpr std::uint16_t k_wacom = 0x056a;

constexpr std::string_view k_head =
    R"(# Pen tablets for penpose: whoever sits at the machine may read them (uaccess), nobody else.
# Made by `penpose devices --udev-rule`; goes to /etc/udev/rules.d.
ACTION=="remove", GOTO="penpose_end"
)";
constexpr std::string_view k_tail = "LABEL=\"penpose_end\"\n";

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
  rule += "SUBSYSTEM==\"hidraw\", KERNELS==\"" + parents + "\", TAG+=\"uaccess\"\n";
  rule += "SUBSYSTEM==\"usb\", ENV{DEVTYPE}==\"usb_device\", ATTR{idVendor}==\"" + hex_digits(vendor, "%04x") + "\"";
  if (!products.empty()) rule += ", ATTR{idProduct}==\"" + ids + "\"";
  rule += ", TAG+=\"uaccess\"\n";
}

bool rule_is_installed() {
  for (const char* folder : {k_rules_folder, "/run/udev/rules.d", "/usr/local/lib/udev/rules.d",
                             "/usr/lib/udev/rules.d", "/lib/udev/rules.d"}) {
    if (::access((std::string(folder) + "/" + k_rule_file).c_str(), F_OK) == 0) return true;
  }
  return false;
}

std::string denied(const LiveTablet& tablet, const std::string& program) {
  if (!rule_is_installed()) {
    return "You may not open it because no udev rule gives you access; run: sudo " + program +
           " devices --install-udev-rule";
  }
  if (std::getenv("SSH_CONNECTION") != nullptr) {
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
    if (vendor != k_wacom) products[vendor].insert(product);
  };
  for (const decode::Tablet& tablet : table.tablets()) {
    for (const auto* list : {&tablet.identifiers, &tablet.pads}) {
      for (const decode::TabletIdentifier& identifier : *list) add(identifier.vendor, identifier.product);
    }
  }
  for (const LiveTablet& tablet : also) add(tablet.interface.identity.vendor, tablet.interface.identity.product);
  std::string rule(k_head);
  append_rules(rule, k_wacom, {});
  for (const auto& [vendor, ids] : products) append_rules(rule, vendor, ids);
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
                       run({"udevadm", "trigger", "--action=add", "--subsystem-match=usb"});
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
