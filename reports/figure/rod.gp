# Profiles along x: axes and key of Song's Figures 1, 3b and 4f.
set xlabel 'x  [m]'
set ylabel 'T  [K]' offset 1
set xrange [-2:2]
set yrange [-1:11]
