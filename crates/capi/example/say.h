/* Between a machine (board.c, host.c) and what it runs (checks.c, costs.c, sizes.c). */
#ifndef SAY_H
#define SAY_H

#include "eigenshade.h"

/* The machine's voice: part of a line, without an end of its own. */
void say(const char *text);

/* The same of a number (say.c). */
void say_number(uint32_t number);

/* What the machine runs: gives the number of faults. */
uint32_t program(void);

#endif
