"""The benchmark of alarms: is the stated rate of false alarms kept, and is wear seen?

Simulated fleets are read by the product, fleet by fleet, and its tables put together; limits, judgements
and episodes are then the product's own steps over these tables. Nothing here knows the rule.

* ``plan``: which fleets; ``tables``: what the product says of them; ``fleets``: from one to the other;
* ``figures``: promise, wear; ``rivals``: today's limit, the control, other estimators;
* ``measure``: the order of work; ``report``: how it is said;
* ``programs``: the same of several products, with and without the column that says which.
"""
