mod decimal;
mod derivative;
mod jet;
mod no_value;
mod normal_form;
mod overflow;
