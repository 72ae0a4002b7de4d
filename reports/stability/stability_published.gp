# Published over true limit, in one dimension and two: above 1 a run may blow up, below it steps are wasted.
name = 'stability_published'
if (!exists("out")) out = 'reports/out'
data = sprintf('%s/stability_limits.csv', out)
wide = 900
load 'reports/page/style.gp'
set title 'Song 2018, eq. 34 (SO-SSPH): the published bound over the true one' noenhanced
set xlabel 'h/dx  [-]'
set ylabel 'published / true limit  [-]'
set xrange [0.5:3]
set yrange [0.55:1.1]
set key bottom left noenhanced
set object 1 rectangle from graph 0, first 1 to graph 1, graph 1 fc rgb RED fs transparent solid 0.10 noborder behind
set label 1 'a run at the published bound blows up' at first 1.75, 1.055 noenhanced font size_of(10)
set label 2 'steps are wasted' at first 2.3, 0.965 noenhanced font size_of(10)
plot for [d = 1:2] for [k = 1:3] data index sprintf('so_ssph %s %dD', word('cubic quartic wendland', k), d) \
    using 1:($2/$3) with lines lc rgb (k == 1 ? RED : k == 2 ? BLUE : GREEN) lw 1.4 dt d \
    title sprintf('%s, %dD', word('cubic quartic wendland', k), d)
