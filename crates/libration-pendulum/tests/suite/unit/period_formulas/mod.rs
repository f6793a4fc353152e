mod error;
mod maximum;
