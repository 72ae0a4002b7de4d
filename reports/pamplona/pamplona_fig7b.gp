# Pamplona 2019, Figure 7b
name = 'pamplona_fig7b'
high = 620
keys = 8
load 'reports/figure/style.gp'
set xrange [0.0038:0.0103]
set yrange [0.9:2.5]
set xlabel 'h  [m]'
set ylabel 'ξ  [m]' offset 1
set key vertical maxrows 8
plot data index 'moment' using 1:2 with lines lc rgb BLACK lw 1.3 dt 1 title 'lattice moment × ((n+4)/n)²', \
     data index 'lag' using 1:2 with lines lc rgb GREY lw 1.3 dt 2 title 'and × ((n+1)/n)², the lag of fixed ghosts', \
     data index 'published' using 1:2 with lines lc rgb ORANGE lw 1.6 dt 4 title '9 h^{1/3} (published fit)' enhanced, \
     data index 'printed' using 1:2 with points pt 6 ps 1.8 * P lw 1.6 lc rgb BLACK title 'printed: ξ = 1.643 m', \
     data index 'steel' using 1:2 with points ls 3 title 'best ξ, steel, cubic kernel', \
     data index 'vanadium' using 1:2 with points ls 4 pt 8 ps 1.3 * P title 'best ξ, vanadium', \
     data index 'titanium' using 1:2 with points ls 2 title 'best ξ, titanium', \
     data index 'quartic' using 1:2 with points pt 4 ps 1.2 * P lc rgb GREY title 'best ξ, steel, quartic kernel'
