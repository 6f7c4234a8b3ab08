#!/usr/bin/env bash
# Creates the pictures of examples/README.md and of the guide from target/gallery, which examples/run_all.sh fills.
# Requires rsvg-convert, pngquant and zopflipng (Debian: librsvg2-bin, pngquant, zopfli).
set -euo pipefail
cd "$(dirname "$0")/.."

# Files are smaller without dithering.
picture() { # Arguments: name, width, number of colours.
    rsvg-convert --width "$2" --background-color white "target/gallery/$1.svg" | pngquant "$3" --nofs --speed 1 -
}

for drawing in target/gallery/*.svg; do
    name=$(basename "$drawing" .svg)
    case $name in
        # Drawings without maps remain sharp at any size.
        *_against_error) cp "$drawing" examples/gallery/ ;;
        *) picture "$name" 1200 64 >"examples/gallery/$name.png" ;;
    esac
done

# In the guide a picture is embedded in the text, because the packaged crate contains no picture files.
folder=$(mktemp --directory)
trap 'rm -r "$folder"' EXIT
embed() { # Arguments: name, description, number of colours.
    picture "$1" 800 "${3:-16}" >"$folder/picture.png"
    zopflipng -y "$folder/picture.png" "$folder/smaller.png" >/dev/null
    printf '<img alt="%s" src="data:image/png;base64,%s">\n' "$2" "$(base64 --wrap=0 "$folder/smaller.png")" \
        >"src/pictures/$1.html"
}
# Embeds a drawing that no example creates.
figure() { # Arguments: name, description.
    printf '<img alt="%s" src="data:image/svg+xml;base64,%s">\n' "$2" "$(base64 --wrap=0 "docs/figures/$1.svg")" \
        >"src/pictures/$1.html"
}
mkdir -p src/pictures
embed sphere "Pressure and shear traction of a ball along x with the closed forms, and its stick and slip zones"
embed fretting_loop "Loop of force and shift of a ball, and its shear tractions at three points of the loop"
embed fretting_rig "Loop of load and shift of a cylinder under bulk stress, its tractions, and von Mises stress below it" 24
embed creep_curves "Stick and slip zones of a rolling ellipse with its tractions, and creep curves with those of CONTACT"
embed dissimilar "Pressure of an aluminium ball on steel, the shear tractions due to pressing, and a loop of force and shift" 12
embed hardness "Contact area, approach and pressure of rough steel, elastic and with a hardness" 12
embed wear_loop "Gap and pressure of a wearing ball, and the limiting shape"
figure signs "Signs of gap, approach, pressure, traction, shift and slip, with contact radius a and stick radius c"
figure which_model "Choice of a model by five questions: pressure only, rolling, coupling, number of loads and direction of the traction; with the type and the cost for each answer"
du --bytes --total src/pictures/*.html | tail -1
