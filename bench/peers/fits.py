"""The script of bench/lab as a module: its name is that of a module in this folder."""
import importlib.util
import sys
from pathlib import Path

SPEC = importlib.util.spec_from_file_location("lab", Path(__file__).resolve().parents[1] / "lab/run.py")
lab = importlib.util.module_from_spec(SPEC)
# Its dataclasses look it up by name.
sys.modules["lab"] = lab
SPEC.loader.exec_module(lab)
