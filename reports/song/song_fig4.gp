# Song 2018, Figure 4a-e
name = 'song_fig4'
wide = 1080
high = 780
load 'reports/figure/style.gp'
unset label 99
unset bmargin
unset title
set xrange [-1.25:1.25]
set yrange [-1.25:1.25]
set xtics 0.5
set ytics 0.5
set size ratio -1
set key off
set multiplot layout 2, 3 title heading noenhanced font size_of(13) margins 0.075, 0.985, 0.15, 0.89 spacing 0.03, 0.14
do for [i = 1:5] {
    time = word('1 2 3 4 5', i)
    error = system(sprintf("grep -A 3 '^# %s s error$' '%s' | tail -n 1", time, data))
    set title sprintf('(%s)  t = %s s,  E = %.1f %%', word('a b c d e', i), time, error + 0) font size_of(12) offset 0, -0.6
    set xlabel i > 2 ? 'x  [m]' : ''
    set ylabel (i == 1 || i == 4) ? 'y  [m]' : ''
    # the exact one broad and light, ours thin on it: neither hides the other
    plot data index time . ' s exact' using 1:2 with lines lw 4.5 lc rgb '#c9c9c9', \
         data index time . ' s computed' using 1:2 with lines lw 1.1 lc rgb BLUE, \
         data index time . ' s levels' using 1:2 with points pt 7 ps 1.8 * P lc rgb 'white', \
         data index time . ' s levels' using 1:2:3 with labels font size_of(9) tc rgb '#222222'
}
set title ''
set xlabel ''
set ylabel ''
unset border
unset tics
unset grid
set label 99 caption at screen 0.012, screen 0.045 left noenhanced font size_of(8.5) textcolor rgb '#555555'
set key on at graph 0.05, 0.75 left Left reverse samplen 3 spacing 1.6
set label 1 "numbers: temperature, K" at graph 0.07, 0.36 font size_of(11)
plot NaN with lines lw 1.1 lc rgb BLUE title sprintf('SO-SSPH, dx = %s m', option('dx')), \
     NaN with lines lw 4.5 lc rgb '#c9c9c9' title 'exact'
unset multiplot
