"""The state tables themselves: their names, how they are made, who may do what, how they are copied."""
