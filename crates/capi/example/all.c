/* All checks. */
#include "checks.h"
#include "parts.h"

static int same_text(const char *a, const char *b) {
  while (*a != '\0' && *a == *b) {
    a++;
    b++;
  }
  return *a == *b;
}

uint32_t program(void) {
  check(same_text(eigenshade_version(), EIGENSHADE_VERSION), "any", "version", 0);
  check(eigenshade_table() == EIGENSHADE_TABLE, "any", "table", 0);
  check_golden_vectors();
  check_faults();
  check_target_faults();
  check_object_faults();
  check_color();
  check_textured();
  check_shadowed();
  print_u32(found_faults());
  print(" faults\n");
  return found_faults();
}
