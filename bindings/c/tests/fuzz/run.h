/* Common parts of the random calls: objects in slots, random arguments, and counts of the returned codes. */

#ifndef RUN_H
#define RUN_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include <stickslip.h>

enum kind {
    BODIES, NORMAL, PRESSED, TANGENTIAL, SHEARED, COUPLED, BOTH, HISTORY, STATE, ADAPTIVE, CYCLE, PLANES,
    ROLLING, ROLLED, KINDS
};
#define SLOTS 3
#define CODES 128
/* Larger than the number of cells of any grid in this test. */
#define LARGE 16384

struct slot {
    void *object;
    size_t cells;
    /* Hash of the readable contents of the object, used only if no other thread has the object. */
    uint64_t hash;
    /* Whether the current call may use the object, and whether it may change the object although it fails. */
    bool is_given, may_change;
};

struct world {
    struct slot slots[KINDS][SLOTS];
};

struct run {
    struct world own, *shared;
    uint64_t state;
    size_t calls, broken, compared;
    size_t codes[CODES];
    /* Code of the current call if it failed. */
    stickslip_status failed;
};

uint64_t next(struct run *run);
size_t below(struct run *run, size_t count);
bool rarely(struct run *run);
double unit(struct run *run);
/* Returns a number mostly near scale, sometimes an invalid one. */
double number(struct run *run, double scale);
int32_t option(struct run *run, int32_t count);
/* Returns a pointer unchanged, or sometimes a NULL or misaligned pointer. */
const void *maybe(struct run *run, const void *pointer);
void *maybe_out(struct run *run, void *pointer);
/* Returns an array of count numbers, or sometimes of a different length, and then changes count. */
double *array(struct run *run, size_t *count, double scale);

stickslip_settings settings(struct run *run);
stickslip_friction friction(struct run *run, double *cells, size_t count);
stickslip_normal_load normal_load(struct run *run);
stickslip_tangential_load tangential_load(struct run *run);
stickslip_load_step load_step(struct run *run);
/* Ends the solve after a few iterations. */
int32_t watch(const stickslip_iteration *iteration, void *user);

/* Reports a violated guarantee. */
void broken(struct run *run, int line, const char *what);
/* Records the code of a call. */
void seen(struct run *run, stickslip_status status, int line);
#define SEEN(call) seen(run, (call), __LINE__)

/* Picks a slot of this thread or, sometimes, a slot that all threads share. */
struct slot *pick(struct run *run, enum kind kind);
#define GET(type, slot) ((type *)maybe_out(run, (slot)->object))
/* Puts a new object in a slot and frees the previous object. */
void put(struct run *run, enum kind kind, void *object, size_t cells);
stickslip_status release(enum kind kind, void *object);

/* If the last call failed, compares the readable contents of its objects with their previous contents. */
void compare(struct run *run);
/* Returns a hash of the readable contents of an object. */
uint64_t hash_of(enum kind kind, const void *object);
/* Returns a history as bytes, or NULL on failure. */
uint8_t *bytes_of(struct run *run, const stickslip_history *history, size_t *length);

/* Groups of calls. */
void make_bodies(struct run *run);
void make(struct run *run);
void change_solver(struct run *run);
void solve(struct run *run);
void step(struct run *run);
void change_history(struct run *run);
void field(struct run *run);
void read_numbers(struct run *run);
void below_the_surface(struct run *run);
void roll(struct run *run);
void forms(struct run *run);
void rest(struct run *run);

#endif
