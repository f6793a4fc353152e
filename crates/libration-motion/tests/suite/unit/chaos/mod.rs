mod lyapunov;
mod structure;
