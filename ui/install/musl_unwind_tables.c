/* Where the tables that exceptions are unwound by lie. GCC 12's libgcc_eh, as Debian builds it, asks glibc with _dl_find_object,
   which musl does not have; the program header tells the same. */
#define _GNU_SOURCE
#include <link.h>
#include <stddef.h>
#include <stdint.h>

/* As in glibc's <dlfcn.h>; its manual, "Dynamic Linker Introspection". */
struct dl_find_object {
  uint64_t flags;
  void *map_start, *map_end;
  struct link_map *link_map;
  void *eh_frame;
  uint64_t reserved[7];
};

struct query {
  uintptr_t address;
  struct dl_find_object *answer;
};

static int look(struct dl_phdr_info *info, size_t size, void *data) {
  (void)size;
  const struct query *query = data;
  void *tables = NULL, *start = NULL, *end = NULL;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr) *part = &info->dlpi_phdr[i];
    const uintptr_t at = info->dlpi_addr + part->p_vaddr;
    if (part->p_type == PT_LOAD && query->address >= at && query->address - at < part->p_memsz) {
      start = (void *)at;
      end = (void *)(at + part->p_memsz);
    }
    if (part->p_type == PT_GNU_EH_FRAME) tables = (void *)at;
  }
  if (!start || !tables) return 0;
  *query->answer = (struct dl_find_object){.map_start = start, .map_end = end, .eh_frame = tables};
  return 1;
}

int _dl_find_object(void *address, struct dl_find_object *answer) {
  struct query query = {(uintptr_t)address, answer};
  return dl_iterate_phdr(look, &query) == 1 ? 0 : -1;
}
