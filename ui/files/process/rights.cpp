#include "ui/files/process/rights.h"

#include <cstdint>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace penpose::files {
namespace {

// Later than the headers of Debian 12: the third version of Landlock knows it.
constexpr std::uint64_t k_truncate = std::uint64_t{1} << 14;

constexpr std::uint64_t k_writing = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                                    LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                                    LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                                    LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                                    LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

}  // namespace

bool keep_only(Rights rights) {
  if (rights == Rights::all) return true;
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return false;
  // Rights that are handled and granted to no folder are gone.
  struct landlock_ruleset_attr handled {};
  handled.handled_access_fs = LANDLOCK_ACCESS_FS_EXECUTE;
  if (rights == Rights::reads_only) handled.handled_access_fs |= k_writing | (version >= 3 ? k_truncate : 0);
  const auto rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
  if (rules < 0) return false;
  const bool given_up =
      ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && ::syscall(SYS_landlock_restrict_self, rules, 0) == 0;
  ::close(rules);
  return given_up;
}

}  // namespace penpose::files
