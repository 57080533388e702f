/* helper.h -- work for taut-cad: OpenCASCADE in a process of its own, which the library and its global settings, its
 * crashes and its appetite do not leave. */
#ifndef TAUT_IO_CAD_HELPER_H
#define TAUT_IO_CAD_HELPER_H

#include "io/cad/answer.h"
#include "taut/monitor.h"

#define TAUT_CAD_PATIENCE 0.02

/* Writes items into result->text: count > 0. The monitor, which may be NULL, is told every TAUT_CAD_PATIENCE seconds that taut-cad is
 * waited for: of what another process does there is no other measure than the clock; an end stops it. Reads into result->model and notes: count 0. TAUT_IO where taut-cad is not
 * installed ("not-installed"), is another version's or none ("helper"), or no process is to be had ("process");
 * TAUT_BAD_INPUT (reading) or TAUT_INTERNAL (writing) where it died or took too long; TAUT_INTERRUPTED;
 * TAUT_NO_MEMORY; else what taut-cad says. Safe from any thread. */
taut_status taut_cad_run(const taut_cad_job *job, int count, const taut_cad_item *items,
                         const taut_monitor *monitor, taut_cad_result *result, taut_error *error);

#endif /* TAUT_IO_CAD_HELPER_H */
