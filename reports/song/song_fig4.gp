# Song 2018, Figure 4a-e
name = 'song_fig4'
wide = 1080
high = 780
load 'reports/page/style.gp'
unset label 99
unset bmargin
unset title
set xrange [-1.25:1.25]
set yrange [-1.25:1.25]
set xtics 0.5
set ytics 0.5
set size ratio -1
set key off
set palette defined (1 '#56B4E9', 3 '#0072B2', 5 '#CC79A7', 7 '#E69F00', 9 '#D55E00')
set cbrange [1:9]
unset colorbox
set multiplot layout 2, 3 title heading noenhanced font size_of(13) margins 0.075, 0.985, 0.15, 0.89 spacing 0.03, 0.14
do for [i = 1:5] {
    time = word('1 2 3 4 5', i)
    set title sprintf('(%s)  t = %s s', word('a b c d e', i), time) font size_of(12) offset 0, -0.6
    set xlabel i > 2 ? 'x  [m]' : ''
    set ylabel (i == 1 || i == 4) ? 'y  [m]' : ''
    plot data index time . ' s computed' using 1:2:3 with lines lw 1.6 lc palette, \
         data index time . ' s exact' using 1:2 with lines lw 0.9 dt (4, 4) lc rgb BLACK, \
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
set key on at graph 0.9, 0.75 samplen 3 spacing 1.6
set label 1 "numbers: temperature, °C" at graph 0.07, 0.36 font size_of(11)
plot NaN with lines lw 1.6 lc rgb BLUE title sprintf('SO-SSPH, dx = %s m', option('dx')), \
     NaN with lines lw 0.9 dt (4, 4) lc rgb BLACK title 'exact'
unset multiplot
