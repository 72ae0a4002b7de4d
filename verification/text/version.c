/* The version, as the Makefile tells it. */
#include "verification/text/version.h"

#include "version.inc"

const char version_text[] = VERSION_TEXT;
