"""How the objects look, and what a double-click does."""
