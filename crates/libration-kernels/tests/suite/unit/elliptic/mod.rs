mod descent;
mod rounded;
mod theta;
