mod jumps;
mod multiple_shooting;
mod newton_step;
