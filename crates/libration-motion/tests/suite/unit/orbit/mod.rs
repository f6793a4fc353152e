mod least_period;
mod precise;
