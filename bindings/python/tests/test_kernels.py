"""Coated bodies, kernels and operators: the effect of layers, and agreement of user-defined bodies with elastic
bodies."""

import pickle
import threading

import numpy as np
import pytest

import stickslip as ss

RIGID = ss.Material.rigid()
COATED = ss.ElasticPair(ss.Material(1.0, 0.3).coated([ss.layers.Layer(4.0, 0.2, thickness=0.4)]), RIGID)
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


def test_layers_match_crate():
    layer = ss.layers.Layer(4.0, 0.25, thickness=0.1)
    assert (layer.youngs_modulus, layer.poisson_ratio, layer.thickness, layer.shear_modulus) == (4.0, 0.25, 0.1, 1.6)
    assert pickle.loads(pickle.dumps(layer)) == layer and hash(layer) == hash(ss.layers.Layer(4.0, 0.25, thickness=0.1))
    body = ss.Material(1.0, 0.3).coated([layer, layer])
    assert body.is_coated and body.layers == [layer, layer] and body != ss.Material(1.0, 0.3)
    assert pickle.loads(pickle.dumps(body)) == body and hash(body) == hash(pickle.loads(pickle.dumps(body)))
    assert eval(repr(body), {"Material": ss.Material, "Layer": ss.layers.Layer}) == body
    bed = RIGID.coated([layer])
    assert bed.is_coated and not bed.is_rigid and repr(bed).startswith("Material.rigid().coated([")
    with pytest.raises(ss.errors.TooManyLayers):
        body.coated([layer] * 7)
    with pytest.raises(ss.errors.NotPositive):
        ss.layers.Layer(4.0, 0.25, thickness=0.0)
    # Short waves have the response of the layer, and long waves have the response of the base.
    assert COATED.response(1e4).normal * 1e4 == pytest.approx(OUTERMOST.response(1.0).normal, rel=1e-12)
    assert COATED.response(1e-6).normal * 1e-6 == pytest.approx(2 * (1 - 0.3**2), rel=1e-5)
    with pytest.raises(ss.errors.NotPositive):
        COATED.response(0.0)


def test_callable_and_table_of_coating_match_coating():
    kernels = (COATED, ss.Kernel.isotropic(OUTERMOST, 0.4, response), tabulated())
    bodies = [ss.HalfSpace(GRID, of) for of in kernels]
    options = {"normal_force": 0.3, "force_x": 0.02, "tolerance": 1e-10}
    expected, *others = [ss.CoupledProblem(of, BALL, 0.3, **options).solve() for of in bodies]
    scale = expected.normal.pressure.max()
    for other in others:
        assert np.abs(other.normal.pressure - expected.normal.pressure).max() < 1e-7 * scale
        assert np.abs(other.tangential.traction[0] - expected.tangential.traction[0]).max() < 1e-7 * scale
    assert bodies[1].pair != COATED


def test_axes_of_tabulated_coefficients_are_recognised_by_name():
    xarray = pytest.importorskip("xarray")
    grid = ss.Grid(16, 12, 0.1, 0.2)
    of = ss.influence.Table(grid, OUTERMOST, "zz")
    values = np.array([[of.get(i, j) for i in range(16)] for j in range(12)])
    turned = xarray.DataArray(values, dims=("y", "x")).transpose("x", "y")
    kernels = (ss.Kernel.tabulated(OUTERMOST, (0.1, 0.2), {"zz": table}) for table in (values, turned))
    by_position, by_name = (ss.HalfSpace(grid, kernel).operator("zz")(np.eye(12, 16)) for kernel in kernels)
    assert np.array_equal(by_position, by_name)


def test_matrices_as_operators_name_the_remedy():
    matrix = np.eye(GRID.nx * GRID.ny)
    message = r"operator must be a LinearOperator or a callable, got ndarray: convert a matrix by dense\.DenseOperator\(matrix\)"
    with pytest.raises(TypeError, match=message):
        ss.Kernel.operators(OUTERMOST, GRID, {"z": matrix})
    random = np.random.default_rng(1)
    with pytest.raises(ss.errors.UnsupportedByModel, match="a product that changes if it is repeated") as caught:
        ss.Kernel.operators(OUTERMOST, GRID, {"z": lambda p: p * (1.0 + 1e-3 * random.random())})
    assert "`out`" not in str(caught.value)


def test_response_on_large_grid_is_called_from_all_threads(request):
    """No thread waits for the GIL that this thread holds."""
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


