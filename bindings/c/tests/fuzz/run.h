/* What random calls need: objects in slots, random arguments, and what was seen of the codes. */

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
/* More than the cells of any grid here. */
#define LARGE 16384

struct slot {
    void *object;
    size_t cells;
    /* Of what can be read of the object; used where no other thread has it. */
    uint64_t hash;
    /* The call under way may have been given the object, or may change it although it fails. */
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
    /* Of the call under way. */
    stickslip_status failed;
};

uint64_t next(struct run *run);
size_t below(struct run *run, size_t count);
bool rarely(struct run *run);
double unit(struct run *run);
/* Mostly near scale, sometimes what no number should be. */
double number(struct run *run, double scale);
int32_t option(struct run *run, int32_t count);
/* A pointer as it is; sometimes NULL or misaligned. */
const void *maybe(struct run *run, const void *pointer);
void *maybe_out(struct run *run, void *pointer);
/* An array of so many numbers, or of another length, which count then has. */
double *array(struct run *run, size_t *count, double scale);

stickslip_settings settings(struct run *run);
stickslip_friction friction(struct run *run, double *cells, size_t count);
stickslip_normal_load normal_load(struct run *run);
stickslip_tangential_load tangential_load(struct run *run);
stickslip_load_step load_step(struct run *run);
/* Ends the solve after some iterations. */
int32_t watch(const stickslip_iteration *iteration, void *user);

/* A broken promise. */
void broken(struct run *run, int line, const char *what);
/* Notes what a call returned. */
void seen(struct run *run, stickslip_status status, int line);
#define SEEN(call) seen(run, (call), __LINE__)

/* A slot of one's own or, sometimes, of those that all threads share. */
struct slot *pick(struct run *run, enum kind kind);
#define GET(type, slot) ((type *)maybe_out(run, (slot)->object))
/* Puts a new object in a slot, and frees the one that was there. */
void put(struct run *run, enum kind kind, void *object, size_t cells);
stickslip_status release(enum kind kind, void *object);

/* Compares what can be read of the objects that the last call was given with what it was before, if the call failed. */
void compare(struct run *run);
/* A number for what can be read of an object. */
uint64_t hash_of(enum kind kind, const void *object);
/* A history as bytes; NULL if it has none to give. */
uint8_t *bytes_of(struct run *run, const stickslip_history *history, size_t *length);

/* The calls, by what they are for. */
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
