"""What runs in the browser, and widgets: each takes values and returns the input of the user."""
