/* A contact on several ranks is bitwise identical to the contact in one process. With RANKS_OF_MPI the ranks are processes
 * of an MPI program, otherwise threads that exchange blocks through a box for each pair. */

#define _GNU_SOURCE

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

#define NX 40
#define NY 260
#define CELLS (NX * NY)
#define SPOTS 64

static const stickslip_grid GRID = {NX, NY, 0.5, 0.25};
static const stickslip_material RUBBER = {1.0, 0.3, 0.0}, RIGID = {INFINITY, 0.0, 0.0};
static const stickslip_boundary PERIODIC = {STICKSLIP_PERIODIC, 0.0};

/* Results of a rank: fields of its rows, and numbers of the whole contact. */
typedef struct {
    size_t first, cells;
    double pressure[CELLS], traction[CELLS], slip[CELLS];
    uint32_t labels[CELLS];
    stickslip_spot spots[SPOTS];
    size_t count;
    double numbers[4];
} answers;

/* Returns the gap of bumps on a periodic grid, whose contact crosses the boundaries of slabs. */
static double gap_at(size_t cell) {
    static const double centres[][2] = {{5.0, 8.0}, {14.0, 21.0}, {9.0, 34.0}, {3.0, 47.0}, {17.0, 64.0}};
    double x = (double)(cell % NX) * GRID.dx, y = (double)(cell / NX) * GRID.dy, least = 9.0;
    for (size_t i = 0; i < sizeof centres / sizeof *centres; i++) {
        double along = x - centres[i][0], across = y - centres[i][1];
        double gap = (along * along + across * across) / 40.0 + 0.01 * (double)i;
        least = gap < least ? gap : least;
    }
    return least;
}

static void keep(double *to, const double *from, size_t cells) {
    CHECK(from != NULL);
    memcpy(to, from, cells * sizeof *to);
}

static void solve(const stickslip_ranks *ranks, answers *found) {
    stickslip_half_space *bodies = NULL;
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_solution *pressed = NULL;
    stickslip_tangential_solver *shearer = NULL;
    stickslip_tangential_solution *sheared = NULL;
    stickslip_history *history = NULL;
    stickslip_grid own;
    memset(found, 0, sizeof *found);
    OK(stickslip_half_space_new_distributed(&GRID, &RUBBER, NULL, 0, &RIGID, NULL, 0, &PERIODIC, ranks, &bodies));
    OK(stickslip_half_space_grid(bodies, &own));
    OK(stickslip_half_space_first_row(bodies, &found->first));
    CHECK(own.nx == NX && found->first + own.ny <= NY);
    size_t cells = found->cells = own.nx * own.ny;
    double *gap = calloc(CELLS, sizeof *gap);
    for (size_t i = 0; i < cells; i++) {
        gap[i] = gap_at(found->first * NX + i);
    }
    stickslip_normal_load load = {STICKSLIP_FORCE, 3.0};
    stickslip_friction friction = stickslip_coulomb(0.4);
    stickslip_tangential_load drag = {{STICKSLIP_FORCE, 0.6, 0.0}, {0}, 0.0};
    OK(stickslip_normal_solver_new(bodies, gap, cells, &load, NULL, NULL, &presser));
    OK(stickslip_normal_solution_new(presser, &pressed));
    OK(stickslip_normal_solver_solve(presser, pressed, NULL));
    OK(stickslip_tangential_solver_new(bodies, pressed, &friction, &drag, NULL, &shearer));
    OK(stickslip_tangential_solution_new(shearer, &sheared));
    OK(stickslip_tangential_solver_solve(shearer, sheared, NULL));
    OK(stickslip_tangential_solution_spots(sheared, pressed, found->spots, SPOTS, &found->count, found->labels, cells));
    keep(found->pressure, stickslip_normal_solution_field(pressed, STICKSLIP_PRESSURE, NULL), cells);
    keep(found->traction, stickslip_tangential_solution_field(sheared, STICKSLIP_TRACTION_X, NULL), cells);
    stickslip_normal_result normal = {0};
    stickslip_tangential_result tangential = {0};
    OK(stickslip_normal_solution_result(pressed, &normal));
    OK(stickslip_tangential_solution_result(sheared, &tangential));

    OK(stickslip_history_new(bodies, gap, cells, &friction, NULL, &history));
    for (int i = 0; i < 3; i++) {
        stickslip_load_step step = {0};
        step.normal.kind = STICKSLIP_FORCE, step.normal.value = 2.0 + i;
        step.x.kind = STICKSLIP_FORCE, step.x.value = i == 1 ? 0.7 : -0.3;
        OK(stickslip_history_step(history, &step, NULL));
    }
    stickslip_step_result last = {0};
    OK(stickslip_history_result(history, &last));
    keep(found->slip, stickslip_history_field(history, STICKSLIP_SLIP_X, NULL), cells);
    found->numbers[0] = normal.approach, found->numbers[1] = tangential.shift[0];
    found->numbers[2] = last.shift[0], found->numbers[3] = tangential.stick_ratio;

    /* If one rank rejects a load, all ranks return an error. */
    load.value = ranks->rank == 1 ? -1.0 : 4.0;
    int32_t code = stickslip_normal_solver_set_load(presser, &load);
    CHECK(code == (ranks->size > 1 ? STICKSLIP_RANK_FAILURE : STICKSLIP_OK));
    OK(stickslip_history_free(history));
    OK(stickslip_tangential_solution_free(sheared));
    OK(stickslip_tangential_solver_free(shearer));
    OK(stickslip_normal_solution_free(pressed));
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_half_space_free(bodies));
    free(gap);
}

