//! Number of processes reported by the launcher of a program.

use crate::parallel::ranks::RankFailure;

/// Environment variables with the number of processes: variables of launchers first, then variables of a batch system.
const COUNTS: [&str; 5] = [
    "OMPI_COMM_WORLD_SIZE",
    "PMI_SIZE",
    "MV2_COMM_WORLD_SIZE",
    "SLURM_STEP_NUM_TASKS",
    "SLURM_NTASKS",
];

/// Returns an error if a process is alone in its communicator but was started as one of several processes. The first variable
/// that is set determines the number of processes.
pub(super) fn check(
    size: usize,
    variable: impl Fn(&'static str) -> Option<String>,
) -> Result<(), RankFailure> {
    let count = |name| Some((name, variable(name)?.trim().parse().ok()?));
    match COUNTS.into_iter().find_map(count) {
        Some((variable, processes)) if size == 1 && processes > 1 => {
            Err(RankFailure::SeparateMpiJobs {
                variable,
                processes,
            })
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_of_several_that_knows_itself_alone_is_refused() {
        let of = |size: usize, set: &[(&'static str, &str)]| {
            let found = |name| set.iter().find(|(own, _)| *own == name);
            check(size, |name| found(name).map(|(_, value)| (*value).into()))
        };
        let apart = |variable, processes| {
            Err(RankFailure::SeparateMpiJobs {
                variable,
                processes,
            })
        };
        for variable in COUNTS {
            assert_eq!(of(1, &[(variable, "3")]), apart(variable, 3));
            assert_eq!(of(1, &[(variable, "1")]), Ok(()));
            assert_eq!(of(3, &[(variable, "3")]), Ok(()));
            assert_eq!(of(1, &[(variable, "some")]), Ok(()));
        }
        assert_eq!(of(1, &[]), Ok(()));
        // A launcher started one process in a batch job that has room for many processes.
        let queued = [("SLURM_NTASKS", "64"), ("OMPI_COMM_WORLD_SIZE", "1")];
        assert_eq!(of(1, &queued), Ok(()));
    }
}
