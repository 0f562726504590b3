#!/bin/sh
# For maintainers: renew the copy of MathJax that the book ships, then commit it. Building the book needs neither npm nor a network.
# What it keeps (3.9 MB): the combined component, the TeX extensions, the font, the licence and a list of checksums.
set -eu
version=${1:-4.1.3}
destination=$(cd "$(dirname "$0")" && pwd)/mathjax
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cd "$work"
npm pack --silent "mathjax@$version" "@mathjax/mathjax-newcm-font@$version" >/dev/null
mkdir core font
tar xzf "mathjax-$version.tgz" -C core
tar xzf "mathjax-mathjax-newcm-font-$version.tgz" -C font

rm -rf "$destination"
mkdir -p "$destination/input/tex" "$destination/fonts/mathjax-newcm-font"
cp core/package/tex-chtml.js core/package/LICENSE "$destination/"
cp -r core/package/input/tex/extensions "$destination/input/tex/"
cp -r font/package/chtml font/package/chtml.js "$destination/fonts/mathjax-newcm-font/"

cd "$destination"
find . -type f ! -name SHA256SUMS | LC_ALL=C sort | xargs sha256sum >SHA256SUMS
echo "MathJax $version: $(wc -l <SHA256SUMS) files, $(du -sh . | cut -f1)"
