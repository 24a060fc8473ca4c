"""Charts, drawn by Matplotlib: each for several widths, of which a page shows the one that fits.

scales says what axes show, labels where names have room, drawing makes of what Matplotlib draws a part of a page, frontier and
prediction draw the two kinds of charts.
"""
