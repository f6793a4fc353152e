//! The kinds of damping that a model has.

use libration::decay::DampingKind;
use libration_lab::fit::{DampingModel, DampingModelError, alternatives};

#[test]
fn a_kind_is_named_once() {
    let read = |text: &str| text.parse::<DampingModel>();
    assert_eq!(read("dry+Dry"), Err(DampingModelError::Repeated(DampingKind::Dry)));
    assert_eq!(read("quadratic+linear+quadratic"), Err(DampingModelError::Repeated(DampingKind::Quadratic)));
    assert_eq!(read("dry+"), Err(DampingModelError::Unknown(String::new())));
    assert_eq!(read("quadratic+dry+linear").map(DampingModel::count), Ok(3));
}

#[test]
fn models_are_listed_as_alternatives() {
    let all = DampingKind::ALL.map(DampingModel::only);
    assert_eq!(alternatives(&all), "dry, linear or quadratic");
    assert_eq!(alternatives(&all[..2]), "dry or linear");
    assert_eq!(alternatives(&all[..1]), "dry");
    assert_eq!(alternatives(&[]), "");
}

#[test]
fn a_model_is_part_of_those_that_have_its_terms_and_others() {
    for a in DampingModel::all() {
        for b in DampingModel::all() {
            let part = DampingKind::ALL.iter().all(|&term| !a.has(term) || b.has(term));
            assert_eq!(a.is_part_of(b), part, "{a} {b}");
        }
    }
    assert!(DampingModel::UNDAMPED.is_part_of(DampingModel::only(DampingKind::Dry)));
    assert!(!DampingModel::only(DampingKind::Dry).is_part_of(DampingModel::only(DampingKind::Quadratic)));
}
