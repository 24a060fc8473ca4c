"""Control-C while the library works: noted, not raised within a callback, where Python could only print it."""
import os
import signal
import threading


class Interrupts:
    """Around a call of the library in the main thread. Where the program has a handler of its own for SIGINT, that one stays."""

    def __init__(self):
        self.came = False
        self._lock = threading.Lock()
        self._ends = None

    def __enter__(self):
        is_ours = threading.current_thread() is threading.main_thread() and signal.getsignal(signal.SIGINT) is signal.default_int_handler
        if is_ours:
            # The handler below runs in the main thread alone, which may be waiting for others; a byte tells these at once.
            self._ends = os.pipe()
            for end in self._ends:
                os.set_blocking(end, False)
            self._former_end = signal.set_wakeup_fd(self._ends[1], warn_on_full_buffer=False)
            signal.signal(signal.SIGINT, self._note)
        return self

    def _note(self, *_):
        self.came = True

    def asked(self):
        """Whether Control-C was pressed; any thread may ask."""
        with self._lock:
            if self._ends and not self.came:
                try:
                    self.came = signal.SIGINT in os.read(self._ends[0], 64)
                except BlockingIOError:
                    pass
            return self.came

    def __exit__(self, *_):
        if self._ends:
            self.asked()
            signal.signal(signal.SIGINT, signal.default_int_handler)
            signal.set_wakeup_fd(self._former_end)
            for end in self._ends:
                os.close(end)
            self._ends = None
        return False
