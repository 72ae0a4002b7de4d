/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_COMMAND_VERSION_H
#define HEATLADDER_VERIFICATION_COMMAND_VERSION_H

/* "1.0.0 (commit)": the release, and in a checkout the commit, with + where files differ from it. */
extern const char version_text[];

#endif
