"""The Python package against the command line, and its conduct. The program is $SBEH."""

import os
import signal
import subprocess
import sys
import threading
import time
import warnings
from pathlib import Path

import numpy as np
import pandas
import pytest

import sbeh

PROGRAM = os.environ["SBEH"]
sbeh.tell_to(lambda text: None)


def command(*words, cwd):
    return subprocess.run([PROGRAM, *words], cwd=cwd, capture_output=True, text=True)


def same_table(ours, path):
    theirs = pandas.read_csv(path, float_precision="round_trip", keep_default_na=False, na_values=["", "nan"])
    drop = [name for name in ("wall_seconds",) if name in theirs]
    pandas.testing.assert_frame_equal(ours.drop(columns=drop), theirs.drop(columns=drop), check_exact=True)


SCAN = """[scan]
reduced_volume = [0.6, 0.75]
L = [0.01, 0.05]
branches = ["oblate", "prolate"]
[material]
residual_stiffness = 0.001
"""


@pytest.fixture(scope="module")
def small_scan():
    return sbeh.scan([0.6, 0.75], np.array([0.01, 0.05]), branches=["oblate", "prolate"],
                     material=sbeh.Material(residual_stiffness=0.001))


def test_a_scan_has_the_numbers_of_the_command_line(small_scan, tmp_path):
    (tmp_path / "in.toml").write_text(SCAN)
    assert command("scan", "in.toml", "-o", "out", "--no-pictures", cwd=tmp_path).returncode == 0
    same_table(small_scan.table, tmp_path / "out/scan.csv")
    same_table(small_scan.folds, tmp_path / "out/folds.csv")
    same_table(small_scan.stability_lines, tmp_path / "out/stability_lines.csv")
    same_table(sbeh.read_scan(tmp_path / "out").lowest, tmp_path / "out/lowest.csv")
    assert "16 stationary" in repr(small_scan)


def test_a_state_is_the_row_of_a_scan():
    state = sbeh.stationary("prolate", reduced_volume=0.75, L=0.05, material={"spontaneous_curvature": 0.3})
    scan = sbeh.scan(0.75, 0.05, models=["SBEH"], branches=["prolate"], material={"spontaneous_curvature": 0.3})
    row = scan.table.iloc[0].to_dict()
    assert {key: value for key, value in state.row.items() if key != "wall_seconds"} == {
        key: None if pandas.isna(value) else value for key, value in row.items() if key != "wall_seconds"}
    assert state.status == "stationary"
    profile = scan.profile(reduced_volume=0.75, L=0.05, branch="prolate")
    np.testing.assert_array_equal(state.r, profile.r)
    area = np.trapz(2 * np.pi * state.r, state.arc_length)
    assert area == pytest.approx(4 * np.pi, rel=2e-3)
    assert state.r.shape == state.order.shape == (3 * 48 + 1,)


def test_a_state_that_is_not_there_says_so():
    with pytest.warns(UserWarning, match="fold"):
        state = sbeh.stationary("oblate", reduced_volume=0.6, L=0.08)
    assert state.status == "unresolved"
    assert "fold" in state.stop_reason


