/* taut/monitor.h -- progress of long work, and stopping it. */
#ifndef TAUT_MONITOR_H
#define TAUT_MONITOR_H

#ifdef __cplusplus
extern "C" {
#endif

/* Zero-initialised means: say nothing, never stop. */
typedef struct taut_monitor {
    /* Called now and then from the thread that made the call, with the part done in [0, 1] (NaN
     * if unknown) and a word for what is being done. A return other than 0 stops the work:
     * the function returns TAUT_INTERRUPTED with its outputs untouched. */
    int (*progress)(void *context, double done, const char *what);
    void *context;
} taut_monitor;

#ifdef __cplusplus
}
#endif
#endif /* TAUT_MONITOR_H */
