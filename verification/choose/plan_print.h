#ifndef HEATLADDER_VERIFICATION_CHOOSE_PLAN_PRINT_H
#define HEATLADDER_VERIFICATION_CHOOSE_PLAN_PRINT_H

struct json;
struct plan;
struct request;

void plan_print_text(const struct request *r, const struct plan *plan);
void plan_print_json(const struct request *r, const struct plan *plan, struct json *j); /* into an open object */

#endif
