mod multiple_shooting;
mod newton_step;
