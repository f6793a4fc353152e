"""Elliptic integrals and functions for 0 ≤ m ≤ 1, as ufuncs.

Names, order of arguments and results are SciPy's. Functions whose names end in ``_kp`` take the
complementary modulus k' = √(1 - m) in the place of the parameter m: close to k = 1 it is the number
that matters, and a rounded m has lost it.

>>> from libration.special import ellipk, ellipk_kp
>>> float(ellipk(0.5))
1.8540746773013719
>>> float(ellipk_kp(1e-20))
47.4379962210008
"""

from ._native import (
    ellipe,
    ellipe_kp,
    ellipeinc,
    ellipeinc_kp,
    ellipj,
    ellipj_kp,
    ellipk,
    ellipk_kp,
    ellipkinc,
    ellipkinc_kp,
    ellipkm1,
    ellipnome,
    ellipnome_kp,
    inverse_nome,
    inverse_nome_kp,
)

__all__ = [
    "ellipe",
    "ellipe_kp",
    "ellipeinc",
    "ellipeinc_kp",
    "ellipj",
    "ellipj_kp",
    "ellipk",
    "ellipk_kp",
    "ellipkinc",
    "ellipkinc_kp",
    "ellipkm1",
    "ellipnome",
    "ellipnome_kp",
    "inverse_nome",
    "inverse_nome_kp",
]
