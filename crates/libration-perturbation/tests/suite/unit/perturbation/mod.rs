mod certificate;
mod gauge;
mod open_gauge;
mod slow_flow;
