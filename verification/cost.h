#ifndef HEATLADDER_VERIFICATION_COST_H
#define HEATLADDER_VERIFICATION_COST_H

struct request;

/* About how many particle updates a command takes, so that the heaviest can start first.  Nothing else depends on it.
 */
double cost_of_request(const struct request *r);
double cost_of_line(const char *command); /* 0 for a command that cannot be read */

#endif
