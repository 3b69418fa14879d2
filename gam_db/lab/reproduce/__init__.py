"""The paper's experiments, run again: what comes out, beside what the paper prints.

* ``table1`` and ``table3``: the simulated fleet in the place of the paper's, all eleven methods, and
  networks that read a long context, with a paired bootstrap over the joints that failed;
* ``table2``: the Langevin system, all eleven methods, some seeds;
* ``training``: the same for networks that are trained for 1, 5, 20 and 100 epochs;
* ``figures``: the paper's figures, drawn from results;
* ``recordings``: the same on real machines, with the chance level;
* ``sensitivity``: Global over m and tau, with the certificate's floor beside it.

Nothing here is tuned until the paper's order appears: what the paper leaves open was set once, and is
said on the page. ``methods`` is the list of methods, ``results`` the files in which results are kept.
"""
