"""The exchange between a browser and the server: links, states with their payloads, reports of widgets."""
