# The largest Euler step against the angle of the field.
name = 'field_step'
high = 545
keys = 3
load 'reports/figure/style.gp'
set xlabel 'angle of b with the axis x  [degrees]'
set ylabel 'dt κ∥/dx²  [-]' offset 0.5
set xrange [0:90]
set yrange [0.3:1.1]
set xtics 15
methods = 'faces corners so_ssph'
colour(m) = m == 1 ? RED : m == 2 ? BLUE : GREEN
mark(m) = m == 1 ? 7 : m == 2 ? 5 : 9
open(m) = m == 1 ? 6 : m == 2 ? 4 : 8
plot for [m = 1:3] data index '0.01, '.word(methods, m) using 1:2 with linespoints lc rgb colour(m) pt mark(m) \
        ps 0.7 * P lw 1.3 title word(methods, m).', κ⊥/κ∥ = 0.01', \
    for [m = 1:3] data index '0.3, '.word(methods, m) using 1:2 with linespoints lc rgb colour(m) pt open(m) \
        ps 0.7 * P lw 1.1 dt 2 title word(methods, m).', 0.3'
