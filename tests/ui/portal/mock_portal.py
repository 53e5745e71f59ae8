#!/usr/bin/env python3
"""mock_portal.py HOW: a portal of dialogs of files that answers by itself.

HOW: open (chooses "a b.glb" in the folder that is asked for), save (that folder and the name asked for), cancel,
error (refuses the call), other (ends the dialog in another way), silent (never says that it took the question),
dies (takes it and ends), waits (takes it, and says when it is closed), odd (an address of no file). What it was asked
is printed, a line each, behind the line "ready".
"""

import sys
from urllib.parse import quote

import dbus
import dbus.service
from dbus.mainloop.glib import DBusGMainLoop
from gi.repository import GLib

HOW = sys.argv[1]
PORTAL = "/org/freedesktop/portal/desktop"


def say(text):
    print(text, flush=True)


class Request(dbus.service.Object):
    @dbus.service.signal("org.freedesktop.portal.Request", signature="ua{sv}")
    def Response(self, code, results):
        pass

    @dbus.service.method("org.freedesktop.portal.Request", in_signature="", out_signature="")
    def Close(self):
        say("closed")


def path_of(value):
    return bytes(value).rstrip(b"\0").decode()


class Portal(dbus.service.Object):
    def __init__(self, bus):
        super().__init__(bus, PORTAL)
        self.bus = bus

    def asked(self, kind, sender, parent, title, options, reply, fail):
        folder = path_of(options.get("current_folder", b""))
        say(f"{kind}|{parent}|{title}|{folder}|{options.get('current_name', '')}")
        for label, patterns in options.get("filters", []):
            say(f"filter|{label}|" + " ".join(pattern for _, pattern in patterns))
        if HOW == "error":
            return fail(dbus.DBusException("no", name="org.freedesktop.portal.Error.Failed"))
        if HOW == "silent":
            return None
        path = f"{PORTAL}/request/{sender[1:].replace('.', '_')}/{options['handle_token']}"
        request = Request(self.bus, path)
        reply(dbus.ObjectPath(path))
        name = options["current_name"] if kind == "SaveFile" else "a b.glb"
        address = "http://example.org/x" if HOW == "odd" else "file://" + quote(f"{folder}/{name}")
        code = {"cancel": 1, "other": 2}.get(HOW, 0)
        results = {"uris": dbus.Array([address], signature="s")} if code == 0 else {}
        if HOW == "dies":
            GLib.timeout_add(100, loop.quit)
        elif HOW != "waits":
            GLib.timeout_add(50, lambda: request.Response(dbus.UInt32(code), dbus.Dictionary(results, signature="sv")))
        return None

    @dbus.service.method("org.freedesktop.portal.FileChooser", in_signature="ssa{sv}", out_signature="o",
                         sender_keyword="sender", async_callbacks=("reply", "fail"))
    def OpenFile(self, parent, title, options, sender, reply, fail):
        self.asked("OpenFile", sender, parent, title, options, reply, fail)

    @dbus.service.method("org.freedesktop.portal.FileChooser", in_signature="ssa{sv}", out_signature="o",
                         sender_keyword="sender", async_callbacks=("reply", "fail"))
    def SaveFile(self, parent, title, options, sender, reply, fail):
        self.asked("SaveFile", sender, parent, title, options, reply, fail)


DBusGMainLoop(set_as_default=True)
session = dbus.SessionBus()
name = dbus.service.BusName("org.freedesktop.portal.Desktop", session)
portal = Portal(session)
loop = GLib.MainLoop()
say("ready")
loop.run()
