/* The list of methods. */
#include "solver/method.h"

#define METHOD(name) extern const struct method method_##name;
#include "solver/methods.def"
#undef METHOD

#define METHOD(name) &method_##name,
const struct method *const methods[] = {
#include "solver/methods.def"
    NULL};
#undef METHOD
