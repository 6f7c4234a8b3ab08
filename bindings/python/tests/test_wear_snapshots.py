"""Snapshots of ``wear.run``: protected arrays and files."""

import gzip
import os
import pickle
import threading

import numpy as np
import pytest

import stickslip as ss
from test_wear_run import BODIES, COEFFICIENT, GRID, history, loop

LAW = ss.wear.EnergyLaw(COEFFICIENT)


@pytest.fixture(scope="module")
def result():
    return ss.wear.run(history(), loop(), LAW, 100)


def arrays_of(target):
    names = [name for name in dir(target) if not name.startswith("_")]
    return {name: value for name in names if isinstance(value := getattr(target, name), np.ndarray)}


def test_arrays_of_results_and_snapshots_are_read_only(result, tmp_path):
    result.snapshot.save(tmp_path / "a")
    loaded = ss.wear.WearSnapshot.load(tmp_path / "a")
    copied = pickle.loads(pickle.dumps(result.snapshot))
    for target in (result, result.snapshot, result.history, loaded, loaded.history, copied, pickle.loads(pickle.dumps(result.history))):
        arrays = arrays_of(target)
        assert len(arrays) >= 2
        for name, array in arrays.items():
            with pytest.raises(ValueError, match="read-only"):
                array += 1
            assert not array.flags.writeable, name


def test_progress_and_law_cannot_change_the_run(result):
    def change(snapshot):
        with pytest.raises(ValueError, match="read-only"):
            snapshot.depth[:] = 1.0

    worn = history()
    again = ss.wear.run(worn, loop(), LAW, 100, progress=change)
    assert np.array_equal(again.depth, result.depth)

    class Changing:
        def depth_of_jump(self, history, cycle, dissipation, cycles):
            dissipation += 1.0

    with pytest.raises(ValueError, match="read-only"):
        ss.wear.run(history(), loop(), Changing(), 100)


def test_threads_may_save_to_one_file(result, tmp_path):
    path, failures = tmp_path / "snapshot", []
    barrier = threading.Barrier(8)

    def save():
        barrier.wait()
        try:
            for _ in range(10):
                result.snapshot.save(path)
        except Exception as error:
            failures.append(error)

    threads = [threading.Thread(target=save) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures and os.listdir(tmp_path) == ["snapshot"]
    assert ss.wear.WearSnapshot.load(path).cycles == result.cycles


def test_path_may_be_bytes_and_must_not_be_empty(result, tmp_path):
    path = os.fsencode(tmp_path / "snapshot")
    result.snapshot.save(path)
    assert ss.wear.WearSnapshot.load(path).cycles == result.cycles
    for call in (result.snapshot.save, ss.wear.WearSnapshot.load):
        with pytest.raises(ss.errors.ArgumentRange, match="^path must not be empty"):
            call("")
        with pytest.raises(ss.errors.ArgumentType, match="^path must be a path, got an object of the class float"):
            call(1.0)


def test_compressed_and_foreign_files_are_named(result, tmp_path):
    path = tmp_path / "snapshot"
    result.snapshot.save(path)
    path.write_bytes(gzip.compress(path.read_bytes()))
    with pytest.raises(ss.errors.Format, match="the file is compressed by gzip: decompress it by gunzip"):
        ss.wear.WearSnapshot.load(path)
    worn = result.snapshot.restored(BODIES)
    worn.save(path)
    with pytest.raises(ss.errors.Format, match="the file is a saved history: load it by History.load"):
        ss.wear.WearSnapshot.load(path)
    np.savez(path.with_suffix(".npz"), a=1.0)
    with pytest.raises(ss.errors.Format, match="not a snapshot of wear.run, or it is damaged: give a file written by WearSnapshot.save"):
        ss.wear.WearSnapshot.load(path.with_suffix(".npz"))
    path.write_bytes(gzip.compress(worn.to_bytes()))
    with pytest.raises(ss.errors.Format, match="the data are compressed by gzip: decompress them first"):
        ss.History.load(BODIES, path)
    with pytest.raises(ss.errors.Format, match="the data are compressed by gzip"):
        ss.history.State.from_bytes(path.read_bytes())
    assert GRID == worn.grid
