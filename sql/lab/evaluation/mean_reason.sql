-- Mean reason: why there is no mean over series; each series has its own reason.
'no_series'
