# SPDX-License-Identifier: Apache-2.0
"""The results of peers.py as a page of HTML that stands alone, and as Markdown."""
import base64
import html
import math
import platform
import statistics
import struct
import subprocess
import zlib
from pathlib import Path

import compare
import measure

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; font-size: 14px; } .scroll { overflow-x: auto; }
th, td { padding: .25rem .7rem; text-align: right; border-bottom: 1px solid #ddd; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } small { color: #777; }
.pictures { display: flex; flex-wrap: wrap; gap: .8rem; } figure { margin: 0; }
img { display: block; width: 15rem; }"""

HEADS_EQUAL = ("renderer", "CPU s", "million samples per CPU s", "mean squared error", "CPU s to RMSE {rmse}",
               "start, CPU s", "MB")
HEADS_USUAL = ("renderer", "samples", "CPU s", "mean squared error", "CPU s to RMSE {rmse}")
HEADS_AGREEMENT = ("renderer", "mean, of ours", "tile that differs most", "")


def spread(values, form):
    """(median, lower and upper quartile) as text."""
    low, middle, high = measure.quartiles(values)
    return form.format(middle), f"[{form.format(low)}, {form.format(high)}]"


def work_seconds(entry, series):
    """CPU seconds of each picture without the renderer's start."""
    return [cost.cpu_seconds - entry.start() for cost in series.costs]


def rate(entry):
    """The power of the number of samples by which the error falls, from both series; 1 where that is not
    known. Never below 1, for no renderer here is worse than random numbers, nor above 2."""
    few, many = sorted((entry.equal, entry.usual), key=lambda series: series.samples)
    ratio = statistics.mean(few.errors) / max(statistics.mean(many.errors), 1e-30)
    if few.samples == many.samples or ratio <= 0:
        return 1
    return min(max(math.log(ratio) / math.log(many.samples / few.samples), 1), 2)


def seconds_to(entry, series, rmse):
    """CPU seconds to this error, start and all."""
    work = statistics.median(work_seconds(entry, series))
    error = max(statistics.mean(series.errors), 1e-30)
    return entry.start() + work * (error / rmse ** 2) ** (1 / rate(entry))


def cells(pairs):
    """A cell is (text, small text) or a text."""
    return [pair if isinstance(pair, tuple) else (pair, "") for pair in pairs]


def equal_row(result, entry, rmse):
    series = entry.equal
    millions = result.picture.width * result.picture.height * series.samples / 1e6
    return cells([entry.renderer.name, spread([cost.cpu_seconds for cost in series.costs], "{:.2f}"),
                  spread([millions / work for work in work_seconds(entry, series)], "{:.2f}"),
                  f"{statistics.mean(series.errors):.2e}", f"{seconds_to(entry, series, rmse):.1f}",
                  f"{entry.start():.2f}", f"{max(cost.megabytes for cost in series.costs):.0f}"])


def usual_row(entry, rmse):
    series = entry.usual
    return cells([entry.renderer.name, str(series.samples),
                  spread([cost.cpu_seconds for cost in series.costs], "{:.2f}"),
                  f"{statistics.mean(series.errors):.2e}", f"{seconds_to(entry, series, rmse):.1f}"])


def agreement_row(entry):
    found = entry.agreement
    return cells([entry.renderer.name, f"{found.mean_ratio:.4f}", f"{100 * found.tile_difference:.2f} %",
                  "agrees" if found.is_good() else "DIFFERS"])


def tables(result, arguments):
    """(title, heads, rows) of each table."""
    entries = [entry for entry in result.entries if entry.agreement]
    if not entries:
        return
    heads = [[head.format(rmse=arguments.rmse) for head in row] for row in (HEADS_EQUAL, HEADS_USUAL)]
    yield (f"{arguments.samples} samples a pixel, no roulette", heads[0],
           [equal_row(result, entry, arguments.rmse) for entry in entries])
    yield ("Default roulette, samples for about {:g} CPU seconds".format(arguments.seconds), heads[1],
           [usual_row(entry, arguments.rmse) for entry in entries])
    yield "Do the pictures agree?", HEADS_AGREEMENT, [agreement_row(entry) for entry in entries]


def processor_name():
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def versions(results, arguments):
    """Ours, and what each peer said of itself in its last line."""
    asked = subprocess.run([arguments.program, "--version"], text=True, stdout=subprocess.PIPE, check=False)
    said = [entry.starts[0].said.splitlines()[-1:] for entry in results[0].entries
            if not entry.failure and entry.renderer.family != "twinray"]
    return list(dict.fromkeys(asked.stdout.splitlines()[:1] + sum(said, [])))


def conditions(results, arguments):
    picture = results[0].picture
    return (f"{picture.width} x {picture.height} pixels, {arguments.depth} bounces, {arguments.threads} "
            f"thread{'s' if arguments.threads > 1 else ''}, {arguments.rounds} interleaved rounds on "
            f"{processor_name()}. {'; '.join(versions(results, arguments))}.")


def failures(result):
    return [f"{entry.renderer.name} was left out: {entry.failure.splitlines()[-1]}"
            for entry in result.entries if entry.failure]


def markdown_table(heads, rows):
    lines = [heads, ["---"] * len(heads), *([text for text, _ in row] for row in rows)]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def markdown(results, arguments):
    text = conditions(results, arguments) + "\n"
    for result in results:
        text += f"\n## {result.name}\n"
        for title, heads, rows in tables(result, arguments):
            text += f"\n**{title}**\n\n{markdown_table(heads, rows)}"
        text += "".join(f"\n{failure}\n" for failure in failures(result))
    return text


def html_table(heads, rows):
    head = "".join(f"<th>{html.escape(text)}</th>" for text in heads)
    body = "".join("<tr>" + "".join(f"<td>{html.escape(text)} <small>{html.escape(small)}</small></td>"
                                    for text, small in row) + "</tr>\n" for row in rows)
    return f'<div class="scroll"><table><tr>{head}</tr>\n{body}</table></div>\n'


def srgb(value):
    value = min(max(value, 0), 1)
    return round(255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055))


