"""Debian's kernel without its own compression, which an emulated processor needs three seconds to undo.

QEMU starts a plain ELF kernel too, but puts it back into memory whenever the machine wakes up from a sleep. So this makes
an image of the ordinary form ("bzImage") whose part for protected mode lies in memory as the kernel itself does when it is
unpacked, behind a few instructions that go to 64-bit mode, which is what the kernel's first one expects. Form: the kernel's
own documentation, x86/boot."""
import lzma
import os
import struct

BASE = 0x100000  # where the part for protected mode is put
PAGES = BASE + 0x1000  # page tables behind the first instructions
FIRST = 0x1000000  # where the kernel itself begins
PT_LOAD = 1


def segments(elf):
    """[(physical address, content), ...] of a 64-bit ELF file, and where it begins to run."""
    entry, table = struct.unpack_from('<QQ', elf, 24)
    size, count = struct.unpack_from('<HH', elf, 54)
    found = []
    for i in range(count):
        kind, _, offset, _, physical, length, in_memory, _ = struct.unpack_from('<IIQQQQQQ', elf, table + i * size)
        if kind == PT_LOAD:
            found.append((physical, elf[offset:offset + length], in_memory))
    return found, entry


def start_code(entry):
    """32-bit: descriptors, page tables, long mode, then a jump to the kernel; esi keeps what the boot loader put there."""
    descriptors = BASE + 0x200
    code = b'\xfa\x89\xf6'                                         # cli; mov esi, esi
    code += b'\x0f\x01\x15' + struct.pack('<I', descriptors)       # lgdt
    code += b'\xb8\xa0\x00\x00\x00\x0f\x22\xe0'                    # cr4 = PAE | PGE
    code += b'\xb8' + struct.pack('<I', PAGES) + b'\x0f\x22\xd8'   # cr3
    code += b'\xb9\x80\x00\x00\xc0\x0f\x32\x0d\x00\x01\x00\x00\x0f\x30'  # EFER.LME
    code += b'\xb8\x01\x00\x00\x80\x0f\x22\xc0'                    # cr0 = PG | PE
    code += b'\xea' + struct.pack('<IH', BASE + len(code) + 7, 0x10)  # jump into the 64-bit segment, right behind
    code += b'\xb8' + struct.pack('<I', entry) + b'\xff\xe0'       # jmp entry
    table = struct.pack('<HIxx', 31, descriptors + 8)
    table += struct.pack('<QQQQ', 0, 0, 0x00af9a000000ffff, 0x00cf92000000ffff)
    code = code.ljust(0x200, b'\0') + table
    # The first 4 GiB, each address itself, in pages of 1 GiB.
    top = struct.pack('<Q', (PAGES + 0x1000) | 3).ljust(0x1000, b'\0')
    pages = b''.join(struct.pack('<Q', i << 30 | 0x83) for i in range(4))
    return code.ljust(0x1000, b'\0') + top + pages


def flat(packed):
    """The image, or nothing where the kernel is packed in another way."""
    setup = 512 * ((packed[0x1f1] or 4) + 1)
    begin, length = struct.unpack_from('<II', packed, 0x248)  # payload_offset, payload_length
    try:
        elf = lzma.LZMADecompressor(format=lzma.FORMAT_XZ).decompress(packed[setup + begin:setup + begin + length])
    except lzma.LZMAError:
        return None
    parts, entry = segments(elf)
    if elf[:4] != b'\x7fELF' or min(physical for physical, _, _ in parts) < FIRST:
        return None
    image = bytearray(start_code(entry & 0xffffffff))
    for physical, content, _ in parts:
        image.extend(bytes(max(0, physical - BASE - len(image))))
        image[physical - BASE:physical - BASE + len(content)] = content
    image = image.rstrip(b'\0')  # memory is empty at first
    head = bytearray(packed[:setup])
    struct.pack_into('<I', head, 0x1f4, (len(image) + 15) // 16)  # syssize
    struct.pack_into('<I', head, 0x260, max(p + m for p, _, m in parts) - FIRST)  # init_size
    return bytes(head) + bytes(image)


def unpacked(image, folder):
    """The path of such an image, made once; that of the kernel as it is where none can be made."""
    target = os.path.join(folder, os.path.basename(image) + '.flat')
    if not os.path.exists(target) or os.stat(target).st_mtime < os.stat(image).st_mtime:
        with open(image, 'rb') as f:
            made = flat(f.read())
        if made is None:
            return image
        with open(target + '.new', 'wb') as f:
            f.write(made)
        os.replace(target + '.new', target)
    return target
