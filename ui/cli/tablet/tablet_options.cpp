#include "ui/cli/tablet/tablet_options.h"

namespace penpose::cli {

void add_tablet_options(const Command& command, files::OwnTablets& own) {
  command.add_option(files::k_tablets_option, own.file,
                     "A file of your own tablets, or a configuration of OpenTabletDriver; goes before the known ones");
  command.add_option(files::k_tablet_option, own.name,
                     "The tablet that is meant, by its name, where others have the same ids");
}

}  // namespace penpose::cli
