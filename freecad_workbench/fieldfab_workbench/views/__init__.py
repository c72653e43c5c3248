"""View providers: display of the objects and reaction to double clicks."""
