/* taut/monitor.h -- progress of long work, and stopping it. */
#ifndef TAUT_MONITOR_H
#define TAUT_MONITOR_H

#ifdef __cplusplus
extern "C" {
#endif

/* What a report is answered with. */
enum {
    TAUT_GO_ON = 0,
    TAUT_STOP = 1,  /* as any number that is not listed here */
    TAUT_ENOUGH = 2 /* end with the best so far, once there is something to show */
};

/* Zero-initialised means: say nothing, never stop. */
typedef struct taut_monitor {
    /* Called now and then from the thread that made the call, with the part done in [0, 1] (NaN
     * if unknown) and a word for what is being done. TAUT_STOP: the function returns
     * TAUT_INTERRUPTED with its outputs untouched. TAUT_ENOUGH: work that comes nearer step by step
     * ends as it is (taut_make says how); other work ends as if stopped. */
    int (*progress)(void *context, double done, const char *what);
    void *context;
} taut_monitor;

#ifdef __cplusplus
}
#endif
#endif /* TAUT_MONITOR_H */