static void compare(const answers *found, const answers *alone) {
    size_t first = found->first * NX;
    CHECK(memcmp(found->pressure, alone->pressure + first, found->cells * sizeof *found->pressure) == 0);
    CHECK(memcmp(found->traction, alone->traction + first, found->cells * sizeof *found->traction) == 0);
    CHECK(memcmp(found->slip, alone->slip + first, found->cells * sizeof *found->slip) == 0);
    CHECK(memcmp(found->labels, alone->labels + first, found->cells * sizeof *found->labels) == 0);
    CHECK(found->count == alone->count && alone->count > 3);
    CHECK(memcmp(found->spots, alone->spots, sizeof found->spots) == 0);
    CHECK(memcmp(found->numbers, alone->numbers, sizeof found->numbers) == 0);
}

static answers *made(void) {
    answers *one = calloc(1, sizeof *one);
    CHECK(one != NULL);
    return one;
}

#ifdef RANKS_OF_MPI

#include <stickslip_mpi.h>

int main(int count, char **arguments) {
    int granted = 0;
    MPI_Comm comm;
    MPI_Init_thread(&count, &arguments, MPI_THREAD_SERIALIZED, &granted);
    CHECK(granted >= MPI_THREAD_SERIALIZED);
    MPI_Comm_dup(MPI_COMM_WORLD, &comm);
    stickslip_ranks alone = {0, 1, NULL, NULL}, ranks = stickslip_mpi_ranks(&comm);
    answers *found = made(), *whole = made();
    solve(&alone, whole);
    solve(&ranks, found);
    compare(found, whole);
    free(found);
    free(whole);
    MPI_Comm_free(&comm);
    MPI_Finalize();
    return report("ranks of MPI");
}

#else

#include <pthread.h>

#include <errno.h>
#include <time.h>

#define MOST 3
/* Time in seconds for which a rank waits for another rank. */
#define PATIENCE 60

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *pointer, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

/* Number of large allocations that this thread may still make, or negative for no limit. An allocation is large if it has the
 * size of the local part of a field. Blocks are smaller. */
#define LARGE (CELLS / MOST * sizeof(double) / 2)
static __thread long may_have = -1;

static int fails(size_t size) {
    return may_have >= 0 && size >= LARGE && (may_have == 0 || may_have-- == 0);
}
void *malloc(size_t size) { return fails(size) ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails(count * size) ? NULL : __libc_calloc(count, size); }
void *realloc(void *pointer, size_t size) { return fails(size) ? NULL : __libc_realloc(pointer, size); }
int posix_memalign(void **out, size_t alignment, size_t size) {
    *out = fails(size) ? NULL : __libc_memalign(alignment, size);
    return *out == NULL ? ENOMEM : 0;
}
void *aligned_alloc(size_t alignment, size_t size) { return fails(size) ? NULL : __libc_memalign(alignment, size); }

/* Block in transit from one rank to another. */
typedef struct {
    uint64_t *words;
    size_t count;
    int is_full;
} box;

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static box boxes[MOST][MOST];
/* Number of exchanges before the rank is lost. */
static int left = -1;

static int32_t swap(const uint64_t *block, size_t words, size_t to, size_t from, stickslip_block *received, void *user) {
    size_t own = *(const size_t *)user;
    if (left >= 0 && left-- == 0) {
        left = 0;
        return 1;
    }
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_sec += PATIENCE;
    pthread_mutex_lock(&lock);
    box *sent = &boxes[own][to], *got = &boxes[from][own];
    int waited = 0;
    while (sent->is_full && waited == 0) {
        waited = pthread_cond_timedwait(&changed, &lock, &until);
    }
    sent->words = __libc_malloc(words * sizeof *block + 1); /* never fails: the memory belongs to the transport */
    memcpy(sent->words, block, words * sizeof *block);
    sent->count = words, sent->is_full = 1;
    pthread_cond_broadcast(&changed);
    while (!got->is_full && waited == 0) {
        waited = pthread_cond_timedwait(&changed, &lock, &until);
    }
    if (waited != 0) {
        pthread_mutex_unlock(&lock);
        return 1;
    }
    uint64_t *room = stickslip_block_room(received, got->count);
    int32_t failed = room == NULL;
    if (!failed) {
        memcpy(room, got->words, got->count * sizeof *room);
    }
    free(got->words);
    got->is_full = 0;
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&lock);
    return failed;
}

typedef struct {
    stickslip_ranks ranks;
    answers *found;
    /* Number of large allocations that the second rank can make. */
    long can_have;
    stickslip_status status;
} work;

