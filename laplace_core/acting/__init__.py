"""Acting: control rules, whole episodes, what they return, and what really follows a step."""
