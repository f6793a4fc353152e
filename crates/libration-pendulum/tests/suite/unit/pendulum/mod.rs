mod approximate_motion;
mod period;
mod periods;
mod table;
