/* fault.h -- calls that run out of memory at every allocation they make, one after the other.
 *
 * A test describes a call by two functions and hands them to fault_loop, which repeats the call
 * with the 1st, 2nd, 3rd ... allocation failing, until it gets through. Each time it must return
 * TAUT_NO_MEMORY, say so in *error if it takes one, leave its output as it was, and leak nothing.
 */
#ifndef TAUT_TEST_FAULT_H
#define TAUT_TEST_FAULT_H

#include "taut/status.h"

#include <stddef.h>

typedef struct fault_call {
    const char *name;
    /* Makes the call: output from *result to *result, through a variable of its own type. */
    taut_status (*call)(const void *context, void **result, taut_error *error);
    /* Frees a result that was made; may be NULL. */
    void (*release)(void *result);
    const void *context; /* what `call` works on */
} fault_call;

/* Returns the number of allocations of the call that got through, each of which was failed once
 * alone and once with all that follow. Failures are CHECKs (check.h). */
long fault_loop(const fault_call *call);

/* The same for a call that takes long: at most so many of its allocations are failed, spread over
 * all of them from a random first one on (check.h's seed). */
long fault_loop_some(const fault_call *call, int most);

/* The first `count` allocations of a call that makes more, and would take long to get through. */
void fault_loop_first(const fault_call *call, long count);

/* Describes the call and loops; it makes so many allocations at least. */
void fault_check(const char *name, taut_status (*call)(const void *, void **, taut_error *),
                 void (*release)(void *), const void *context, long least);

/* Since fault_arm(k) with k > 0: the allocations, the refused one among them, and the bytes
 * granted, where a block that is resized counts whole, as it may have been copied. */
long fault_counted(void);
size_t fault_bytes(void);

/* For calls that do not fit. The k-th allocation from now fails, alone or with all later ones; 0
 * stops that and gives how many were refused. */
void fault_arm(long k, int and_later);
long fault_disarm(void);
long fault_live(void); /* blocks taken and not yet freed */

#endif /* TAUT_TEST_FAULT_H */
