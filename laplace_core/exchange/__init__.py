"""What goes to and fro between a browser and what answers it: links, states with their payloads, reports of widgets."""
