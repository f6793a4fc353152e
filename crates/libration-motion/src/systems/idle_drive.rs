//! A drive whose strength is zero.

use super::Model;
use libration_numbers::expression::Expression;

impl Model {
    /// The parameters of a named system that are zero and without which the equations would contain the time t: the strengths of a drive that is
    /// off. None if the equations contain the time, and for equations given as text.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::systems::Model;
    /// let off = Model::by_key("driven_pendulum", &[("c", "0.1".parse()?)], &[])?;
    /// assert_eq!(off.idle_drives(), ["A"]);
    /// let driven = Model::by_key("driven_pendulum", &[("A", "0.1".parse()?)], &[])?;
    /// assert!(driven.idle_drives().is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn idle_drives(&self) -> Vec<String> {
        let Some(key) = self.key().filter(|_| !self.equation().depends_on_time()) else { return vec![] };
        let zero =
            |(name, _): &&(String, Expression)| self.value_of(name).is_some_and(|value| value.abs() <= 0.0);
        let drives = |name: &&str| {
            let others = self.values().iter().filter(|(other, _)| other != name);
            let values: Vec<(&str, Expression)> =
                others.map(|(other, value)| (other.as_str(), value.clone())).collect();
            let left_open = self.open_parameters();
            let open: Vec<&str> = left_open.iter().map(String::as_str).chain([*name]).collect();
            Self::by_key(key, &values, &open).is_ok_and(|model| model.equation().depends_on_time())
        };
        let names = self.values().iter().filter(zero).map(|(name, _)| name.as_str());
        names.filter(drives).map(str::to_owned).collect()
    }
}