def test_modes_are_those_of_the_command_line(tmp_path):
    modes = sbeh.modes("oblate", reduced_volume=0.8, L=0.05, model="SSH", largest_m=2, fluctuations=0.01)
    done = command("modes", "--model", "SSH", "--branch", "oblate", "--reduced-volume", "0.8", "--L", "0.05", "--largest-m",
                   "2", "--fluctuations", "0.01", "-o", "out", "--no-pictures", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    same_table(modes.table, tmp_path / "out/modes.csv")
    same_table(modes.contour, tmp_path / "out/contour.csv")
    assert modes.rigid_residual < 1e-6


def test_rest_states_are_those_of_the_command_line(tmp_path):
    states = sbeh.rest_states(branch="oblate", reduced_volume=[0.8, 0.85], L=0.05, model="SSH", triangles=80, eigenpairs=2)
    (tmp_path / "in.toml").write_text('[states]\nmodel = "SSH"\nbranch = "oblate"\nreduced_volume = [0.8, 0.85]\n'
                                      "L = 0.05\ntriangles = 80\neigenpairs = 2\n")
    done = command("states", "in.toml", "-o", "out", "--no-pictures", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    same_table(states.table, tmp_path / "out/states.csv")
    assert len(states.frame(2).points) == 9 * states.table.triangles[1] / 2 + 2
    assert states.mode_file(2, 1).exists()


def test_a_run_finished_by_newton_has_a_state_at_rest():
    run = sbeh.run({"shape": "ellipsoid", "reduced_volume": 0.9, "kind": "prolate", "triangles": 80},
                   {"end": 100, "finish": "newton", "output": [0.1], "frames": [0]}, model="SSH",
                   numerics={"tolerance": 1e-3})
    assert run.end["stop"] == "near rest" and run.end["ended_well"]
    assert run.rest.table.negative_directions[0] == 0
    assert run.rest.table.energy[0] < run.series.energy.iloc[-1]


RELAX = """model = "SSH"
[start]
shape = "ellipsoid"
reduced_volume = 0.8
[time]
end = 0.5
[material]
L = 0.04
"""


def test_an_evolution_is_that_of_the_command_line(tmp_path):
    (tmp_path / "in.toml").write_text(RELAX)
    command("relax", "in.toml", "-o", "out", "--no-pictures", cwd=tmp_path)
    ours = sbeh.relax({"shape": "ellipsoid", "reduced_volume": 0.8}, {"end": 0.5}, model="SSH", material={"L": 0.04})
    same_table(ours.series, tmp_path / "out/series.csv")
    assert ours.end["stop"] == "end time reached"
    assert [time for time, _ in ours.profiles] == [time for time, _ in sbeh.read_evolution(tmp_path / "out").profiles]


SURFACE = {"shape": "ellipsoid", "reduced_volume": 0.85, "triangles": 80}


def test_a_run_that_is_stepped_is_the_run_of_the_command_line(tmp_path):
    (tmp_path / "in.toml").write_text('model = "SBEH"\n[surface]\nshape = "ellipsoid"\nreduced_volume = 0.85\ntriangles = 80\n'
                                      "[time]\nend = 0.01\nframes = [0.01]\noutput = [0.01]\n")
    assert command("run", "in.toml", "-o", "out", "--no-pictures", cwd=tmp_path).returncode == 0
    theirs = sbeh.read_run(tmp_path / "out")
    run, times = sbeh.Run(SURFACE, model="SBEH"), []
    assert run.advance(until=0.01, steps=3) == ""
    assert run.advance(until=0.01, after_step=lambda run: times.append(run.time)) == "end time reached"
    frame = theirs.frame(-1)
    np.testing.assert_array_equal(run.points, frame.points)
    np.testing.assert_array_equal(run.order, frame.fields["order"])
    np.testing.assert_array_equal(run.mean_curvature, frame.fields["mean_curvature"])
    assert times == sorted(times) and times[-1] == frame.time == 0.01
    assert run.measures()["energy"] == theirs.series["energy"].iloc[-1]
    assert frame.model == "SBEH" and frame.material == sbeh.Material()
    run.write_frame(tmp_path / "frame.vtu")
    np.testing.assert_array_equal(sbeh.read_frame(tmp_path / "frame.vtu").points, run.points)


def test_a_callback_may_end_a_run_and_its_errors_come_through():
    run = sbeh.Run(SURFACE, model="SBEH")
    assert run.advance(until=1, after_step=lambda run: run.time < 1e-4) == ""
    assert 1e-4 <= run.time < 1e-2

    def fail(run):
        raise RuntimeError("of the caller")

    with pytest.raises(RuntimeError, match="of the caller"):
        run.advance(until=1, after_step=fail)
    run.advance(until=1, steps=1)  # and it can go on


VESICLE = {"radius_um": 10, "bending_rigidity_kT": 20, "surface_viscosity": 5e-10}


def test_tables_in_physical_units_are_those_of_the_command_line(small_scan, tmp_path):
    table = small_scan.physical("scan.csv", VESICLE)
    kappa = 2 * table["L"] + 0.001
    np.testing.assert_allclose(table["energy_kT"], small_scan.table["energy"] * 20 / kappa, rtol=1e-13)
    (tmp_path / "units.toml").write_text("[units]\nradius_um = 10\nbending_rigidity_kT = 20\n"
                                         "surface_viscosity = 5e-10\n")
    assert command("units", str(small_scan.folder), "--units-from", "units.toml", "-o", "out",
                   cwd=tmp_path).returncode == 0
    same_table(table, tmp_path / "out/scan.csv")
    assert small_scan.physical("scan.csv", tmp_path / "units.toml").equals(table)
    assert any("20 k_BT" in line for line in small_scan.describe_units(VESICLE))
    with pytest.raises(sbeh.InputError, match="has no \\[units\\]"):
        small_scan.physical("scan.csv")
    with pytest.raises(sbeh.InputError, match="radius_um: missing"):
        small_scan.physical("scan.csv", {"bending_rigidity_kT": 20})
    assert "trace" in sbeh.conventions


def test_an_evolution_may_be_asked_for_in_seconds():
    run = sbeh.relax({"shape": "ellipsoid", "reduced_volume": 0.9}, {"end": "5 ms", "stop_at_rest": False},
                     model="SSH", material={"L": 0.05}, numerics={"elements": 8}, units=VESICLE)
    assert run.physical("series.csv")["time_s"].iloc[-1] == pytest.approx(5e-3, rel=1e-12)


def test_a_mesh_is_curved_and_closed(tmp_path):
    mesh = sbeh.mesh("ellipsoid", reduced_volume=0.8, triangles=320)
    assert mesh.triangles.shape == (320, 10) and mesh.points.shape[1] == 3
    assert mesh.quality["reduced_volume"] == pytest.approx(0.8, abs=1e-12)
    plain = mesh.plain_triangles()
    assert plain.shape == (9 * 320, 3)
    corners = mesh.points[plain]
    volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert volume == pytest.approx(mesh.quality["volume"], rel=1e-2)
    mesh.write(tmp_path / "mesh.vtu")
    again = sbeh.mesh("file", path=tmp_path / "mesh.vtu")
    np.testing.assert_array_equal(again.points, mesh.points)
    mesh.write(tmp_path / "mesh.stl")
    grid = pytest.importorskip("vtk") and mesh.to_vtk()
    assert grid.GetNumberOfCells() == 320


@pytest.mark.parametrize("call, what", [
    (lambda: sbeh.scan([1.2], [0.05]), r"scan\(\): \[scan\] reduced_volume = 1.2: must be > 0 and <= 1"),
    (lambda: sbeh.scan([0.8], [0.05], branches=["oblat"]), r'branches.*must be one of "oblate"'),
    (lambda: sbeh.scan([0.8], [0.05], material={"viscosty": 1}), r'viscosty: unknown key; did you mean "viscosity"'),
    (lambda: sbeh.scan([0.8], [0.05], material=sbeh.Material(L1=0.05, L3=0.02)), "L2 and L3 must be 0"),
    (lambda: sbeh.relax({"shape": "ellipsoid"}, {"end": 1}, model="SSH"), r"relax\(\).*reduced_volume"),
    (lambda: sbeh.run({"shape": "elipsoid"}, {"end": 1}, model="SSH"), r"run\(\): \[surface\] shape"),
    (lambda: sbeh.mesh("cube"), "must be one of sphere"),
    (lambda: sbeh.mesh("file"), "path: is missing"),
    (lambda: sbeh.stationary("oblate", reduced_volume=0.8, L=-1), "L1|l1"),
    (lambda: sbeh.stationary("oblong", reduced_volume=0.8, L=0.1), "oblong"),
    (lambda: sbeh.stationary("oblate", reduced_volume=1.8, L=0.1), "reduced_volume"),
    (lambda: sbeh.Material(viscosity=-1), "viscosity"),
    (lambda: sbeh.read_frame("nowhere.vtu"), "nowhere.vtu"),
])
def test_wrong_input_is_told_as_on_the_command_line(call, what):
    with pytest.raises(ValueError, match=what):
        call()


def test_what_is_not_there_is_told():
    with pytest.raises(OSError, match="holds no scan"):
        sbeh.read_scan("nowhere")
    with pytest.raises(OSError, match="is not there"):
        sbeh.read_series("nowhere")


def test_results_are_not_overwritten(tmp_path):
    sbeh.relax({"shape": "ellipsoid", "reduced_volume": 0.9}, {"end": 0.001}, model="SSH", folder=tmp_path / "out")
    with pytest.raises(sbeh.OutputError, match="already holds"):
        sbeh.relax({"shape": "ellipsoid", "reduced_volume": 0.9}, {"end": 0.002}, model="SSH", folder=tmp_path / "out")


def test_an_end_that_is_not_to_be_trusted_warns():
    with pytest.warns(UserWarning, match="touches itself|passes through"):
        sbeh.relax({"shape": "ellipsoid", "reduced_volume": 0.4}, {"end": 30}, model="SSH", material={"L": 0.05})


def test_interrupts_end_the_work_and_nothing_else(tmp_path):
    timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    before, begun = signal.getsignal(signal.SIGINT), time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        sbeh.scan({"from": 0.6, "to": 0.95, "count": 60}, {"from": 0.005, "to": 0.1, "count": 60},
                  folder=tmp_path / "out", threads=1)
    assert time.monotonic() - begun < 5
    assert signal.getsignal(signal.SIGINT) is before
    sbeh.stationary("oblate", reduced_volume=0.9, L=0.05)  # what comes after is not interrupted


def test_other_threads_go_on_while_it_computes():
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.002)

    thread = threading.Thread(target=tick)
    thread.start()
    begun = time.monotonic()
    sbeh.scan({"from": 0.7, "to": 0.9, "count": 4}, [0.01, 0.03, 0.05], threads=1)
    took = time.monotonic() - begun
    done.set()
    thread.join()
    assert len(ticks) > 5 * took  # of up to 500 a second: locked there would be none


def test_messages_go_to_a_listener():
    heard = []
    sbeh.tell_to(heard.append)
    sbeh.scan([0.7, 0.8], [0.01, 0.03])
    sbeh.tell_to(lambda text: None)
    assert "per second" in "".join(heard)


def test_the_package_loads_fast():
    code = "import sys, time; t = time.perf_counter(); import sbeh; print(time.perf_counter() - t, 'pandas' in sys.modules)"
    seconds, pandas_too = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert pandas_too == "False"


def test_the_stub_says_what_the_compiled_half_has():
    import ast

    from sbeh import _sbeh

    stub = ast.parse((Path(sbeh.__file__).parent / "_sbeh.pyi").read_text())
    said = {node.name: node for node in stub.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert set(said) | {"version", "conventions"} == {name for name in dir(_sbeh) if not name.startswith("_")}
    for name in ("Material", "State", "Run"):
        assert {node.name for node in said[name].body if node.name != "__init__"} == {
            member for member in dir(getattr(_sbeh, name)) if not member.startswith("__")}


def test_pictures_can_be_drawn(small_scan):
    import matplotlib

    matplotlib.use("Agg")
    from sbeh import plot

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plot.diagram(small_scan).figure.canvas.draw()
        plot.profile(small_scan.profile(reduced_volume=0.75, L=0.05)).figure.canvas.draw()
        evolution = sbeh.relax({"shape": "ellipsoid", "reduced_volume": 0.9}, {"end": 0.01}, model="SBEH")
        plot.series(evolution.series, ["energy", "order_mean"]).figure.canvas.draw()
        plot.surface(sbeh.Run(SURFACE, model="SBEH").frame()).figure.canvas.draw()
    with pytest.raises(ValueError, match="no SBEH stomatocyte"):
        plot.diagram(small_scan, branch="stomatocyte")
