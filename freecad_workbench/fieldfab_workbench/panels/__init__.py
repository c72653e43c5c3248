"""The task panels."""
