#ifndef HEATLADDER_VERIFICATION_CHOOSE_PLAN_PRINT_H
#define HEATLADDER_VERIFICATION_CHOOSE_PLAN_PRINT_H

struct json;
struct plan;
struct experiment;

void plan_print_text(const struct experiment *e, const struct plan *plan);
void plan_print_json(const struct experiment *e, const struct plan *plan, struct json *j); /* into an open object */

#endif