def test_invalid_kernels_are_rejected():
    with pytest.raises(ZeroDivisionError):
        ss.Kernel.isotropic(OUTERMOST, 0.4, lambda k: 1 / 0)
    with pytest.raises(TypeError, match="four numbers"):
        ss.Kernel.isotropic(OUTERMOST, 0.4, lambda k: 1.0)
    with pytest.raises(ss.errors.NotPositive):
        ss.Kernel.isotropic(OUTERMOST, 0.4, lambda k: (-1.0, 1.0, 1.0, 0.0))
    astray = ss.Kernel.isotropic(ss.ElasticPair(ss.Material(3.0, 0.2), RIGID), 0.4, response)
    with pytest.raises(ss.errors.BelowMinimum):
        ss.HalfSpace(GRID, astray)
    with pytest.raises(ss.errors.GridMismatch):
        ss.HalfSpace(GRID, tabulated((1.0, 1.0)))
    with pytest.raises(ss.errors.UnsupportedForCoatings):
        ss.HalfSpace(GRID, tabulated(), boundary="periodic")
    with pytest.raises(ValueError, match="at least one component"):
        ss.Kernel.tabulated(OUTERMOST, (1.0, 1.0), {})
    with pytest.raises(ValueError, match="have the same shape"):
        ss.Kernel.tabulated(OUTERMOST, (1.0, 1.0), {"zz": np.zeros((2, 3)), "xx": np.zeros((3, 2))})
    kernel = ss.Kernel.isotropic(OUTERMOST, 0.4, response)
    with pytest.raises(ss.errors.IncompleteKernel) as caught:
        ss.HalfSpace(GRID, kernel.pair)
    assert "pass the kernel itself" in caught.value.part
    with pytest.raises(TypeError, match="cannot be pickled"):
        pickle.dumps(ss.HalfSpace(GRID, kernel))


NEAR = ss.ElasticPair(ss.Material(1.0, 0.5), RIGID)


def bed(grid, compliance=0.5, **options):
    """Creates a bed of springs along all directions."""
    operators = dict.fromkeys(["z", "xy"], lambda x: compliance * x)
    return ss.HalfSpace(grid, ss.Kernel.operators(NEAR, grid, operators, **options))


def test_spring_bed_matches_closed_form():
    grid, depth, shift = ss.Grid.square(32, 1.0), 0.06, 0.01
    bodies = bed(grid, lower_bounds={"z": 0.5, "xy": 0.5})
    ball = ss.surface.sphere(grid, 1.0)
    # Each cell carries p = (d - h) / c, and sticks if mu p > s / c.
    contact = ss.NormalProblem(bodies, ball, approach=depth).solve()
    pressure = np.maximum(depth - ball.array, 0.0) / 0.5
    assert np.abs(contact.pressure - pressure).max() < 1e-8 * pressure.max()
    # The caller has stated the bound.
    assert contact.report.eigenvalue_bound is ss.EigenvalueBound.STATED == "stated"
    assert "by the stated bound of the smallest eigenvalue" in repr(contact.report)
    shear = ss.TangentialProblem(bodies, contact, 0.5, shift_x=shift, shift_y=0.0, model="vector").solve()
    traction = np.minimum(shift / 0.5, 0.5 * pressure)
    assert np.abs(np.hypot(*shear.traction) - traction).max() < 1e-6 * traction.max()
    # Without a lower bound of the eigenvalue, the error bound is not proven.
    contact = ss.NormalProblem(bed(grid), ball, approach=depth).solve()
    assert np.abs(contact.pressure - pressure).max() < 1e-8 * pressure.max()
    assert contact.report.eigenvalue_bound is ss.EigenvalueBound.UNKNOWN


def test_half_space_operators_match_half_space(large, request):
    """Tests operators of the package, callables that threads of the pool call in turn, and a matrix."""
    before = ss.num_threads()
    ss.set_num_threads(2)
    request.addfinalizer(lambda: ss.set_num_threads(before))
    own, grid = large.bodies, large.grid
    known = {"z": own.operator("zz"), "x": own.operator("xx")}
    called = {name: lambda t, of=of: of(t) for name, of in known.items()}
    bounds = {name: of.lower_bound for name, of in known.items()}
    assert all(of.eigenvalue_bound == "proven" for of in known.values())
    expected = None
    for operators, options in ((None, {}), (known, {}), (called, {"lower_bounds": bounds})):
        kernel = own.pair if operators is None else ss.Kernel.operators(own.pair, grid, operators, **options)
        bodies = ss.HalfSpace(grid, kernel)
        history = ss.History(bodies, large.ball, 0.5, model="scalar", tolerance=1e-10)
        history.step(normal_force=100.0)
        history.step(force_x=20.0)
        expected = expected or history
        scale = expected.pressure.max()
        assert np.abs(history.pressure - expected.pressure).max() < 1e-7 * scale
        assert np.abs(history.traction[0] - expected.traction[0]).max() < 1e-7 * scale


