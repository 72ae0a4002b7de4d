# What the charts of a benchmark share: `data` is reports/out/bench/bench_SCENE.csv, `chart` the end of the name.
name = system(sprintf("basename '%s' .csv", data)) . '_' . chart
wide = 1120; high = 640
load 'reports/page/style.gp'
set logscale xy
set format xy '10^{%T}'
set rmargin at screen 0.70
set key at screen 0.72, screen 0.93 left top Left reverse
set offsets graph 0.03, graph 0.03, 0, 0
stats data using 3 nooutput
FRONTS = 2 # the last blocks
N = STATS_blocks - FRONTS
array COLOUR[8] = [BLACK, ORANGE, SKY, GREEN, BLUE, RED, PURPLE, GREY]
colour(i) = COLOUR[i % 8 + 1]
array POINT[7] = [7, 5, 9, 11, 13, 6, 4]
point(i) = POINT[i % 7 + 1]
dash(i) = i / 8 + 1
set title offset screen -0.12, 0
