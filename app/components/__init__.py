"""What runs in the browser, and widgets: each takes values and returns what a person did."""
