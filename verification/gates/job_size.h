#ifndef HEATLADDER_VERIFICATION_GATES_JOB_SIZE_H
#define HEATLADDER_VERIFICATION_GATES_JOB_SIZE_H

struct request;

/* About how many particle updates a command takes, so that the heaviest can start first.  Nothing else depends on it.
 */
double job_size_of_request(const struct request *r);
double job_size_of_line(const char *command); /* 0 for a command that cannot be read */

#endif
