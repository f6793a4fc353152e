//! Mirror images of states.

/// The mirror image of states: some components change their sign, counted from a centre.
#[derive(Clone, Debug)]
pub(super) struct Mirror {
    signs: Vec<f64>,
    /// Zero in the components that keep their sign.
    centre: Vec<f64>,
}

impl Mirror {
    /// The image with these signs and this centre, by components of a state.
    pub(super) fn new(signs: Vec<f64>, centre: &[f64]) -> Self {
        let mirrored = |(sign, centre): (&f64, &f64)| if *sign < 0.0 { *centre } else { 0.0 };
        let centre = signs.iter().zip(centre).map(mirrored).collect();
        Self { signs, centre }
    }

    /// The sign that the image gives to deviations of a component.
    pub(super) fn sign(&self, component: usize) -> f64 {
        self.signs[component]
    }

    /// The image of a value of a component.
    pub(super) fn image(&self, component: usize, value: f64) -> f64 {
        let sign = self.signs[component];
        sign * value + (1.0 - sign) * self.centre[component]
    }

    /// The image of a state.
    pub(super) fn image_of(&self, state: &[f64]) -> Vec<f64> {
        state.iter().enumerate().map(|(component, value)| self.image(component, *value)).collect()
    }

    /// The equilibrium that is the nearest to zero and its own mirror image.
    pub(super) fn rest(&self) -> &[f64] {
        &self.centre
    }

    /// The centre: the only state that is its own mirror image at all times, if the image changes all components.
    pub(super) fn fixed_state(&self) -> Option<&[f64]> {
        self.signs.iter().all(|sign| *sign < 0.0).then_some(&self.centre)
    }

    /// Returns `true` if the image is counted from zero.
    pub(super) fn is_about_zero(&self) -> bool {
        self.centre.iter().all(|x| *x == 0.0)
    }
}
