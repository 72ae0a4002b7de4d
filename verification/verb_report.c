/* heatladder report: the papers' tables and figures, measured again. */
#include "verification/verb.h"

#include "verification/report.h"
#include "verification/request.h"

int verb_report(const struct request *r) {
    struct failure why;
    int status = report_write(r->topic ? r->topic : "reports/out", &why);
    if (status) fprintf(stderr, "heatladder: %s\n", why.text);
    return status;
}
