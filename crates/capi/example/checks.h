/* What every machine has to find: the golden vectors (checks.c), and what the library answers
 * to arguments at fault (faults.c). */
#ifndef CHECKS_H
#define CHECKS_H

#include "print.h"

/* The part of the checks that hands over arguments at fault. */
void checks_of_faults(void);

/* One check, named by format, function and number. */
void check(int holds, const char *format, const char *what, uint32_t number);

/* Whether a function answered what it should have. */
void check_status(eigenshade_status found, eigenshade_status expected, const char *format,
                  const char *what);

#endif
