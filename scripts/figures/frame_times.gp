# Frame time along the walk by the methods named in `methods`: the paper's Figure 6 with its three.
set xlabel 'frame'
set ylabel 'frame time [ms]'
set yrange [0:*]
plot for [m in methods] data using (only(m)):(measured('frametime_ms')) with lines lw 1.2 lc rgb color(m) title m
