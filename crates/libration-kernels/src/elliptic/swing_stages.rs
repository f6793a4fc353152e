//! Complete integrals for the periods of a block of swings, stage by stage.

use super::complete::{cosine_part_near, second_less_scaled_first_far};
use super::descent::Descent;
use super::modulus_stages::ModulusStages;
use super::nearer::Nearer;
use super::nome;
use crate::double_double::block::{BLOCK, Words};
use crate::double_double::pick;

/// The integrals of [`complete_and_nome`](super::complete_and_nome) for a block of moduli with nonzero complements.
#[derive(Debug)]
pub struct SwingStages {
    stages: ModulusStages,
    /// K.
    pub first: Words,
    /// (E − k′²K)/k².
    pub cosine_part: Words,
    pub nome: [f64; BLOCK],
}

impl SwingStages {
    pub const ZERO: Self = Self {
        stages: ModulusStages::ZERO,
        first: Words::ZERO,
        cosine_part: Words::ZERO,
        nome: [0.0; BLOCK],
    };

    /// Computes the integrals of the moduli k with their complements k′.
    #[inline(always)]
    pub fn block(&mut self, moduli: &Words, complements: &Words) {
        for i in 0..BLOCK {
            self.stages.set(i, Nearer::from_words(moduli.get(i), complements.get(i)));
        }
        self.stages.descend();
        self.stages.logarithms();
        for i in 0..BLOCK {
            self.integrals(i);
        }
        for i in 0..BLOCK {
            self.nome[i] = nome(&self.stages.nearer(i), &self.stages.descent(i), self.stages.log.get(i));
        }
    }

    #[inline(always)]
    fn integrals(&mut self, i: usize) {
        let (nearer, descent) = (self.stages.nearer(i), self.stages.descent(i));
        let (near, later) = (descent.near_quarter(), descent.later_differences(&nearer));
        let far = Descent::far_quarter(near, self.stages.log.get(i));
        let less = second_less_scaled_first_far(&nearer, near, later, far);
        let cosine_part_far = less.over(nearer.root.square());
        self.first.set(i, pick(nearer.above, far, near));
        self.cosine_part.set(i, pick(nearer.above, cosine_part_far, cosine_part_near(near, later)));
    }
}
