"""The paper's experiments, run again: what comes out, beside what the paper prints.

* ``table2``: the Langevin system, all eleven methods, some seeds;
* ``recordings``: the same on real machines, with the chance level;
* ``sensitivity``: Global over m and tau, with the certificate's floor beside it.

Nothing here is tuned until the paper's order appears: what the paper leaves open was set once, and is
said on the page. ``methods`` is the list of methods, ``results`` the files in which results are kept.
"""
