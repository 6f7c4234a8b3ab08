# %%
import stickslip as ss
from stickslip.history import Cycle, FrettingLoop, LoadPath

grid = ss.Grid.square(64, 0.30e-3)
steel = ss.Material(213e9, 0.29)
bodies = ss.HalfSpace(grid, (steel, steel))
history = ss.History(bodies, ss.surface.sphere(grid, 3.5e-3), 0.5)

# Press first: simultaneous pressing and shearing leaves a traction that no cycle removes.
history.step(normal_force=100.0)


# A shift with an amplitude of 1.5 micrometres in 20 steps per cycle, under 100 N.
def load(shift):
    return ss.LoadStep(normal_force=100.0, shift=shift)


path = LoadPath.sine((1.5e-6, 0.0), 20)
outcome = FrettingLoop(path, load, until_steady=1e-4).run(history, 10)
print(f"{outcome.last.regime}, energy ratio {outcome.last.energy_ratio:.3f}")

# A thousand cycles of wear in jumps; the energy coefficient is 1e-14 cubic metres per joule.
# wear.run computes the same loop in one call.
fretting, cycle, cycles = FrettingLoop(path, load), Cycle(history), 0
while cycles < 1000:
    # The first cycle on a worn gap does not close; the second does.
    for _ in range(2):
        fretting.cycle(history, cycle)
    depth = ss.wear.energy(1e-14, cycle.dissipation, grid=grid)
    limits = {"largest_depth": 0.01 * history.approach, "cycles_left": 1000 - cycles}
    jump = ss.wear.CycleJump(bodies, cycle, depth, **limits).cycles()
    # The gap opens where material is removed; tractions and slip are unchanged.
    # The arrays of a history are read-only copies. With a permanent set, only `gap_as_set` excludes the yielded depth.
    history.set_gap(history.gap_as_set + jump * depth)
    cycles += jump
    print(f"{cycles} cycles, {cycle.energy.dissipated_energy:.2e} J a cycle")

# A restored history continues with bitwise identical results.
assert ss.History.from_bytes(bodies, history.to_bytes()).shift == history.shift
