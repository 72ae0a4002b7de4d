#!/bin/sh
# laplacianfoam.sh CASE OUT: OpenFOAM's laplacianFoam, BDF2 in time.  All that the case does not tell, `heatladder
# reference` does, at the centres of cells and of faces on the sides; $HEATLADDER is that program.  It knows one
# material and no source; where k differs along y, y is stretched to make it one; its time is counted in steps.
set -eu
foam=$2.foam WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
export WM_PROJECT_DIR
grep -q '^materials = 1$' "$1" && grep -q '^source = no$' "$1" || exit 77
! grep -q '^shape\|= periodic' "$1" || exit 77
case $(grep '^dim' "$1") in *1) more= ;; *) more=,k_y,wall_y ;; esac
mkdir -p "$foam/system" "$foam/constant" "$foam/0"
awk -F ' = |, ' 'function tell(x, y) { print x "," y "," hx "," hy }
    { u[$1] = $2; v[$1] = $3 }
    END { n = u["cells"]; m = u["dim"] == 2 ? v["cells"] : 1; x0 = u["lo"]; x1 = u["hi"]; hx = (x1 - x0) / n
        y0 = v["lo"] + 0; y1 = u["dim"] == 2 ? v["hi"] : hx; hy = (y1 - y0) / m; print "x,y,dx,dy"
        for (j = 0; j < m; j++) for (i = 0; i < n; i++) tell(x0 + (i + 0.5) * hx, y0 + (j + 0.5) * hy)
        for (s = 0; s < 2; s++) for (j = 0; j < m; j++) tell(s ? x1 : x0, y0 + (j + 0.5) * hy)
        for (s = 0; s < 2; s++) for (i = 0; i < n; i++) tell(x0 + (i + 0.5) * hx, s ? y1 : y0)
        print n, m, x0, x1, hx, y0, y1, hy, u["dim"], u["t_end"] >"/dev/stderr" }' OFMT=%.17g CONVFMT=%.17g "$1" \
    >"$foam/points" 2>"$foam/shape"
# shellcheck disable=SC2046 # words
"${HEATLADDER:-heatladder}" reference $(sed -n 's/^oracle = //p' "$1") --points "$foam/points" \
    --what initial_heat,rho_c,k_x,wall_x$more >"$foam/told"
cd "$foam"
awk -F, -v shape="$(cat shape)" 'function head(file, class) {
        print "FoamFile { version 2.0; format ascii; class " class "; object any; }" >file }
    function side(p, k, kind, value, b, h, scale) { # type mixed: fraction f of a value, 1 - f of a slope
        T[p] = T[p] " " value; slope[p] = slope[p] " " (kind == 2 ? value / k / scale : 0); size[p]++
        f[p] = f[p] " " (kind == 3 ? b / (b + 2 * k / h) : kind == 1) }
    BEGIN { split(shape, w, " "); n = w[1]; m = w[2]; dim = w[9]; split("xlo xhi ylo yhi", name, " ")
        split("(0 4 7 3) (2 6 5 1) (1 5 4 0) (3 7 6 2)", face, /\) ?/) }
    NR == 2 { rho_c = $(dim + 2); k = $(dim + 3); k_y = dim == 2 ? $(dim + 7) : k; s = sqrt(k / k_y)
        steps = 8 * w[10] * (k / w[5] ^ 2 + (dim == 2) * k_y / w[8] ^ 2) / rho_c; steps = int(steps) + 1 }
    NR > 1 && NR <= 1 + n * m { start = start " " $(dim + 1); next }
    NR > 1 { c = NR - 1 - n * m; if (c <= 2 * m) side(1 + (c > m), k, $(dim + 4), $(dim + 5), $(dim + 6), w[5], 1)
        else if (dim == 2) side(3 + (c > 2 * m + n), k_y, $(dim + 8), $(dim + 9), $(dim + 10), w[8], s) }
    function list(key, p, of) { return key " nonuniform List<scalar> " size[p] " (" of[p] "); " }
    END { head("0/T", "volScalarField"); head("system/blockMeshDict", "dictionary")
        print "dimensions [0 0 0 1 0 0 0]; internalField nonuniform List<scalar> " n * m " (" start ");" >"0/T"
        print "boundaryField { defaultFaces { type empty; }" >"0/T"
        for (p = 1; p <= 2 * dim; p++) { print name[p] " { type mixed; " list("refValue", p, T) >"0/T"
            print list("refGradient", p, slope) list("valueFraction", p, f) "}" >"0/T"
            patches = patches name[p] " { type patch; faces (" face[p] ")); } " }
        print "}" >"0/T"; for (z = 0; z < 2; z++) for (c = 0; c < 4; c++)
            corners = corners "(" w[c % 3 ? 4 : 3] " " w[c > 1 ? 7 : 6] * s " " z ") "
        print "vertices (" corners "); edges (); blocks (hex (0 1 2 3 4 5 6 7) (" n, m, "1)" \
            "simpleGrading (1 1 1)); boundary (" patches ");" >"system/blockMeshDict"
        head("constant/transportProperties", "dictionary"); head("system/controlDict", "dictionary")
        print "DT DT [0 2 -1 0 0 0 0]", k / rho_c * w[10] / steps ";" >"constant/transportProperties"
        print "startFrom startTime; startTime 0; stopAt endTime; endTime " steps "; deltaT 1; writeControl" \
            " timeStep; writeInterval", steps "; writeFormat ascii; writePrecision 17;" >"system/controlDict"
        head("system/fvSchemes", "dictionary"); head("system/fvSolution", "dictionary")
        print "ddtSchemes { default backward; } laplacianSchemes { default Gauss linear corrected; } divSchemes { }" \
            "gradSchemes { default Gauss linear; } snGradSchemes { default corrected; }" >"system/fvSchemes"
        print "solvers { T { solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0; } }" >"system/fvSolution"
        print "SIMPLE { }" >"system/fvSolution"; print steps "/T" >"answer"
    }' OFMT=%.17g CONVFMT=%.17g told
blockMesh >log && laplacianFoam >>log || { tail log >&2; exit 1; }
tr '\n' ' ' <"$(cat answer)" | sed 's/.*internalField[^(]*( *//; s/ *).*//' | tr -s ' ' '\n' >T
if [ "$more" ]; then echo x,y,T; else echo x,T; fi >"$2"
cut -d, -f "1$(echo "$more" | sed 's/..*/,2/')" points | sed 1d | paste -d, - T | sed '/,$/d' >>"$2"
