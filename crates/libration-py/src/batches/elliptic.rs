//! Elliptic integrals and functions of the parameter, of its complement, or of the complementary modulus.

use libration::elliptic::{
    JacobiSlices, LengthMismatch, Moduli, Modulus, complete_firsts, complete_seconds, incomplete_firsts,
    incomplete_seconds, jacobi_functions, nomes,
};
use pyo3::prelude::*;

use super::{add, documented};

pub(super) fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    by_parameter(module)?;
    by_complementary_modulus(module)?;
    add(module, documented!("ellipkm1"), |[p], [k]| complete_firsts(Moduli::ComplementaryParameters(p), k))?;
    add(module, documented!("inverse_nome"), |[q], [m]| of_nome(q, m, Modulus::parameter))?;
    add(module, documented!("inverse_nome_kp"), |[q], [kp]| of_nome(q, kp, Modulus::complementary_modulus))
}

fn by_parameter(module: &Bound<'_, PyModule>) -> PyResult<()> {
    add(module, documented!("ellipk"), |[m], [k]| complete_firsts(Moduli::Parameters(m), k))?;
    add(module, documented!("ellipe"), |[m], [e]| complete_seconds(Moduli::Parameters(m), e))?;
    add(module, documented!("ellipkinc"), |[phi, m], [f]| incomplete_firsts(phi, Moduli::Parameters(m), f))?;
    add(module, documented!("ellipeinc"), |[phi, m], [e]| incomplete_seconds(phi, Moduli::Parameters(m), e))?;
    add(module, documented!("ellipj"), |[u, m], [sn, cn, dn, am]| {
        jacobi_functions(u, Moduli::Parameters(m), JacobiSlices { sn, cn, dn, am })
    })?;
    add(module, documented!("ellipnome"), |[m], [q]| nomes(Moduli::Parameters(m), q))
}

fn by_complementary_modulus(module: &Bound<'_, PyModule>) -> PyResult<()> {
    add(module, documented!("ellipk_kp"), |[kp], [k]| complete_firsts(Moduli::ComplementaryModuli(kp), k))?;
    add(module, documented!("ellipe_kp"), |[kp], [e]| complete_seconds(Moduli::ComplementaryModuli(kp), e))?;
    add(module, documented!("ellipkinc_kp"), |[phi, kp], [f]| {
        incomplete_firsts(phi, Moduli::ComplementaryModuli(kp), f)
    })?;
    add(module, documented!("ellipeinc_kp"), |[phi, kp], [e]| {
        incomplete_seconds(phi, Moduli::ComplementaryModuli(kp), e)
    })?;
    add(module, documented!("ellipj_kp"), |[u, kp], [sn, cn, dn, am]| {
        jacobi_functions(u, Moduli::ComplementaryModuli(kp), JacobiSlices { sn, cn, dn, am })
    })?;
    add(module, documented!("ellipnome_kp"), |[kp], [q]| nomes(Moduli::ComplementaryModuli(kp), q))
}

/// A property of the modulus with each nome; NaN if the modulus does not exist.
fn of_nome(nomes: &[f64], values: &mut [f64], says: fn(&Modulus) -> f64) -> Result<(), LengthMismatch> {
    for (nome, value) in nomes.iter().zip(values) {
        *value = Modulus::from_nome(*nome).map_or(f64::NAN, |modulus| says(&modulus));
    }
    Ok(())
}
