"""Files that are written whole or not at all, and read within bounds: JSON and safetensors, never pickle."""