def test_matrix_of_all_directions_replaces_bodies():
    grid = ss.Grid.square(8, 1.0)
    pair = ss.ElasticPair(ss.Material(1.0, 0.2), RIGID)
    own = ss.HalfSpace(grid, pair)
    tensor = own.tensor_operator()
    rows = [np.concatenate([u.ravel() for u in tensor.apply(tuple(unit))]) for unit in np.eye(192).reshape(192, 3, 8, 8)]
    matrix = ss.dense.DenseOperator(0.5 * (np.array(rows) + np.array(rows).T))
    ball = ss.surface.sphere(grid, 2.0)
    options = {"approach": 0.03, "force_x": 0.001, "tolerance": 1e-9}
    kernel = ss.Kernel.operators(pair, grid, {"xyz": matrix})
    found, expected = (ss.CoupledProblem(ss.HalfSpace(grid, of), ball, 0.4, **options).solve() for of in (kernel, pair))
    scale = expected.normal.pressure.max()
    assert np.abs(found.normal.pressure - expected.normal.pressure).max() < 1e-6 * scale
    assert np.abs(np.array(found.tangential.traction) - expected.tangential.traction).max() < 1e-6 * scale
    assert found.report.work.eigenvalue_bound == "proven"


class Stop(Exception):
    pass


@pytest.mark.parametrize("cells", [32, 128])
def test_operator_exception_is_raised_and_leaves_history_unchanged(cells, request):
    before = ss.num_threads()
    ss.set_num_threads(2)
    request.addfinalizer(lambda: ss.set_num_threads(before))
    grid, is_broken = ss.Grid.square(cells, 1.0), False

    def springs(x):
        assert x.shape == (1, cells, cells)
        if is_broken:
            raise Stop
        return 0.5 * x

    bodies = ss.HalfSpace(grid, ss.Kernel.operators(NEAR, grid, {"z": springs, "xy": lambda x: 0.5 * x}))
    history = ss.History(bodies, ss.surface.sphere(grid, 1.0), 0.5)
    history.step(approach=0.05)
    known = history.pressure.copy()
    is_broken = True
    with pytest.raises(Stop):
        history.step(approach=0.06)
    with pytest.raises(Stop):
        bodies.operator("zz")(np.ones(grid.shape))
    with pytest.raises(Stop):
        ss.Kernel.operators(NEAR, grid, {"z": springs})
    assert (history.pressure == known).all()
    is_broken = False
    history.step(approach=0.06)
    assert history.pressure.max() > known.max()


def test_concurrent_solves_keep_exceptions_separate(large, request):
    before = ss.num_threads()
    ss.set_num_threads(2)
    request.addfinalizer(lambda: ss.set_num_threads(before))
    of, pair, ended = large.bodies.operator("zz"), large.bodies.pair, {}

    def solve(number):
        products = 0

        def product(x):
            nonlocal products
            products += 1
            if number % 2 and products == 12:
                raise Stop(number)
            return of(x)

        bodies = ss.HalfSpace(large.grid, ss.Kernel.operators(pair, large.grid, {"z": product}))
        try:
            ended[number] = ss.NormalProblem(bodies, large.ball, force=100.0).solve().report.is_converged
        except Stop as stop:
            ended[number] = stop.args

    threads = [threading.Thread(target=solve, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert ended == {0: True, 1: (1,), 2: True, 3: (3,)}


def test_invalid_operators_are_rejected():
    grid = ss.Grid.square(16, 1.0)
    for operators, error, told in (
        ({}, ss.errors.IncompleteKernel, "at least one operator"),
        ({"w": lambda x: x}, ValueError, "letters x, y and z, got 'w'"),
        ({"": lambda x: x}, ValueError, "letters"),
        ({"xx": lambda x: x}, ss.errors.RepeatedDirection, None),
        ({"z": 1.0}, TypeError, "callable"),
        ({"z": lambda x: x[0, 0]}, ValueError, "16 numbers, expected 256"),
        ({"z": ss.cgm.identity(255)}, ValueError, "255 unknowns, expected 256"),
        ({"z": lambda x: -x}, ss.errors.NotPositive, None),
        ({"xy": lambda x: x + 0.5 * np.array([1, -1])[:, None, None] * x[::-1]}, ss.errors.UnsupportedByModel, "reciprocity"),
    ):
        with pytest.raises(error, match=told):
            ss.Kernel.operators(NEAR, grid, operators)
    with pytest.raises(ss.errors.BelowMinimum):
        bed(grid, 0.5, lower_bounds={"z": 0.6})
    for name, operator in (("y", lambda x: x), ("z", ss.cgm.identity(256))):
        with pytest.raises(ValueError, match="contains no callable"):
            ss.Kernel.operators(NEAR, grid, {"z": operator}, lower_bounds={name: 1.0})
    with pytest.raises(ss.errors.GridMismatch):
        ss.HalfSpace(ss.Grid.square(8, 1.0), ss.Kernel.operators(NEAR, grid, {"z": lambda x: x}))
    with pytest.raises(ss.errors.UnsupportedByModel, match="uniform traction"):
        ss.HalfSpace(grid, ss.Kernel.operators(NEAR, grid, {"z": lambda x: x}), boundary="periodic")
