# The patch on its ring, exact and by three methods, in one scale of colours: what is below the range of the start is
# blue.
name = 'field_patch'
wide = 1180; high = 470
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
unset key
unset grid
set multiplot layout 1,4 margins screen 0.06, 0.915, 0.25, 0.85 spacing screen 0.012, 0.05
set size ratio -1
set xrange [-1:0.1]
set yrange [-0.8:0.8]
set cbrange [0.92:1.32]
set palette defined (0.92 '#0072B2', 0.995 '#cfe8f7', 1 '#ffffff', 1.005 '#fdf0d5', 1.15 '#E69F00', 1.32 '#8c2d04')
set cblabel 'T  [K]' offset 0.5
set xtics -0.8, 0.4, 0
set xlabel 'x  [m]'
blocks = '"faces exact" "faces computed" "corners" "so_ssph"'
titles = '"exact" "ftcs, faces" "ftcs, corners" "so_ssph"'
do for [k = 1:4] {
    set title word(titles, k) noenhanced font size_of(11) offset 0,-0.6
    if (k == 1) { set ylabel 'y  [m]' offset 1 } else { unset ylabel; set format y '' }
    if (k == 4) { set colorbox user origin screen 0.925, 0.28 size screen 0.013, 0.54 } else { unset colorbox }
    plot data index word(blocks, k) using 1:(abs($3 - 1) < 0.003 ? NaN : $2):3 with points pt 5 ps (k == 1 ? 0.75 : 0.9) * P lc palette
    unset label 98; unset label 99
}
unset multiplot
