/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_COMMAND_CHECKS_H
#define HEATLADDER_VERIFICATION_COMMAND_CHECKS_H

/* Whether the options of a request go together.  Both: STATUS_OK, or STATUS_INPUT with *why filled. */

#include "verification/command/request.h"

/* All that the verb needs is given; before the scene is set up. */
int checks_required(const struct request *r, struct failure *why);

/* No option contradicts another or lacks one that it needs; once the scene is set up. */
int checks_together(const struct request *r, struct failure *why);

#endif
