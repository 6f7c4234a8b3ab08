/* Common macros of the tests in this folder. */

#ifndef CHECK_H
#define CHECK_H

#include <stdio.h>

#include <stickslip.h>

static int failures = 0;

#define CHECK(condition)                                                                                               \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            fprintf(stderr, "line %d: %s (last error: %s)\n", __LINE__, #condition, stickslip_last_error_message());   \
            failures++;                                                                                                \
        }                                                                                                              \
    } while (0)
#define OK(call) CHECK((call) == STICKSLIP_OK)
/* Requires a relative error of at most part. */
#define CLOSE(found, expected, part) CHECK(fabs((found) - (expected)) <= (part) * fabs(expected))

static int report(const char *what) {
    printf("%s: %s\n", what, failures == 0 ? "kept" : "broken");
    return failures == 0 ? 0 : 1;
}

#endif
