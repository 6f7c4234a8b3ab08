/* Messages of failures: their lifetime, copies, and the separation of threads. */

#include <pthread.h>
#include <string.h>

#include "check.h"

static const stickslip_material STEEL = {213e9, 0.29, 0.0};

/* Fails with a message that contains the side of a cell. */
static void fail(double side) {
    stickslip_grid grid = {4, 4, side, 1.0};
    stickslip_half_space *bodies = NULL;
    CHECK(stickslip_half_space_new(&grid, &STEEL, &STEEL, NULL, &bodies) == STICKSLIP_NOT_POSITIVE);
}

static void text_stays_until_the_next_failure(void) {
    fail(-1.5);
    const char *message = stickslip_last_error_message();
    char before[256], after[256];
    size_t length = stickslip_last_error_copy(before, sizeof before);
    CHECK(length == strlen(message) && strcmp(before, message) == 0 && strstr(message, "-1.5") != NULL);
    /* A successful call does not change the message. */
    CHECK(stickslip_set_num_threads(0) == STICKSLIP_OK && strcmp(message, before) == 0);
    fail(-2.5);
    CHECK(stickslip_last_error_message() == message && strstr(message, "-2.5") != NULL);
    stickslip_last_error_copy(after, sizeof after);
    CHECK(strcmp(before, after) != 0);
}

static void copies_fit_their_buffer(void) {
    fail(-1.5);
    const char *message = stickslip_last_error_message();
    size_t length = strlen(message);
    CHECK(stickslip_last_error_copy(NULL, 0) == length && stickslip_last_error_copy(NULL, 10) == length);
    for (size_t capacity = 0; capacity <= length + 2; capacity++) {
        char buffer[256];
        memset(buffer, '?', sizeof buffer);
        CHECK(stickslip_last_error_copy(buffer, capacity) == length);
        size_t copied = capacity == 0 ? 0 : capacity - 1 < length ? capacity - 1 : length;
        CHECK(memcmp(buffer, message, copied) == 0);
        CHECK(capacity == 0 || buffer[copied] == '\0');
        CHECK(buffer[capacity > copied + 1 ? copied + 1 : capacity] == '?');
    }
}

/* Thread that fails repeatedly with a message of its own. */
struct caller {
    pthread_barrier_t *together;
    double side;
    const char *number, *message;
    int wrong;
};

static void *run(void *user) {
    struct caller *self = user;
    stickslip_error error;
    char copy[256];
    self->wrong += *stickslip_last_error_message() != '\0' || stickslip_last_error_copy(copy, sizeof copy) != 0;
    for (int i = 0; i < 200; i++) {
        stickslip_grid grid = {4, 4, self->side, 1.0};
        stickslip_half_space *bodies = NULL;
        self->wrong += stickslip_half_space_new(&grid, &STEEL, &STEEL, NULL, &bodies) != STICKSLIP_NOT_POSITIVE;
        /* The other thread has failed too before this thread reads. */
        pthread_barrier_wait(self->together);
        self->message = stickslip_last_error_message();
        stickslip_last_error_copy(copy, sizeof copy);
        self->wrong += strstr(self->message, self->number) == NULL || strcmp(copy, self->message) != 0;
        self->wrong += stickslip_last_error(&error) != STICKSLIP_OK || error.value != self->side;
        pthread_barrier_wait(self->together);
    }
    return NULL;
}

static void threads_have_their_own_messages(void) {
    pthread_barrier_t together;
    pthread_t threads[2];
    struct caller callers[2] = {{&together, -3.25, "-3.25", NULL, 0}, {&together, -4.75, "-4.75", NULL, 0}};
    fail(-1.5);
    CHECK(pthread_barrier_init(&together, NULL, 2) == 0);
    for (int i = 0; i < 2; i++) {
        CHECK(pthread_create(&threads[i], NULL, run, &callers[i]) == 0);
    }
    for (int i = 0; i < 2; i++) {
        CHECK(pthread_join(threads[i], NULL) == 0);
        CHECK(callers[i].wrong == 0 && callers[i].message != stickslip_last_error_message());
    }
    CHECK(callers[0].message != callers[1].message);
    CHECK(strstr(stickslip_last_error_message(), "-1.5") != NULL);
    pthread_barrier_destroy(&together);
}

int main(void) {
    CHECK(*stickslip_last_error_message() == '\0' && stickslip_last_error_copy(NULL, 0) == 0);
    text_stays_until_the_next_failure();
    copies_fit_their_buffer();
    threads_have_their_own_messages();
    return report("messages");
}
