mod backbone;
mod enclosed;
mod quantity;
mod relation;
mod work;
