/* Between a machine (board.c, host.c) and what it runs (checks.c, costs.c, sizes.c). */
#ifndef PRINT_H
#define PRINT_H

#include "eigenshade.h"

/* Prints a text without a line end (board.c, host.c). */
void print(const char *text);

/* Prints a number (print.c). */
void print_u32(uint32_t number);

/* The program that the machine runs; returns the number of faults. */
uint32_t program(void);

#endif
