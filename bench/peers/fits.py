"""The script of bench/lab as a module: it has the name of one that stands here."""
import importlib.util
import sys
from pathlib import Path

SPEC = importlib.util.spec_from_file_location("lab", Path(__file__).resolve().parents[1] / "lab/run.py")
lab = importlib.util.module_from_spec(SPEC)
# Its dataclasses look for it by its name.
sys.modules["lab"] = lab
SPEC.loader.exec_module(lab)
