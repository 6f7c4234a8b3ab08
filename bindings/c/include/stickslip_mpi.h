/* Ranks that are the processes of an MPI communicator, for stickslip_half_space_new_distributed. Header only: the program
 * compiles this header with its own MPI. See stickslip.h. */

#ifndef STICKSLIP_MPI_H
#define STICKSLIP_MPI_H

#include <limits.h>

#include <mpi.h>

#include "stickslip.h"

/* A stickslip_swap whose data is a pointer to a communicator. Any failure ends all ranks, because a message that has been
 * partly sent cannot be withdrawn. */
static inline int32_t stickslip_mpi_swap(const uint64_t *block, size_t words, size_t to, size_t from,
                                         stickslip_block *received, void *user) {
    MPI_Comm comm = *(const MPI_Comm *)user;
    MPI_Request sent;
    MPI_Message message;
    MPI_Status status;
    int count = 0;
    uint64_t *room = NULL;
    if (words > INT_MAX || MPI_Isend((void *)block, (int)words, MPI_UINT64_T, (int)to, 0, comm, &sent) != MPI_SUCCESS) {
        MPI_Abort(comm, 1);
        return 1;
    }
    if (MPI_Mprobe((int)from, 0, comm, &message, &status) == MPI_SUCCESS &&
        MPI_Get_count(&status, MPI_UINT64_T, &count) == MPI_SUCCESS) {
        room = stickslip_block_room(received, (size_t)count);
    }
    if (room == NULL || MPI_Mrecv(room, count, MPI_UINT64_T, &message, MPI_STATUS_IGNORE) != MPI_SUCCESS ||
        MPI_Wait(&sent, MPI_STATUS_IGNORE) != MPI_SUCCESS) {
        MPI_Abort(comm, 1);
        return 1;
    }
    return 0;
}

/* Returns the ranks of a communicator that is used for nothing else: pass a duplicate. The variable that comm points to
 * must remain valid until all objects created from the bodies are freed. MPI must provide at least MPI_THREAD_SERIALIZED,
 * because calls may come from threads of the library. If a rank ends without notifying MPI, the other ranks wait forever.
 */
static inline stickslip_ranks stickslip_mpi_ranks(MPI_Comm *comm) {
    stickslip_ranks ranks;
    int rank = 0, size = 1;
    MPI_Comm_rank(*comm, &rank);
    MPI_Comm_size(*comm, &size);
    ranks.rank = (size_t)rank;
    ranks.size = (size_t)size;
    ranks.swap = stickslip_mpi_swap;
    ranks.user = comm;
    return ranks;
}

#endif /* STICKSLIP_MPI_H */
