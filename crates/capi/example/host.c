/* A host. */
#include "say.h"

#include <stdio.h>

void say(const char *text) { fputs(text, stdout); }

int main(void) { return program() == 0 ? 0 : 1; }
