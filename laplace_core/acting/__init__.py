"""Acting: control rules, whole episodes and their returns, and simulated continuations of a step."""
