"""Voussoir from Python: scenes, runs, results, sweeps. README.md of the folder above shows each by an example."""

from .program import InputError, ResourceError, VoussoirError
from .result import BONDED, OPEN, SLIP, STICK, Result
from .running import Progress, run, validate
from .scene import Scene
from .sweeping import sweep

__all__ = ["BONDED", "InputError", "OPEN", "Progress", "ResourceError", "Result", "SLIP", "STICK", "Scene", "VoussoirError",
           "run", "sweep", "validate"]
