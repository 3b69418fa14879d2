"""Judgements of a monitor, the limits they are judged by, episodes, and what people are told of them."""
