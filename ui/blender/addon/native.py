"""Where the C library of the add-on is loaded from: a copy in a folder of the user that is named by version and hash. Blender replaces the
add-on's own files while they are in use: on Linux what is mapped would change under a running program, on Windows they could not be replaced.
"""
import os
import platform
import shutil

from . import versions

# By system and machine: folder in library/, named by version and hash, and file. Written as the add-on is packed.
LIBRARIES = {}
_MACHINES = {'amd64': 'x64', 'x86_64': 'x64', 'aarch64': 'arm64', 'arm64': 'arm64'}


def system():
    """This system and machine as Blender's manifest calls them."""
    name = {'Darwin': 'macos'}.get(platform.system(), platform.system().lower())
    machine = platform.machine().lower()
    return '%s-%s' % (name, _MACHINES.get(machine, machine))


def path():
    """The path of the library, copied where there is none yet. Raises ImportError where the add-on has none for this system."""
    if system() not in LIBRARIES:
        raise ImportError('this zip of penpose has no library for %s, only for %s; install the zip of your system' % (
            system(), ', '.join(sorted(LIBRARIES)) or 'none'))
    folder, name = LIBRARIES[system()]
    packed = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'library', folder, name)
    try:
        copied = os.path.join(versions.own_folder(__package__), folder, name)
        if not os.path.exists(copied) or os.path.getsize(copied) != os.path.getsize(packed):
            os.makedirs(os.path.dirname(copied), exist_ok=True)
            beside = '%s.%d' % (copied, os.getpid())
            shutil.copyfile(packed, beside)
            os.replace(beside, copied)  # two that start at once may both do it
        return copied
    except OSError:
        return packed  # nothing can be written: nobody replaces it either


def clear(keep=False):
    """Removes the copies, but those that Windows still has in use; `keep`: those of other versions alone."""
    folder = versions.own_folder(__package__)
    if not keep:
        shutil.rmtree(folder, ignore_errors=True)
        return
    for name in os.listdir(folder) if os.path.isdir(folder) else ():
        if name != LIBRARIES[system()][0]:
            shutil.rmtree(os.path.join(folder, name), ignore_errors=True)
