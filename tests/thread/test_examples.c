/* test_examples.c -- every worked example made, proved and measured by two threads of eight at
 * about the same time: nothing is shared that one may change, which the thread sanitizer watches
 * (preset `thread`), and both find the same bytes.
 *
 * links: pthread
 *
 * needs: posix
 */
#include "check.h"
#include "cli/embedded_files.h"

#include "taut/construct.h"
#include "taut/measure.h"
#include "taut/read.h"

#include <pthread.h>
#include <string.h>

enum { THREADS = 8, TWICE = 2, NUMBERS = 64, EXAMPLES = 400 };

/* What one pass over an example found: the residuals of its claims and the area of its surfaces. */
typedef struct finding {
    int count;
    double numbers[NUMBERS];
} finding;

typedef struct queue {
    pthread_mutex_t lock;
    int next, count;
    finding found[EXAMPLES][TWICE];
} queue;

static void keep(finding *f, double number)
{
    if (f->count < NUMBERS) {
        f->numbers[f->count++] = number;
    }
}

static taut_status measure(const taut_model *model, finding *f)
{
    const taut_measure_options options = {.grid = 7};
    taut_status status = TAUT_OK;
    for (int i = 0; i < taut_model_surface_count(model) && status == TAUT_OK; i++) {
        taut_surface_measure found;
        status = taut_measure_surface(taut_model_surface(model, i), &options, &found, NULL);
        keep(f, status == TAUT_OK ? found.area : 0);
    }
    return status;
}

static taut_status work(const taut_embedded *file, finding *f)
{
    taut_problem *problem = NULL;
    taut_model *model = NULL;
    taut_certificate *certificate = NULL;
    taut_status status =
        taut_problem_read_text(file->text, file->length, file->name, &problem, NULL);
    if (status == TAUT_OK) {
        status = taut_make(problem, NULL, &model, NULL);
    }
    if (status == TAUT_OK) {
        status = taut_certify(model, problem, NULL, &certificate, NULL);
    }
    for (int i = 0; status == TAUT_OK && i < taut_certificate_claim_count(certificate); i++) {
        keep(f, taut_certificate_claim(certificate, i)->residual);
    }
    if (status == TAUT_OK) {
        status = measure(model, f);
    }
    taut_certificate_free(certificate);
    taut_model_free(model);
    taut_problem_free(problem);
    return status;
}

/* Takes passes off the queue until there are none: two of each example, one after the other. */
static void *run(void *context)
{
    queue *q = context;
    for (;;) {
        pthread_mutex_lock(&q->lock);
        const int pass = q->next < TWICE * q->count ? q->next++ : -1;
        pthread_mutex_unlock(&q->lock);
        if (pass < 0) {
            return NULL;
        }
        if (work(&taut_examples[pass / TWICE], &q->found[pass / TWICE][pass % TWICE]) != TAUT_OK) {
            q->found[pass / TWICE][pass % TWICE].count = -1 - pass % TWICE;
        }
    }
}

int main(void)
{
    static queue q = {.lock = PTHREAD_MUTEX_INITIALIZER};
    pthread_t threads[THREADS];

    while (q.count < EXAMPLES && taut_examples[q.count].name != NULL) {
        q.count++;
    }
    CHECK(taut_examples[q.count].name == NULL, "more than %d examples", q.count);
    for (int i = 0; i < THREADS; i++) {
        CHECK(pthread_create(&threads[i], NULL, run, &q) == 0, "thread %d", i);
    }
    for (int i = 0; i < THREADS; i++) {
        pthread_join(threads[i], NULL);
    }
    for (int i = 0; i < q.count; i++) {
        const finding *f = q.found[i];
        CHECK(f[0].count > 0 && f[0].count == f[1].count &&
                  memcmp(f[0].numbers, f[1].numbers, (size_t)f[0].count * sizeof(double)) == 0,
              "%s: two threads differ, or fail (%d, %d)", taut_examples[i].name, f[0].count,
              f[1].count);
    }
    return check_failures != 0;
}
