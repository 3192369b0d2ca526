/* One check after the other (checks.c). */
#ifndef CHECKS_H
#define CHECKS_H

#include "print.h"

/* One check, named by format, function and number. */
void check(int holds, const char *format, const char *what, uint32_t number);

/* Whether a function answered what it should have. */
void check_status(eigenshade_status found, eigenshade_status expected, const char *format,
                  const char *what);

/* Checks the status of a call; `name` in scope is the format. */
#define EXPECTED(expected, call)                                                              \
  check_status(call, EIGENSHADE_STATUS_##expected, name, #call " is not " #expected)

/* Checks the status of a call that succeeds. */
#define CHECKED(call) check_status(call, EIGENSHADE_STATUS_OK, name, #call)

/* Prints FNV-1a of a picture's bytes. */
void print_checksum(const char *picture, const void *pixels, size_t length);

/* Checks that a picture in float is the one in integers to one level of a channel, and prints the
 * checksum of the latter. */
void check_picture(const char *picture, const uint16_t of_f32[], const uint16_t of_q15[],
                   size_t length);

/* Sets all bytes. */
void fill(void *memory, size_t size, unsigned char byte);

/* A pointer that is not aligned. */
#define BESIDE(pointer) ((void *)((char *)(pointer) + 1))

/* The number of checks that failed. */
uint32_t found_faults(void);

#endif
