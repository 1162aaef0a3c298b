"""The risk of the automatic mesh: judged from what was measured, by a model learned from the solver, and in words."""