def png(pixels, width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    line = 3 * width
    rows = b"".join(b"\0" + bytes(map(srgb, pixels[line * y:line * (y + 1)])) for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def halved(pixels, width, height):
    """The picture at half its size, without an odd last row or column."""
    rows = []
    for y in range(0, height - 1, 2):
        for x in range(0, width - 1, 2):
            corners = [3 * (width * (y + dy) + x + dx) for dy in (0, 1) for dx in (0, 1)]
            rows += [sum(pixels[corner + c] for corner in corners) / 4 for c in range(3)]
    return rows, width // 2, height // 2


def strip(result):
    """A PNG of one picture of each family, side by side at half their size; None without a peer."""
    first = {entry.renderer.family: entry for entry in reversed(result.entries) if entry.agreement}
    if not first:
        return None
    parts = [halved(entry.equal.pictures[0], result.picture.width, result.picture.height)
             for entry in reversed(first.values())]
    _, width, height = parts[0]
    rows = [pixels[3 * width * y:3 * width * (y + 1)] for y in range(height) for pixels, _, _ in parts]
    return png(sum(rows, []), width * len(parts), height)


def figure(entry, picture):
    small = halved(entry.equal.pictures[0], picture.width, picture.height)
    data = base64.b64encode(png(*small)).decode()
    name = html.escape(entry.renderer.name)
    return (f'<figure><img alt="{name}" src="data:image/png;base64,{data}"><figcaption>{name}</figcaption>'
            "</figure>\n")


def html_scene(result, arguments):
    text = f"<h2>{html.escape(result.name)}</h2>\n"
    for title, heads, rows in tables(result, arguments):
        text += f"<h3>{html.escape(title)}</h3>\n{html_table(heads, rows)}"
    text += (f"<p>{100 * (1 - result.kept):.1f} % of the pixels see a light or lie beside one that does, "
             "and are left out.</p>\n")
    text += "".join(f"<p>{html.escape(failure)}</p>\n" for failure in failures(result))
    shown = [entry for entry in result.entries if entry.agreement]
    return text + f'<div class="pictures">{"".join(figure(entry, result.picture) for entry in shown)}</div>\n'


def html_page(results, arguments):
    body = "".join(html_scene(result, arguments) for result in results)
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f"<title>twinray beside the peers</title>\n"
            f'<meta name="viewport" content="width=device-width"><style>{STYLE}</style></head><body>\n'
            f"<h1>twinray beside the peers</h1>\n<p>{html.escape(conditions(results, arguments))}</p>\n{body}"
            f"<p>Medians with quartiles. Tiles: {compare.TILES[0]} x {compare.TILES[1]}.</p></body></html>\n")
