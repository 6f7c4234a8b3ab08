/* Random calls of every function: NULL and misaligned pointers, wrong lengths, NaN and infinities, invalid constants,
 * objects of different grids, several threads that use the same objects. Every call must return a code. No call may crash,
 * leak, or return STICKSLIP_PANIC. A failed call has a message and leaves its objects unchanged. The test compares all
 * readable contents: fields of solutions, cycles and planes, histories as bytes, and the friction capacity of
 * tangential solvers.
 *   fuzz [calls, default 20000] [threads, default 3] [seed, default 1] */

#define _POSIX_C_SOURCE 200809L

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

#include "run.h"

/* A failed allocation must return its code and not end the process. */
const char *__asan_default_options(void);
const char *__asan_default_options(void) { return "allocator_may_return_null=1"; }

static void one_call(struct run *run) {
    switch (below(run, 17)) {
    case 0:
        rest(run);
        break;
    case 1:
    case 2:
    case 3:
        make(run);
        break;
    case 4:
    case 5:
        change_solver(run);
        break;
    case 6:
    case 7:
        solve(run);
        break;
    case 8:
    case 9:
        step(run);
        break;
    case 10:
    case 11:
        change_history(run);
        break;
    case 12:
        field(run);
        break;
    case 13:
        below_the_surface(run);
        break;
    case 14:
        roll(run);
        break;
    case 15:
        below(run, 2) == 0 ? forms(run) : read_numbers(run);
        break;
    default:
        read_numbers(run);
    }
    compare(run);
}

static atomic_size_t left;

static void *thread(void *data) {
    struct run *run = data;
    size_t before = 0;
    for (;;) {
        size_t done = run->calls - before, now = atomic_load(&left);
        before = run->calls;
        while (!atomic_compare_exchange_weak(&left, &now, now > done ? now - done : 0)) {
        }
        if (now <= done) {
            return NULL;
        }
        one_call(run);
    }
}

static void release_all(struct world *world) {
    for (int kind = 0; kind < KINDS; kind++) {
        for (int i = 0; i < SLOTS; i++) {
            if (release((enum kind)kind, world->slots[kind][i].object) != STICKSLIP_OK) {
                abort();
            }
        }
    }
}

int main(int argc, char **argv) {
    size_t calls = argc > 1 ? strtoul(argv[1], NULL, 10) : 20000;
    size_t threads = argc > 2 ? strtoul(argv[2], NULL, 10) : 3;
    uint64_t seed = argc > 3 ? strtoul(argv[3], NULL, 10) : 1;
    struct run *runs = calloc(threads + 1, sizeof *runs), *first = &runs[threads];
    struct world empty;
    memset(&empty, 0, sizeof empty);
    /* The first thread creates the shared objects, which are freed at the end. */
    first->shared = &empty;
    first->state = seed;
    while (first->calls < 1500) {
        one_call(first);
    }
    pthread_t *handles = calloc(threads, sizeof *handles);
    atomic_store(&left, calls > first->calls ? calls - first->calls : 1);
    for (size_t i = 0; i < threads; i++) {
        runs[i].shared = &first->own;
        runs[i].state = seed + 1000003 * (i + 1);
        if (pthread_create(&handles[i], NULL, thread, &runs[i]) != 0) {
            return 1;
        }
    }
    size_t done = 0, broken = 0, compared = 0, codes[CODES] = {0};
    for (size_t i = 0; i <= threads; i++) {
        if (i < threads) {
            pthread_join(handles[i], NULL);
        }
        done += runs[i].calls, broken += runs[i].broken, compared += runs[i].compared;
        for (int code = 0; code < CODES; code++) {
            codes[code] += runs[i].codes[code];
        }
    }
    for (size_t i = 0; i <= threads; i++) {
        release_all(&runs[i].own);
    }
    stickslip_set_num_threads(0);
    free(handles), free(runs);
    printf("%zu calls on %zu threads, %zu objects compared after failures, %zu broken promises; codes:", done, threads, compared,
           broken);
    for (int code = 0; code < CODES; code++) {
        if (codes[code] > 0) {
            printf(" %d:%zu", code, codes[code]);
        }
    }
    printf("\n");
    return broken == 0 ? 0 : 1;
}
