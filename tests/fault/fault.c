#include "fault.h"

#include "check.h"
#include "core/memory.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

enum { ALLOCATIONS_MAX = 200000 }; /* a call that takes more is taken to hang */

static long injected; /* failures so far */

static void tell(void)
{
    printf("%ld faults injected\n", injected);
}

/* One attempt with allocation k failing; the status it returned. */
static taut_status attempt(const fault_call *call, long k, int and_later)
{
    static char nothing; /* what the output is before */
    void *result = &nothing;
    taut_error error = {.status = TAUT_OK, .message = ""};
    const long before = fault_live();
    taut_status status = TAUT_OK;
    long refused = 0;

    if (injected++ == 0) {
        atexit(tell);
    }
    fault_arm(k, and_later);
    status = call->call(call->context, &result, &error);
    refused = fault_disarm();
    if (status == TAUT_OK) {
        CHECK(refused == 0, "%s: allocation %ld failed and nobody noticed", call->name, k);
        if (call->release != NULL) {
            call->release(result);
        }
    } else {
        CHECK(status == TAUT_NO_MEMORY, "%s: allocation %ld gave status %d", call->name, k,
              (int)status);
        CHECK(refused > 0, "%s: fails without a failed allocation (%ld)", call->name, k);
        CHECK(result == &nothing, "%s: allocation %ld: the output was touched", call->name, k);
        CHECK(error.status == TAUT_OK || (error.status == TAUT_NO_MEMORY && error.message[0] != 0),
              "%s: allocation %ld: error says status %d, \"%s\"", call->name, k, (int)error.status,
              error.message);
    }
    CHECK(fault_live() == before, "%s: allocation %ld: %ld blocks leaked", call->name, k,
          fault_live() - before);
    return status;
}

long fault_loop(const fault_call *call)
{
    long allocations = 0;
    for (int and_later = 0; and_later < 2; and_later++) {
        const int failures_before = check_failures;
        long k = 1;
        while (k < ALLOCATIONS_MAX && check_failures == failures_before &&
               attempt(call, k, and_later) != TAUT_OK) {
            /* where a sanitizer watches, a sample of those beyond the first hundred */
            k += k > 100 && random_trials(4) < 4 ? 1 + k / 10 : 1;
        }
        CHECK(k < ALLOCATIONS_MAX, "%s: never gets through", call->name);
        allocations = k - 1;
    }
    return allocations;
}

void fault_check(const char *name, taut_status (*call)(const void *, void **, taut_error *),
                 void (*release)(void *), const void *context, long least)
{
    const fault_call described = {name, call, release, context};
    const long allocations = fault_loop(&described);
    CHECK(allocations >= least, "%s: only %ld allocations", name, allocations);
}

void fault_loop_first(const fault_call *call, long count)
{
    const int failures_before = check_failures;
    for (long k = 1; k <= count && check_failures == failures_before; k++) {
        const taut_status status = attempt(call, k, k % 2 == 0);
        CHECK(status != TAUT_OK, "%s: allocation %ld of %ld is not made", call->name, k, count);
    }
}

/* How many allocations the call makes when none fails. */
static long count_allocations(const fault_call *call)
{
    void *result = NULL;
    taut_error error = {.status = TAUT_OK, .message = ""};
    long count = 0;
    fault_arm(LONG_MAX, 0);
    const taut_status status = call->call(call->context, &result, &error);
    count = fault_counted();
    fault_disarm();
    CHECK(status == TAUT_OK, "%s: status %d, %s", call->name, (int)status, error.message);
    if (status == TAUT_OK && call->release != NULL) {
        call->release(result);
    }
    return count;
}

long fault_loop_some(const fault_call *call, int most)
{
    const long count = count_allocations(call);
    const long stride = count > most ? count / most + 1 : 1;
    const int failures_before = check_failures;
    for (long k = random_int(1, (int)stride); k <= count && check_failures == failures_before;
         k += stride) {
        const taut_status status = attempt(call, k, (int)(random_bits() & 1));
        CHECK(status != TAUT_OK, "%s: allocation %ld of %ld is not made", call->name, k, count);
    }
    return count;
}
