# Common part of the benchmark charts: `data` is reports/out/bench/bench_SCENE.csv; file name and title end with `chart`
# and `subject`.
# A panel shows at most seven programs of one family of steppers; the others are grey.
#     X, Y: columns; bars: 'x' or 'y', the axis of the times (lowest and highest in columns 5 and 6), or ''
#     front: 'time' or 'work', the Pareto front of the last panel, or ''
name = system(sprintf("basename '%s' .csv", data)) . '_' . chart
set datafile separator comma
stats data using 3 nooutput
FRONTS = 2 # the last blocks
N = STATS_blocks - FRONTS
array FAMILY[5] = ['matched', 'exact', 'rkl2 chebyshev', 'rk2 euler', 'ftcs']
array TITLE[5] = ['matched step', 'exact in time', 'RKL2, Chebyshev', 'RK2 and Euler', 'finite differences (FTCS)']
who(i) = system(sprintf("sed -n 's/^n,.*,updates,//p' '%s' | sed -n %dp", data, i + 1))
in_family(who, f) = sum [w=1:words(FAMILY[f])] (strstrt(who, word(FAMILY[f], w)) > 0)
family_of(who) = strstrt(who, 'ftcs') == 1 ? 5 : in_family(who, 1) ? 1 : in_family(who, 2) ? 2 : in_family(who, 3) ? 3 : 4
array WHO[N]
array MEMBER[N]
array RANK[N]
do for [i=1:N] {
    WHO[i] = who(i - 1)
    MEMBER[i] = family_of(WHO[i])
    RANK[i] = sum [j=1:i] (j < i && MEMBER[j] == MEMBER[i])
}
MOST = 7 # programs a panel: as many as there are colours
members(f) = sum [j=1:N] (MEMBER[j] == f)
parts(f) = f > 5 ? front ne '' : (members(f) + MOST - 1) / MOST
per_part(f) = (members(f) + parts(f) - 1) / parts(f)
panels = sum [f=1:6] parts(f)
wide = 1080; high = 134 + 500 * ((panels + 2) / 3)
load 'reports/figure/style.gp'
unset title
unset bmargin
unset label 99
FRONT = front eq 'time' ? N : N + 1 # its block
array SHOWN[MOST]
STYLE = bars eq 'y' ? 'yerrorbars' : 'xerrorbars'
LOW = bars eq '' ? X : 5; HIGH = bars eq '' ? X : 6
array COLOUR[7] = [BLUE, RED, GREEN, ORANGE, PURPLE, SKY, BLACK]
array POINT[7] = [7, 5, 9, 11, 13, 6, 4]
set logscale xy
set format xy '10^{%T}'
set autoscale fix
set offsets graph 0.04, graph 0.04, graph 0.05, graph 0.05
set label 98 heading[1:strstrt(heading, ':')].' '.subject at screen 0.5, screen 1 - 27.0 / high center noenhanced font size_of(13)
set label 99 caption at screen 0.012, screen 21.0 / high left noenhanced font size_of(8.5) textcolor rgb '#555555'
set multiplot layout (panels + 2) / 3,3 margins screen 0.082, 0.985, 217.0 / high, 1 - 74.0 / high \
    spacing screen 0.066, 233.0 / high
panel = 0
do for [f=1:6] { do for [part=0:parts(f)-1] {
    panel = panel + 1
    n = 0
    do for [i=1:N] { if (MEMBER[i] == f && RANK[i] / per_part(f) == part) { n = n + 1; SHOWN[n] = i } }
    set xlabel across offset 0, 0.5
    set ylabel (panel % 3 == 1 ? along : '') offset 0.5
    set title (f > 5 ? 'Pareto front' : part ? TITLE[f].', continued' : TITLE[f]) noenhanced font size_of(11) offset 0, -0.6
    set key at graph 0, graph -0.2 left top Left reverse samplen 1.5 spacing 1.05
    eval sprintf("set key font '%s'", size_of(8.25))
    plot data index 0:(N-1) using X:Y with lines lc rgb '#d6d6d6' lw 0.8 notitle, \
         for [j=1:n] data index SHOWN[j]-1 using X:Y:LOW:HIGH with @STYLE lc rgb COLOUR[j] lw 0.8 pt 0 notitle, \
         for [j=1:n] data index SHOWN[j]-1 using X:Y with linespoints lc rgb COLOUR[j] lw 1.2 pt POINT[j] ps 0.8 * P \
             title WHO[SHOWN[j]], \
         for [i=FRONT:(f == 6 ? FRONT : FRONT-1)] data index i using X:Y with linespoints lc rgb BLACK lw 2.2 pt 7 ps 0.6 * P notitle
    unset label 98
    unset label 99
} }
unset multiplot
