/* One contact on several ranks has the bits of one process. With RANKS_OF_MPI ranks are the processes of a program of MPI, else
 * threads that swap blocks through a box for each pair. */

#define _POSIX_C_SOURCE 200809L

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

/* What a rank finds: fields of its rows, and numbers of the whole contact. */
typedef struct {
    size_t first, cells;
    double pressure[CELLS], traction[CELLS], slip[CELLS];
    uint32_t labels[CELLS];
    stickslip_spot spots[SPOTS];
    size_t count;
    double numbers[4];
} answers;

/* Bumps on a grid that repeats, whose contact crosses the ends of slabs. */
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

    /* What one rank refuses all refuse. */
    load.value = ranks->rank == 1 ? -1.0 : 4.0;
    int32_t code = stickslip_normal_solver_set_load(presser, &load);
    CHECK(code == (ranks->size > 1 ? STICKSLIP_RANKS_APART : STICKSLIP_OK));
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

#define MOST 3

/* A block on its way from one rank to another. */
typedef struct {
    uint64_t *words;
    size_t count;
    int is_full;
} box;

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static box boxes[MOST][MOST];
/* Swaps that a rank may still make, of that which is lost. */
static int left = -1;

static int32_t swap(const uint64_t *block, size_t words, size_t to, size_t from, stickslip_block *received, void *user) {
    size_t own = *(const size_t *)user;
    if (left >= 0 && left-- == 0) {
        left = 0;
        return 1;
    }
    pthread_mutex_lock(&lock);
    box *sent = &boxes[own][to], *got = &boxes[from][own];
    while (sent->is_full) {
        pthread_cond_wait(&changed, &lock);
    }
    sent->words = malloc(words * sizeof *block + 1);
    memcpy(sent->words, block, words * sizeof *block);
    sent->count = words, sent->is_full = 1;
    pthread_cond_broadcast(&changed);
    while (!got->is_full) {
        pthread_cond_wait(&changed, &lock);
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
} work;

static void *solve_one(void *argument) {
    work *own = argument;
    solve(&own->ranks, own->found);
    return NULL;
}

static void on_threads(size_t size, const answers *alone) {
    size_t numbers[MOST];
    work works[MOST];
    pthread_t threads[MOST];
    for (size_t rank = 0; rank < size; rank++) {
        numbers[rank] = rank;
        works[rank].ranks.rank = rank, works[rank].ranks.size = size;
        works[rank].ranks.swap = swap, works[rank].ranks.user = &numbers[rank];
        works[rank].found = made();
        CHECK(pthread_create(&threads[rank], NULL, solve_one, &works[rank]) == 0);
    }
    for (size_t rank = 0; rank < size; rank++) {
        CHECK(pthread_join(threads[rank], NULL) == 0);
        compare(works[rank].found, alone);
        free(works[rank].found);
    }
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
    /* The first swap tells that the other is lost. */
    ranks.swap = swap, left = 0;
    CHECK(stickslip_half_space_new_distributed(&GRID, &RUBBER, NULL, 0, &RIGID, NULL, 0, NULL, &ranks, &bodies) ==
          STICKSLIP_RANKS_APART);
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
        on_threads(size, alone);
    }
    free(alone);
    return report("ranks");
}

#endif
