"""A study: from settings to a decoded tau-space, the values and the action of every horizon, and what is wrong with
them."""
