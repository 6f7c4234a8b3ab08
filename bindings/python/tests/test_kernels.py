"""Coated bodies and kernels: layers are felt, and a callable and a table of a coating are that coating."""

import pickle

import numpy as np
import pytest

import stickslip as ss

RIGID = ss.Material.rigid()
COATED = ss.ElasticPair(ss.Material(1.0, 0.3).coated([ss.layers.Layer(4.0, 0.2, 0.4)]), RIGID)
OUTERMOST = ss.ElasticPair(ss.Material(4.0, 0.2), RIGID)
GRID = ss.Grid.square(48, 6.0)
BALL = ss.surface.sphere(GRID, 4.0)


def response(k):
    found = COATED.response(k)
    return found.normal, found.along, found.across, found.coupling


def tabulated(sides=(GRID.dx, GRID.dy)):
    names = ["xx", "yy", "zz", "xy", "zx", "zy"]
    tables = {name: ss.influence.Table(GRID, COATED, name) for name in names}
    n = range(48)
    return ss.Kernel.tabulated(OUTERMOST, sides, {name: np.array([[of.get(i, j) for i in n] for j in n]) for name, of in tables.items()})


def test_layers_are_those_of_the_crate():
    layer = ss.layers.Layer(4.0, 0.25, 0.1)
    assert (layer.youngs_modulus, layer.poisson_ratio, layer.thickness, layer.shear_modulus) == (4.0, 0.25, 0.1, 1.6)
    assert pickle.loads(pickle.dumps(layer)) == layer and hash(layer) == hash(ss.layers.Layer(4.0, 0.25, 0.1))
    body = ss.Material(1.0, 0.3).coated([layer, layer])
    assert body.is_coated and body.layers == [layer, layer] and body != ss.Material(1.0, 0.3)
    assert pickle.loads(pickle.dumps(body)) == body and hash(body) == hash(pickle.loads(pickle.dumps(body)))
    assert eval(repr(body), {"Material": ss.Material, "Layer": ss.layers.Layer}) == body
    bed = RIGID.coated([layer])
    assert bed.is_coated and not bed.is_rigid and repr(bed).startswith("Material.rigid().coated([")
    with pytest.raises(ss.errors.TooManyLayers):
        body.coated([layer] * 7)
    with pytest.raises(ss.errors.NotPositive):
        ss.layers.Layer(4.0, 0.25, 0.0)
    # Short waves see the layer, long ones the base.
    assert COATED.response(1e4).normal * 1e4 == pytest.approx(OUTERMOST.response(1.0).normal, rel=1e-12)
    assert COATED.response(1e-6).normal * 1e-6 == pytest.approx(2 * (1 - 0.3**2), rel=1e-5)
    with pytest.raises(ss.errors.NotPositive):
        COATED.response(0.0)


def test_a_callable_and_a_table_of_a_coating_are_that_coating():
    kernels = (COATED, ss.Kernel.isotropic(OUTERMOST, 0.4, response), tabulated())
    bodies = [ss.HalfSpace(GRID, of) for of in kernels]
    options = {"normal_force": 0.3, "force_x": 0.02, "tolerance": 1e-10}
    expected, *others = [ss.CoupledProblem(of, BALL, 0.3, **options).solve() for of in bodies]
    scale = expected.normal.pressure.max()
    for other in others:
        assert np.abs(other.normal.pressure - expected.normal.pressure).max() < 1e-7 * scale
        assert np.abs(other.tangential.traction[0] - expected.tangential.traction[0]).max() < 1e-7 * scale
    assert bodies[1].pair != COATED


def test_large_grids_call_back_from_all_threads(request):
    """Nothing waits for the GIL that this thread holds."""
    before = ss.num_threads()
    ss.set_num_threads(2)
    request.addfinalizer(lambda: ss.set_num_threads(before))
    grid = ss.Grid.square(128, 6.0)
    ball = ss.surface.sphere(grid, 4.0)
    kernel = ss.Kernel.isotropic(OUTERMOST, 0.4, response)
    approach = [ss.NormalProblem(ss.HalfSpace(grid, of), ball, force=0.3).solve().approach for of in (kernel, COATED)]
    assert approach[0] == pytest.approx(approach[1], rel=1e-7)
    periodic = [ss.HalfSpace(grid, of, boundary="periodic") for of in (kernel, COATED)]
    approach = [ss.NormalProblem(of, ball, force=0.3).solve().approach for of in periodic]
    assert approach[0] == pytest.approx(approach[1], rel=1e-7)


def test_bad_kernels_are_refused():
    with pytest.raises(ZeroDivisionError):
        ss.Kernel.isotropic(OUTERMOST, 0.4, lambda k: 1 / 0)
    with pytest.raises(TypeError, match="four numbers"):
        ss.Kernel.isotropic(OUTERMOST, 0.4, lambda k: 1.0)
    with pytest.raises(ss.errors.NotPositive):
        ss.Kernel.isotropic(OUTERMOST, 0.4, lambda k: (-1.0, 1.0, 1.0, 0.0))
    astray = ss.Kernel.isotropic(ss.ElasticPair(ss.Material(3.0, 0.2), RIGID), 0.4, response)
    with pytest.raises(ss.errors.Below):
        ss.HalfSpace(GRID, astray)
    with pytest.raises(ss.errors.GridMismatch):
        ss.HalfSpace(GRID, tabulated((1.0, 1.0)))
    with pytest.raises(ss.errors.Coated):
        ss.HalfSpace(GRID, tabulated(), boundary="periodic")
    with pytest.raises(ValueError, match="no component"):
        ss.Kernel.tabulated(OUTERMOST, (1.0, 1.0), {})
    with pytest.raises(ValueError, match="differ in their shape"):
        ss.Kernel.tabulated(OUTERMOST, (1.0, 1.0), {"zz": np.zeros((2, 3)), "xx": np.zeros((3, 2))})
    kernel = ss.Kernel.isotropic(OUTERMOST, 0.4, response)
    with pytest.raises(ss.errors.KernelMissing) as caught:
        ss.HalfSpace(GRID, kernel.pair)
    assert "hand over the kernel" in caught.value.part
    with pytest.raises(TypeError, match="not pickled"):
        pickle.dumps(ss.HalfSpace(GRID, kernel))
