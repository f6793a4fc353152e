mod characteristic;
mod eigenvalues;
mod elimination;
mod least_squares;