static void *solve_one(void *argument) {
    work *own = argument;
    solve(&own->ranks, own->found);
    return NULL;
}

static void on_threads(size_t size, void *(*run)(void *), work *works) {
    size_t numbers[MOST];
    pthread_t threads[MOST];
    memset(boxes, 0, sizeof boxes);
    for (size_t rank = 0; rank < size; rank++) {
        numbers[rank] = rank;
        works[rank].ranks.rank = rank, works[rank].ranks.size = size;
        works[rank].ranks.swap = swap, works[rank].ranks.user = &numbers[rank];
        CHECK(pthread_create(&threads[rank], NULL, run, &works[rank]) == 0);
    }
    for (size_t rank = 0; rank < size; rank++) {
        CHECK(pthread_join(threads[rank], NULL) == 0);
    }
}

/* Creates kernels and solver of a normal contact. The second rank has too little memory for them. */
static void *make_one(void *argument) {
    work *own = argument;
    stickslip_half_space *bodies = NULL;
    stickslip_normal_solver *presser = NULL;
    stickslip_normal_load load = {STICKSLIP_FORCE, 3.0};
    stickslip_grid slab;
    double *gap = calloc(CELLS, sizeof *gap);
    OK(stickslip_half_space_new_distributed(&GRID, &RUBBER, NULL, 0, &RIGID, NULL, 0, NULL, &own->ranks, &bodies));
    OK(stickslip_half_space_grid(bodies, &slab));
    may_have = own->ranks.rank == 1 ? own->can_have : -1;
    own->status = stickslip_normal_solver_new(bodies, gap, slab.nx * slab.ny, &load, NULL, NULL, &presser);
    may_have = -1;
    if (own->ranks.rank != 1 && own->status != STICKSLIP_OK) {
        CHECK(strstr(stickslip_last_error_message(), "rank 1 rejected its part") != NULL);
    }
    OK(stickslip_normal_solver_free(presser));
    OK(stickslip_half_space_free(bodies));
    free(gap);
    return NULL;
}

static void memory_that_one_rank_lacks_is_told_to_all(void) {
    stickslip_status of_second = STICKSLIP_MEMORY;
    /* The first allocation is the copy of the gap, which a rank makes before it communicates. */
    long can_have = 1;
    for (; of_second != STICKSLIP_OK && can_have < 100; can_have++) {
        work works[MOST] = {{{0}, NULL, 0, 0}};
        works[1].can_have = can_have;
        on_threads(MOST, make_one, works);
        of_second = works[1].status;
        int is_made = of_second == STICKSLIP_OK;
        CHECK(is_made || of_second == STICKSLIP_MEMORY);
        CHECK(works[0].status == (is_made ? STICKSLIP_OK : STICKSLIP_RANK_FAILURE));
        CHECK(works[2].status == works[0].status);
    }
    printf("%ld allocations of a rank failed\n", can_have - 2);
    CHECK(can_have > 8 && of_second == STICKSLIP_OK);
}

static void bad_ranks_are_refused(void) {
    size_t own = 0;
    stickslip_half_space *bodies = NULL;
    stickslip_ranks ranks = {2, 2, swap, &own};
    CHECK(stickslip_half_space_new_distributed(&GRID, &RUBBER, NULL, 0, &RIGID, NULL, 0, NULL, &ranks, &bodies) ==
          STICKSLIP_LENGTH);
    ranks.rank = 0, ranks.swap = NULL;
    CHECK(stickslip_half_space_new_distributed(&GRID, &RUBBER, NULL, 0, &RIGID, NULL, 0, NULL, &ranks, &bodies) ==
          STICKSLIP_BAD_POINTER);
    CHECK(stickslip_half_space_new_distributed(&GRID, &RUBBER, NULL, 0, &RIGID, NULL, 0, NULL, NULL, &bodies) ==
          STICKSLIP_BAD_POINTER);
    /* The first exchange reports that the other rank is lost. */
    ranks.swap = swap, left = 0;
    CHECK(stickslip_half_space_new_distributed(&GRID, &RUBBER, NULL, 0, &RIGID, NULL, 0, NULL, &ranks, &bodies) ==
          STICKSLIP_RANK_FAILURE);
    stickslip_error error;
    OK(stickslip_last_error(&error));
    CHECK(error.index == 1 && bodies == NULL);
    CHECK(stickslip_block_room(NULL, 1) == NULL);
    left = -1;
}

int main(void) {
    stickslip_ranks one = {0, 1, NULL, NULL};
    answers *alone = made();
    OK(stickslip_set_num_threads(1));
    bad_ranks_are_refused();
    solve(&one, alone);
    for (size_t size = 2; size <= MOST; size++) {
        work works[MOST];
        for (size_t rank = 0; rank < size; rank++) {
            works[rank].found = made();
        }
        on_threads(size, solve_one, works);
        for (size_t rank = 0; rank < size; rank++) {
            compare(works[rank].found, alone);
            free(works[rank].found);
        }
    }
    free(alone);
    memory_that_one_rank_lacks_is_told_to_all();
    return report("ranks");
}

#endif
