"""Which channels a keying set of Blender keys for what moved, and with which of the rules of keyframes."""
from typing import NamedTuple

import bpy

from . import versions

NEEDED, VISUAL, COLORS = 'INSERTKEY_NEEDED', 'INSERTKEY_VISUAL', 'INSERTKEY_XYZ_TO_RGB'


class Channel(NamedTuple):
    """Where a keyframe goes: a data-block, a path in it, a component (-1: all) and the group of a new curve.

    `options`: rules that hold for it alone, else None."""
    owner: bpy.types.ID
    path: str
    index: int = -1
    group: str = ''
    options: frozenset = None


def channel(block, path, index=-1, group=''):
    """The channel of a property of a block that need not be a data-block itself."""
    owner = block.id_data
    head = '' if block == owner else block.path_from_id()
    return Channel(owner, head + path if not head or path.startswith('[') else '%s.%s' % (head, path), index, group)


def rules_of(holder, options):
    """The rules where a keying set or one of its paths has its own."""
    own = versions.own_rules(holder)
    return frozenset({*(o for o in options if o not in own), *(o for o, on in own.items() if on)})


class _Collector:
    """Takes the place of a keying set while its own code says what it holds."""

    def __init__(self):
        self.paths, self.found = self, []

    def add(self, target_id, data_path, index=-1, group_method='KEYINGSET', group_name='', **_):
        self.found.append((target_id, data_path, index, group_name if group_method == 'NAMED' else ''))


def _generated(keying_set, context, block):
    """What a set that looks at a bone or an object holds of a block: [(data-block, path, index, group)]."""
    info, collector = keying_set.type_info, _Collector()
    try:
        type(info).generate(info, context, collector, block)
    except (AttributeError, TypeError, ValueError, KeyError):
        return []  # it is for bones or objects, and this is another block
    return [one for one in collector.found if _is_there(one[0], one[1])]


def _is_there(owner, path):
    try:
        owner.path_resolve(path)
    except ValueError:
        return False
    return True


def chosen(keying_set, moved, options, context):
    """The channels of a set for what moved: [(block, Channel)]. Of a set of fixed paths those that moved; of one that is made as it is
    used (Location, Whole Character), all that it holds of the moved bones."""
    out = []
    for block, one in moved:
        if keying_set.type_info is not None:
            for owner, path, index, group in _generated(keying_set, context, block):
                if block != owner or path == one.path:
                    # What of a data-block moved is one property, not all that is animated on it.
                    out.append(Channel(owner, path, index, group or one.group, rules_of(keying_set, options)))
            continue
        for path in keying_set.paths:
            if path.id != one.owner or not _covers(path, one):
                continue
            index = one.index if path.use_entire_array or path.data_path != one.path else path.array_index
            group = {'NAMED': path.group, 'KEYINGSET': keying_set.bl_label}.get(path.group_method, '')
            out.append(one._replace(index=index, group=group, options=rules_of(path, rules_of(keying_set, options))))
    return out


def _covers(path, one):
    """Whether a path of a set names a channel, one component of it, or a block that it belongs to."""
    if path.data_path == one.path:
        return path.use_entire_array or one.index in (-1, path.array_index)
    return one.path.startswith((path.data_path + '.', path.data_path + '['))
