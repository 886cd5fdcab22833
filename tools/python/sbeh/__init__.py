"""Shapes and dynamics of fluid lipid membranes with liquid-crystalline order.

    import sbeh
    state = sbeh.stationary("oblate", reduced_volume=0.7, L=0.05)
    scan = sbeh.scan(reduced_volume=[0.6, 0.7, 0.8], L=[0.01, 0.05])
    scan.table                      # a pandas frame
    run = sbeh.Run({"shape": "ellipsoid", "reduced_volume": 0.8}, model="SBEH")
    run.advance(until=0.1)          # 3D

All numbers are dimensionless: lengths in radii R of the sphere of equal area, energies in units of the depth of
the potential times R^2; `physical` of a result gives its tables in micrometres, kT and seconds, and `units` of a
function the vesicle, so that `{"end": "2 s"}` can be given too. `conventions` says how numbers are meant. The mean curvature H is the trace of the shape operator, -2 on the unit sphere.
They are those of the command line, to the bit. Wrong input raises `InputError`, a `ValueError` with the
sentences of the command line; Ctrl-C works while something is computed.
"""

import sys as _sys

from ._sbeh import InputError, Material, OutputError, tell_to
from ._sbeh import conventions
from ._sbeh import version as __version__
from .evolutions import Evolution, Run, Run3d, read_evolution, read_run, relax, run
from .rest_states import RestStates, rest_states
from .scans import Scan, read_scan, scan
from .states import Modes, Profile, State, modes, stationary
from .surfaces import Frame, Mesh, mesh, read_frame
from .tables import read_series

__all__ = [
    "Evolution", "Frame", "InputError", "Material", "Mesh", "Modes", "OutputError", "Profile", "RestStates", "Run", "Run3d",
    "Scan", "State", "__version__", "conventions", "mesh", "modes", "read_evolution", "read_frame", "read_run", "read_scan",
    "read_series", "relax", "rest_states", "run", "scan", "stationary", "tell_to",
]

if "ipykernel" in _sys.modules:  # a notebook shows what Python writes, and nothing else
    def _show(text: str) -> None:
        _sys.stderr.write(text)

    tell_to(_show)
