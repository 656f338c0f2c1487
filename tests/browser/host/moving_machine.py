"""A machine whose address changes while it serves tablets: started in a network of its own, prints what was seen.

unshare --map-root-user --net python tests/browser/host/moving_machine.py STATE

In that network, which nothing outside reaches, this program may give the machine any address.
"""

import fcntl
import json
import socket
import ssl
import struct
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import httpx
from browser.conftest import CHROMIUM, PROGRAM
from playwright.sync_api import Page, expect, sync_playwright
from processes.host.served_lan import OWNER
from processes.served_demo import bodydrive

ADDRESSES = ("10.77.0.1", "10.77.0.2")
PATIENCE = 60_000  # ms
UP = 0x1
SIOCGIFFLAGS, SIOCSIFFLAGS, SIOCSIFADDR = 0x8913, 0x8914, 0x8916  # netdevice(7)


def bring_up() -> None:
    """Switch the loopback interface on; a new network has nothing else."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        asked = struct.pack("16sH14x", b"lo", 0)
        flags = struct.unpack("16sH14x", fcntl.ioctl(any_socket, SIOCGIFFLAGS, asked))[1]
        fcntl.ioctl(any_socket, SIOCSIFFLAGS, struct.pack("16sH14x", b"lo", flags | UP))


def set_address(address: str) -> None:
    """Give the machine this address, in place of the one before."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        wanted = struct.pack("16sHH4s8x", b"lo:1", socket.AF_INET, 0, socket.inet_aton(address))
        fcntl.ioctl(any_socket, SIOCSIFADDR, wanted)


def printed_until(lines: Iterator[str], address: str) -> str:
    """Return what the program prints, up to the link that begins with this address."""
    read = []
    for line in lines:
        read.append(line)
        if line.startswith(f"http://{address}"):
            break
    return "".join(read)


def seen(page: Page, address: str, root: str) -> dict[str, Any]:
    """Return what the Settings and the pages for tablets show when the machine has an address."""
    code = page.locator("img.qr")
    expect(code).to_have_attribute("alt", f"QR code of http://{address}/")
    base = f"https://{address}:8443"
    with httpx.Client(base_url=base, verify=ssl.create_default_context(cadata=root)) as tablet:
        status = tablet.get("/").status_code
    return {
        "code": code.get_attribute("src"),
        "under it": page.get_by_text(f"http://{address}/", exact=True).count(),
        "link": httpx.get(f"http://{address}/facts.json").json()["link"],
        "status": status,
    }


def main(state: str) -> None:
    bring_up()
    set_address(ADDRESSES[0])
    with bodydrive("serve", "--lan", "--state", state) as process, sync_playwright() as playwright:
        assert process.stdout is not None
        printed = [printed_until(process.stdout, ADDRESSES[0])]
        local, _, set_up_code = next(word for word in printed[0].split() if "#setup=" in word).partition("#setup=")
        root = httpx.get(f"http://{ADDRESSES[0]}/bodydrive-authority.crt").text
        browser = playwright.chromium.launch(executable_path=PROGRAM, args=CHROMIUM)
        page = browser.new_page()
        expect.set_options(timeout=PATIENCE)
        made = page.request.post(
            f"{local}api/v1/auth/setup", data={"code": set_up_code, **OWNER}, headers={"Origin": local.rstrip("/")}
        )
        assert made.ok, made.text()
        page.goto(f"{local}#/settings")
        shown = [seen(page, ADDRESSES[0], root)]
        set_address(ADDRESSES[1])
        printed.append(printed_until(process.stdout, ADDRESSES[1]))
        shown.append(seen(page, ADDRESSES[1], root))
        browser.close()
        process.terminate()
        assert process.wait(20) == 0
    sys.stdout.write(json.dumps({"printed": printed, "shown": shown}))


if __name__ == "__main__":
    main(sys.argv[1])
