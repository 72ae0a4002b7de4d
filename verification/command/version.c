/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The version, as the Makefile tells it. */
#include "verification/command/version.h"

#include "version.inc"

const char version_text[] = VERSION_TEXT;
